#include "input/text/mistake.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "input/text/words.hpp"

namespace tiretherm::input {

namespace {

constexpr std::size_t widest = 110;  // characters of a source line that are shown

/// The line and a caret under its place. A long line is cut to a window about the place.
std::string underlined(const Mistake& mistake) {
    std::vector<std::string> characters = split_characters(mistake.source);
    auto first = static_cast<std::size_t>(std::max(0, mistake.column - 1));
    if (first > characters.size()) {
        first = characters.size();
    }
    if (characters.size() > widest) {
        const std::size_t from = first > widest / 2 ? std::min(first - widest / 2, characters.size() - widest) : 0;
        const std::size_t to = from + widest;
        std::vector<std::string> window(characters.begin() + static_cast<std::ptrdiff_t>(from),
                                        characters.begin() + static_cast<std::ptrdiff_t>(to));
        if (from > 0) {
            window.insert(window.begin(), "...");
        }
        if (to < characters.size()) {
            window.emplace_back("...");
        }
        first = first - from + (from > 0 ? 1 : 0);
        characters = std::move(window);
    }
    std::string line = "    ";
    std::string caret = "    ";
    for (std::size_t i = 0; i < characters.size(); ++i) {
        line += characters[i];
        if (i < first) {
            caret += characters[i] == "\t" ? "\t" : std::string(characters[i] == "..." ? 3 : 1, ' ');
        }
    }
    const std::size_t room = characters.size() > first ? characters.size() - first : 1;
    const auto length = std::clamp<std::size_t>(static_cast<std::size_t>(std::max(1, mistake.length)), 1, room);
    return line + "\n" + caret + "^" + std::string(length - 1, '~') + "\n";
}

}  // namespace

std::string render(const Mistake& mistake) {
    std::string text = mistake.line > 0
                           ? fmt::format("{}:{}:{}: {}\n", mistake.file, mistake.line, mistake.column, mistake.what)
                           : fmt::format("{}: {}\n", mistake.file, mistake.what);
    if (mistake.line > 0 && !mistake.source.empty()) {
        text += underlined(mistake);
    }
    if (!mistake.remedy.empty()) {
        text += fmt::format("    remedy: {}\n", mistake.remedy);
    }
    return text;
}

int Mistakes::add_file(std::string shown, std::string text) {
    files_.push_back({std::move(shown), std::move(text)});
    return static_cast<int>(files_.size()) - 1;
}

void Mistakes::add(const Place& place, std::string what, std::string remedy) {
    found_.push_back({place, {std::move(what), std::move(remedy)}});
}

void Mistakes::warn(const Place& place, const std::string& what) {
    warnings_.push_back(place.file >= 0 ? fmt::format("{}: {}", spell(place), what) : what);
}

std::string Mistakes::spell(const Place& place) const {
    return place.line > 0 ? fmt::format("{}:{}", file(place.file), place.line) : file(place.file);
}

std::string Mistakes::line_of(const Place& place) const {
    const std::string& text = files_[static_cast<std::size_t>(place.file)].text;
    std::size_t start = 0;
    for (int line = 1; line < place.line; ++line) {
        start = text.find('\n', start);
        if (start == std::string::npos) {
            return {};
        }
        ++start;
    }
    std::string line = text.substr(start, text.find('\n', start) - start);
    if (!line.empty() && line.back() == '\r') {
        line.pop_back();
    }
    return line.starts_with("\xEF\xBB\xBF") ? line.substr(3) : line;
}

std::vector<Mistake> Mistakes::in_order() const {
    std::vector<const Found*> order;
    for (const Found& found : found_) {
        order.push_back(&found);
    }
    std::stable_sort(order.begin(), order.end(), [](const Found* a, const Found* b) {
        return std::tie(a->place.file, a->place.line, a->place.column) <
               std::tie(b->place.file, b->place.line, b->place.column);
    });
    std::vector<Mistake> result;
    for (const Found* found : order) {
        const Place& place = found->place;
        Mistake mistake{.file = file(place.file),
                        .line = place.line,
                        .column = place.column,
                        .length = place.length,
                        .what = found->fault.what,
                        .remedy = found->fault.remedy,
                        .source = {}};
        const auto same = [&](const Mistake& other) {
            return other.file == mistake.file && other.line == mistake.line && other.what == mistake.what;
        };
        if (std::none_of(result.begin(), result.end(), same)) {
            mistake.source = place.line > 0 ? line_of(place) : std::string();
            result.push_back(std::move(mistake));
        }
    }
    return result;
}

}  // namespace tiretherm::input
