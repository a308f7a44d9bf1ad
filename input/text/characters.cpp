// SPDX-License-Identifier: BSD-3-Clause
// Tells control characters and stray bytes from what may be shown.

#include "input/text/characters.hpp"

#include <algorithm>
#include <cctype>
#include <iterator>

#include "input/text/encoding.hpp"

namespace tiretherm::input {

namespace {

/// @param character in UTF-8: one of the two blocks of control characters, or one that turns the direction of the text
/// about it (U+202A to U+202E, U+2066 to U+2069), so that "exe.csv" can be made to read "vsc.exe"
bool is_control(std::string_view character) {
    const auto first = static_cast<unsigned char>(character.front());
    return first < 0x20U || first == 0x7FU ||
           (first == 0xC2U && character.size() > 1 && static_cast<unsigned char>(character[1]) < 0xA0U) ||
           (character >= "\xE2\x80\xAA" && character <= "\xE2\x80\xAE") ||
           (character >= "\xE2\x81\xA6" && character <= "\xE2\x81\xA9");
}

}  // namespace

std::vector<std::string> split_characters(std::string_view text) {
    std::vector<std::string> characters;
    for (const char byte : text) {
        // A stray byte that continues nothing counts as a character, so that columns of messages stay those that an editor
        // shows.
        const bool continues = (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U;
        if (continues && !characters.empty() && (static_cast<unsigned char>(characters.back()[0]) & 0x80U) != 0U) {
            characters.back() += byte;
        } else {
            characters.emplace_back(1, byte);
        }
    }
    return characters;
}

std::string in_small_letters(std::string_view text) {
    std::string small;
    std::ranges::transform(text, std::back_inserter(small),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return small;
}

std::string_view trim(std::string_view text) {
    const auto is_blank = [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; };
    while (!text.empty() && is_blank(text.front())) {
        text.remove_prefix(1);
    }
    while (!text.empty() && is_blank(text.back())) {
        text.remove_suffix(1);
    }
    return text;
}

std::string printable(std::string_view text) {
    std::string result;
    while (!text.empty()) {
        const std::size_t size = utf8_size(text);
        if (size == 0) {
            result += '?';
        } else {
            result += is_control(text.substr(0, size)) ? std::string(" ") : std::string(text.substr(0, size));
        }
        text.remove_prefix(std::max<std::size_t>(size, 1));
    }
    return result;
}

bool is_printable(std::string_view text) { return printable(text) == text; }

}  // namespace tiretherm::input
