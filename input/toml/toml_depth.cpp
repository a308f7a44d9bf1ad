// SPDX-License-Identifier: BSD-3-Clause
// A scan over the text that knows strings, comments, brackets and the dots of keys, and nothing else of TOML.

#include "input/toml/toml_depth.hpp"

#include <algorithm>
#include <limits>
#include <string>

namespace tiretherm::input {

namespace {

/// Where a string that starts at `from` ends: behind its last quote, or at the end of the line or of the text.
std::size_t end_of_string(std::string_view text, std::size_t from) {
    const char quote = text[from];
    const std::string three(3, quote);
    const bool lines = text.substr(from, 3) == three;
    for (std::size_t i = from + (lines ? 3 : 1); i < text.size(); ++i) {
        if (text[i] == '\\' && quote == '"') {
            ++i;
        } else if (lines ? text.substr(i, 3) == three : text[i] == quote) {
            return i + (lines ? 3 : 1);
        } else if (!lines && text[i] == '\n') {
            return i;
        }
    }
    return text.size();
}

TextPlace place_of(std::string_view text, std::size_t at) {
    const std::string_view before = text.substr(0, at);
    const std::size_t line_start = before.rfind('\n') + 1;  // 0 in the first line
    const auto starts_character = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; };
    return {.line = static_cast<int>(std::ranges::count(before, '\n')) + 1,
            .column = static_cast<int>(std::ranges::count_if(before.substr(line_start), starts_character)) + 1};
}

struct Bracket {
    int levels;      ///< the parts of the key before it, and so its levels
    std::size_t at;  ///< in the text
};

/// Goes through a text until it is too deep.
struct Scan {
    std::vector<Bracket> open;
    std::optional<std::size_t> too_deep;  ///< start of the key or the value that goes too deep

    explicit Scan(std::string_view text, int most) {
        int levels = 0;         // of all open brackets
        int parts = 1;          // of the key that is under way; a number behind it adds one at most
        std::size_t start = 0;  // where what is under way starts
        bool started = false;
        for (std::size_t i = 0; i < text.size() && !too_deep; ++i) {
            const char c = text[i];
            if (!started && c != ' ' && c != '\t') {
                start = i;
                started = true;
            }
            const bool opens = c == '[' || c == '{';
            if (c == '.') {
                ++parts;
            } else if (opens) {
                open.push_back({parts, i});
                levels += parts;
            } else if ((c == ']' || c == '}') && !open.empty()) {
                levels -= open.back().levels;
                open.pop_back();
            }
            if (opens || c == ']' || c == '}' || c == ',' || c == '\n') {
                parts = 1;
                started = false;
            }
            if (levels + parts > most) {
                too_deep = start;
            }
            // Dots and brackets within a text are no levels.
            if (c == '"' || c == '\'') {
                i = end_of_string(text, i) - 1;
            } else if (c == '#') {
                i = std::min(text.find('\n', i), text.size()) - 1;
            }
        }
    }
};

}  // namespace

std::optional<TextPlace> first_too_deep(std::string_view text) {
    const Scan scan(text, most_levels);
    return scan.too_deep ? std::optional(place_of(text, *scan.too_deep)) : std::nullopt;
}

int line_of_open_bracket(std::string_view text) {
    const Scan scan(text, std::numeric_limits<int>::max());
    return scan.open.empty() ? 0 : place_of(text, scan.open.front().at).line;
}

}  // namespace tiretherm::input
