// SPDX-License-Identifier: BSD-3-Clause
// Edit distance with transpositions (optimal string alignment) for "did you mean", and help with UTF-8 text.

#include "input/text/suggestions.hpp"

#include <algorithm>
#include <cctype>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "input/text/encoding.hpp"

namespace tiretherm::input {

namespace {

char lower(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

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

std::size_t distance(std::string_view a, std::string_view b) {
    // Rows of the table of edits between the beginnings of both: this one and the two before it.
    std::vector<std::size_t> before_last;
    std::vector<std::size_t> last(b.size() + 1);
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        before_last = std::exchange(last, row);
        row.front() = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const bool same = lower(a[i - 1]) == lower(b[j - 1]);
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (same ? 0 : 1)});
            if (i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) && lower(a[i - 2]) == lower(b[j - 1])) {
                row[j] = std::min(row[j], before_last[j - 2] + 1);
            }
        }
    }
    return row.back();
}

std::string nearest(std::string_view word, const std::vector<std::string>& known) {
    constexpr std::size_t longest = 100;  // no word that somebody types is longer, and the edits cost its square
    if (word.size() > longest) {
        return {};
    }
    std::string best;
    std::size_t least = std::max<std::size_t>(1, word.size() / 3) + 1;
    for (const std::string& candidate : known) {
        if (candidate.size() > word.size() + least || word.size() > candidate.size() + least) {
            continue;
        }
        if (const std::size_t edits = distance(word, candidate); edits < least) {
            least = edits;
            best = candidate;
        }
    }
    return best;
}

std::string listed(const std::vector<std::string>& words) {
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i) {
        text += i == 0 ? "" : (i + 1 == words.size() ? " and " : ", ");
        text += words[i];
    }
    return text;
}

std::string suggest(std::string_view word, const std::vector<std::string>& known, std::string_view kind) {
    if (const std::string near = nearest(word, known); !near.empty()) {
        return fmt::format("did you mean `{}`?", near);
    }
    if (known.size() < 2) {
        return known.empty() || known.front().empty() ? fmt::format("there are no {}", kind)
                                                      : fmt::format("there is only `{}`", known.front());
    }
    return fmt::format("the {} are {}", kind, listed(known));
}

std::vector<std::string> split_characters(std::string_view text) {
    std::vector<std::string> characters;
    for (const char byte : text) {
        const bool continues = (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U;
        if (continues && !characters.empty() && (static_cast<unsigned char>(characters.back()[0]) & 0x80U) != 0U) {
            characters.back() += byte;
        } else {
            characters.emplace_back(1, byte);
        }
    }
    return characters;
}

std::string_view trim(std::string_view text) {
    const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; };
    while (!text.empty() && blank(text.front())) {
        text.remove_prefix(1);
    }
    while (!text.empty() && blank(text.back())) {
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
