// SPDX-License-Identifier: BSD-3-Clause
// A scan over the text that knows strings, comments, brackets and the dots of keys, and nothing else of TOML.

#include "input/text/toml_depth.hpp"

#include <algorithm>
#include <string>
#include <vector>

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

}  // namespace

std::optional<TextPlace> first_too_deep(std::string_view text) {
    std::vector<int> around;  // of each open bracket: the parts of the key before it, and so its levels
    int levels = 0;           // their sum
    int parts = 1;            // of the key that is under way; a number behind it adds one at most
    std::size_t start = 0;    // where what is under way starts
    bool started = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (!started && c != ' ' && c != '\t') {
            start = i;
            started = true;
        }
        const bool opens = c == '[' || c == '{';
        if (c == '.') {
            ++parts;
        } else if (opens) {
            around.push_back(parts);
            levels += parts;
        } else if ((c == ']' || c == '}') && !around.empty()) {
            levels -= around.back();
            around.pop_back();
        }
        if (opens || c == ']' || c == '}' || c == ',' || c == '\n') {
            parts = 1;
            started = false;
        }
        if (levels + parts > most_levels) {
            return place_of(text, start);
        }
        if (c == '"' || c == '\'') {
            i = end_of_string(text, i) - 1;
        } else if (c == '#') {
            i = std::min(text.find('\n', i), text.size()) - 1;
        }
    }
    return std::nullopt;
}

}  // namespace tiretherm::input
