// SPDX-License-Identifier: BSD-3-Clause
// Finds the known word that the user probably meant.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tiretherm::input {

/// Edits (insert, delete, replace, swap neighbours) that turn one word into another; capitals do not count.
[[nodiscard]] std::size_t distance(std::string_view a, std::string_view b);

/// The known word that was probably meant, or an empty one when none is near.
[[nodiscard]] std::string nearest(std::string_view word, const std::vector<std::string>& known);

/// What to do about an unknown word: the nearest known one, or else all of them.
/// @param kind what the words are, in the plural: "keys"
[[nodiscard]] std::string suggest(std::string_view word, const std::vector<std::string>& known, std::string_view kind);

}  // namespace tiretherm::input
