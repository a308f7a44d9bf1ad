// SPDX-License-Identifier: BSD-3-Clause
// Writes the sections of a report as HTML and its charts as JSON, which report.js draws.
#include "post/page/html_page.hpp"

#include <algorithm>
#include <cctype>
#include <sstream>

#include <fmt/format.h>

#include "input/text/characters.hpp"
#include "post/page/assets.hpp"
#include "post/page/page_origin.hpp"
#include "post/report/file.hpp"

namespace tiretherm::post {

namespace {

void replace_all(std::string& text, std::string_view from, std::string_view to) {
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) {
        text.replace(at, from.size(), to);
    }
}

/// "80 degC" with the sign of degrees; a name of the user's that has these letters in it, "log_degC.csv", stays as it is.
std::string with_degree_sign(std::string text) {
    constexpr std::string_view unit = "degC";
    if (text == unit) {
        return "°C";
    }
    const auto ends_with_value = [](std::string_view before) {
        const bool blank = before.size() > 1 && before.back() == ' ';
        const char last = blank ? before[before.size() - 2] : before.empty() ? ' ' : before.back();
        const bool in = before == "in " || before.ends_with(" in ");
        return blank ? in || (last >= '0' && last <= '9') : last == '[' || last == '(';
    };
    const auto ends_word = [](std::string_view after) {
        const std::size_t end = after.find_first_not_of(".,;:)]\"");
        return end == std::string_view::npos || after[end] == ' ' || after[end] == '/';
    };
    for (std::size_t at = 0; (at = text.find(unit, at)) != std::string::npos; ++at) {
        const std::string_view all = text;
        if (ends_with_value(all.substr(0, at)) && ends_word(all.substr(at + unit.size()))) {
            text.replace(at, unit.size(), "°C");
        }
    }
    return text;
}

/// Whether a long name may be broken behind this place, where a screen is narrow: "tan_|delta_a", "cases/|durability", but
/// neither "km/h" nor "0.57".
bool may_break(std::string_view text, std::size_t at) {
    constexpr std::size_t is_no_unit = 5;  // letters behind a stroke; an ending has fewer, too
    const std::string_view behind = text.substr(at + 1, is_no_unit);
    const bool is_word = behind.size() == is_no_unit &&
                         std::ranges::all_of(behind, [](unsigned char c) { return std::isalpha(c) != 0 || c == '_'; });
    return text[at] == '_' || ((text[at] == '.' || text[at] == '/') && is_word);
}

/// A text of the program or of the user's files as text of HTML.
std::string html(std::string_view words, bool with_breaks = false) {
    std::string out;
    const std::string text = with_degree_sign(input::printable(words));
    for (std::size_t at = 0; at < text.size(); ++at) {
        const char c = text[at];
        switch (c) {
            case '&':
                out += "&amp;";
                break;
            case '<':
                out += "&lt;";
                break;
            case '>':
                out += "&gt;";
                break;
            case '"':
                out += "&quot;";
                break;
            default:
                out += c;
        }
        out += with_breaks && may_break(text, at) ? "<wbr>" : "";
    }
    return out;
}

/// The same with places where long names may be broken.
std::string breakable(std::string_view text) { return html(text, true); }

/// "Heat budget" as the name of a place in the page: "heat-budget".
std::string anchor(std::string_view heading) {
    std::string name;
    for (const char c : heading) {
        const bool letter = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
        const bool capital = c >= 'A' && c <= 'Z';
        name += letter ? c : capital ? static_cast<char>(c - 'A' + 'a') : '-';
    }
    return name;
}

std::string table_html(const DataTable& table) {
    const PageColumns columns = page_columns(table);
    const auto side = [&](std::size_t column) { return columns.to_right[column] ? " class=\"right\"" : ""; };
    std::string text = "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"table\"><table>\n";
    if (std::ranges::any_of(columns.headings, [](const std::string& heading) { return !heading.empty(); })) {
        text += "<thead><tr>";
        for (std::size_t i = 0; i < columns.headings.size(); ++i) {
            const std::string& heading = columns.headings[i];
            text +=
                heading.empty() ? "<td></td>" : fmt::format("<th scope=\"col\"{}>{}</th>", side(i), breakable(heading));
        }
        text += "</tr></thead>\n";
    }
    text += "<tbody>\n";
    for (const DataTable::Row& row : table.rows()) {
        text += "<tr>";
        std::size_t column = 0;
        for (const Field& field : row) {
            if (field.on_page) {
                text += fmt::format("<td{}>{}</td>", side(column), breakable(field.cell.text));
                ++column;
            }
        }
        text += "</tr>\n";
    }
    return text + "</tbody></table></div>\n";
}

/// JSON within an element of the page, which nothing in it ends.
std::string json_in_page(const Value& value) {
    std::string data = input::printable(compact_json(value));
    replace_all(data, "<", "\\u003c");
    return data;
}

/// The data of the result, for another call; nothing where the page does not hold them.
std::string data_html(const Report& report, const PageOrigin& origin) {
    if (origin.case_values.empty()) {
        return "";
    }
    Value values;
    for (const auto& [key, value] : origin.case_values) {
        values.set(key, value);
    }
    return fmt::format("{}{}</script>\n", page_data_begin,
                       json_in_page({{"kind", origin.kind}, {"case", std::move(values)}, {"data", report.data}}));
}

std::string chart_html(const PageItem& item) {
    const std::string data = json_in_page(item.chart);
    return fmt::format(
        "<figure class=\"chart\" tabindex=\"0\" aria-label=\"{0}\">\n<script type=\"application/json\">{1}</script>\n"
        "<div class=\"plot\"></div>\n<figcaption><b>{0}.</b> {2}</figcaption>\n</figure>\n",
        html(item.text), data, html(item.caption));
}

std::string blocks_html(const std::vector<PageItem>& blocks, int level) {
    std::string text;
    bool in_list = false;
    for (const PageItem& block : blocks) {
        const bool is_item = block.kind == PageItem::Kind::item;
        if (is_item != in_list) {
            text += is_item ? "<ul>\n" : "</ul>\n";
            in_list = is_item;
        }
        switch (block.kind) {
            case PageItem::Kind::paragraph:
                text += fmt::format("<p>{}</p>\n", breakable(block.text));
                break;
            case PageItem::Kind::item:
                text += fmt::format("<li>{}</li>\n", breakable(block.text));
                break;
            case PageItem::Kind::line:
                text += fmt::format("<pre>{}</pre>\n", breakable(block.text));
                break;
            case PageItem::Kind::gap:
                break;
            case PageItem::Kind::table:
                text += table_html(block.table);
                break;
            case PageItem::Kind::part:
                text += fmt::format("<h{0}>{1}</h{0}>\n", level, breakable(block.text)) +
                        blocks_html(block.blocks, std::min(level + 1, 6));
                break;
            case PageItem::Kind::chart:
                text += chart_html(block);
                break;
        }
    }
    return text + (in_list ? "</ul>\n" : "");
}

/// The page of a terminal without bold letters; control characters of titles and names as blanks.
std::string plain_text(const Report& report) {
    std::string plain;
    std::istringstream lines(page_text(report, false));
    for (std::string line; std::getline(lines, line);) {
        plain += input::printable(line) + "\n";
    }
    return plain;
}

}  // namespace

