// SPDX-License-Identifier: BSD-3-Clause
// Finds the known word that the user probably meant, and lists words for messages.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tiretherm::input {

/// Edits (insert, delete, replace, swap neighbours) that turn one word into another; capitals do not count.
[[nodiscard]] std::size_t distance(std::string_view a, std::string_view b);

/// The known word that was probably meant, or an empty one when none is near.
[[nodiscard]] std::string nearest(std::string_view word, const std::vector<std::string>& known);

/// "a, b and c".
[[nodiscard]] std::string listed(const std::vector<std::string>& words);

template <typename Items>
[[nodiscard]] std::vector<std::string> names_of(const Items& items) {
    std::vector<std::string> names;
    names.reserve(items.size());
    for (const auto& item : items) {
        names.emplace_back(item.name);
    }
    return names;
}

/// What to do about an unknown word: the nearest known one, or else all of them.
/// @param kind what the words are, in the plural: "keys"
[[nodiscard]] std::string suggest(std::string_view word, const std::vector<std::string>& known, std::string_view kind);

/// The characters of a UTF-8 text, one string each; a stray byte counts as a character.
[[nodiscard]] std::vector<std::string> split_characters(std::string_view text);

[[nodiscard]] std::string_view trim(std::string_view text);

/// What of a text may stand in a comment or on a terminal: one line of UTF-8, control characters as blanks, other bytes as
/// question marks.
[[nodiscard]] std::string printable(std::string_view text);
/// Whether a text is UTF-8 without control characters, so that it may be a key of a case.
[[nodiscard]] bool is_printable(std::string_view text);

}  // namespace tiretherm::input
