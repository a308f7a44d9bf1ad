// SPDX-License-Identifier: BSD-3-Clause
// Finds the elements that html_page.cpp has written; nothing else is read as HTML.
#include "post/export/page_charts.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "post/report/file.hpp"

namespace tiretherm::post {

namespace {

constexpr std::size_t longest_name = 80;

/// A text of HTML as it was before html_page.cpp wrote it there.
std::string plain(std::string text) {
    constexpr std::pair<std::string_view, std::string_view> marks[]{
        {"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&amp;", "&"}};  // & last
    for (const auto& [mark, letter] : marks) {
        for (std::size_t at = 0; (at = text.find(mark, at)) != std::string::npos; at += letter.size()) {
            text.replace(at, mark.size(), letter);
        }
    }
    return text;
}

/// What stands between two marks, the first one from `from` on. @errors PageError where one of them is missing
std::string_view between(std::string_view text, std::string_view first, std::string_view last, std::size_t from = 0) {
    const std::size_t begin = text.find(first, from);
    const std::size_t end = begin == std::string_view::npos ? begin : text.find(last, begin + first.size());
    if (end == std::string_view::npos) {
        throw PageError(fmt::format("it is damaged: it lacks {} ... {}", first, last));
    }
    return text.substr(begin + first.size(), end - begin - first.size());
}

PageChart chart_of(std::string_view element) {
    const std::string_view tag = element.substr(0, element.find('>'));
    const std::string_view data = between(element, "<script type=\"application/json\">", "</script>");
    if (!nlohmann::json::accept(data)) {
        throw PageError("it is damaged: the data of a chart cannot be read");
    }
    return {.title = plain(std::string(between(tag, "aria-label=\"", "\""))), .element = std::string(element)};
}

}  // namespace

PageCharts read_page(const std::filesystem::path& page) {
    constexpr std::string_view begin = "<figure class=\"chart\"";
    constexpr std::string_view end = "</figure>";
    const std::string text = read_text(page);
    if (!text.starts_with("<!DOCTYPE html>") || text.find("<footer>tiretherm ") == std::string::npos) {
        throw PageError("it is no page of tiretherm, or it is cut off");
    }
    if (text.find("</html>") == std::string::npos) {
        throw PageError("it is cut off");
    }
    PageCharts found{.version = std::string(between(text, "<footer>tiretherm ", " ")), .charts = {}};
    // Behind the foot are the scripts, which name these elements, too.
    const std::string_view content = std::string_view(text).substr(0, text.find("<footer>tiretherm "));
    for (std::size_t at = 0; (at = content.find(begin, at)) != std::string_view::npos;) {
        const std::size_t after = content.find(end, at);
        if (after == std::string_view::npos) {
            throw PageError("it is damaged: a chart has no end");
        }
        found.charts.push_back(chart_of(content.substr(at, after + end.size() - at)));
        at = after;
    }
    const std::vector<std::string> names = picture_names(found.charts);
    for (std::size_t i = 0; i < names.size(); ++i) {
        found.charts[i].picture = names[i];
    }
    return found;
}

std::vector<std::string> picture_names(const std::vector<PageChart>& charts) {
    std::vector<std::string> names;
    for (const PageChart& chart : charts) {
        std::string name;
        for (const char c : chart.title) {
            const bool capital = c >= 'A' && c <= 'Z';
            const bool plain = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
            if (capital || plain) {
                name += capital ? static_cast<char>(c - 'A' + 'a') : c;
            } else if (!name.empty() && name.back() != '-') {
                name += '-';
            }
        }
        name.resize(std::min(name.size(), longest_name));
        while (name.ends_with('-')) {
            name.pop_back();
        }
        const std::string stem = name.empty() ? "chart" : name;
        std::string file = stem + ".png";
        for (int n = 2; std::ranges::find(names, file) != names.end(); ++n) {
            file = fmt::format("{}-{}.png", stem, n);
        }
        names.push_back(file);
    }
    return names;
}

std::string choose_charts(PageCharts& page, const std::vector<std::string>& names) {
    std::vector<std::string> wanted;
    for (const std::string& name : names) {
        const std::string title = name.ends_with(".png") ? name.substr(0, name.size() - 4) : name;
        wanted.push_back(picture_names({{.title = title, .element = {}}}).front());
        if (std::ranges::find(page.charts, wanted.back(), &PageChart::picture) == page.charts.end()) {
            return name;
        }
    }
    std::erase_if(page.charts, [&](const PageChart& chart) {
        return !wanted.empty() && std::ranges::find(wanted, chart.picture) == wanted.end();
    });
    return {};
}

}  // namespace tiretherm::post