std::string html_page(const Report& report, const PageOrigin& origin) {
    std::string text = fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>{} - tiretherm "
        "{}</title>\n<style>\n",
        html(report.title), html(origin.kind));
    text += assets::style();
    text += fmt::format("</style>\n</head>\n<body>\n<header>\n<h1>{}</h1>\n", breakable(report.title));
    for (const std::string& line : report.verdict) {
        text += fmt::format("<p class=\"verdict\">{}</p>\n", breakable(line));
    }
    for (const std::string& line : report.lead) {
        text += fmt::format("<p class=\"lead\">{}</p>\n", breakable(line));
    }
    std::string contents;
    std::string sections;
    const auto add = [&](const ReportSection& section) {
        if (section.blocks().empty()) {
            return;
        }
        const std::string& heading = section.heading();
        if (heading.empty()) {
            sections += "<section>\n";
        } else {
            const std::string name = anchor(heading);
            contents += fmt::format("<a href=\"#{}\">{}</a>", name, html(heading));
            sections += fmt::format("<section id=\"{}\">\n<h2>{}</h2>\n", name, breakable(heading));
        }
        sections += blocks_html(section.blocks(), 3) + "</section>\n";
    };
    for (const ReportSection& section : report.sections) {  // the appendix says the same at greater length
        const bool is_at_the_head = section.heading() == verdict_heading && !report.verdict.empty();
        if (!is_at_the_head &&
            std::ranges::find(report.appendix, section.heading(), &ReportSection::heading) == report.appendix.end()) {
            add(section);
        }
    }
    std::ranges::for_each(report.appendix, add);
    add(origin_section(origin));
    const std::string data = data_html(report, origin);
    constexpr std::size_t rest = 10000;  // characters
    text.reserve(text.size() + sections.size() + data.size() + assets::charting_library().size() +
                 assets::script().size() + rest);
    text += fmt::format("<nav aria-label=\"sections\">{}</nav>\n</header>\n<main>\n", contents);
    text.append(sections).append("</main>\n").append(data);
    text += fmt::format(
        "<footer>tiretherm {} {}{}. Charts: ctrl + wheel or + and - zoom, drag or the arrows move, 0 shows all. Drawn "
        "with Apache ECharts.</footer>\n",
        TIRETHERM_VERSION, html(origin.kind), origin.source.empty() ? "" : " of " + html(origin.source));
    text += "<script>\n";
    text += assets::charting_library();
    text += "</script>\n<script>\n";
    text += assets::script();
    text += "</script>\n</body>\n</html>\n";
    return text;
}

std::vector<std::string> page_names() { return {page_name, text_page_name}; }

std::vector<std::filesystem::path> page_files(const std::filesystem::path& folder) {
    return {folder / page_name, folder / text_page_name};
}

void write_page(const std::filesystem::path& folder, const Report& report, const PageOrigin& origin) {
    replace_file(folder / page_name, html_page(report, origin));
    replace_file(folder / text_page_name, plain_text(report));
}

}  // namespace tiretherm::post
