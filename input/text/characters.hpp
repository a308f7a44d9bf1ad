// SPDX-License-Identifier: BSD-3-Clause
// The characters of a UTF-8 text: blanks round it, and what of it may be shown.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tiretherm::input {

/// The characters of a UTF-8 text, one string each; a stray byte counts as a character.
[[nodiscard]] std::vector<std::string> split_characters(std::string_view text);

[[nodiscard]] std::string_view trim(std::string_view text);

[[nodiscard]] std::string in_small_letters(std::string_view text);

/// What of a text may stand in a comment or on a terminal: one line of UTF-8, control characters as blanks, other bytes as
/// question marks.
[[nodiscard]] std::string printable(std::string_view text);
/// Whether a text is UTF-8 without control characters, so that it may be a key of a case.
[[nodiscard]] bool is_printable(std::string_view text);

}  // namespace tiretherm::input
