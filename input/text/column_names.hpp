// SPDX-License-Identifier: BSD-3-Clause
// What the name and the unit of a column say of it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tiretherm::input {

/// The vocabulary of column_names.list.
namespace column_words {
#define WORDS(name, words) inline constexpr std::string_view name = words;
#include "input/text/column_names.list"
}  // namespace column_words

/// Whether a text of words with blanks between them has a word.
[[nodiscard]] bool has_word(std::string_view words, std::string_view word);

/// A name in small letters without blanks and signs: "Vertical Load" and "vertical_load" are the same.
[[nodiscard]] std::string bare_name(std::string_view name);

/// The words of a column's name in small letters, without what separates them: "BrakeTemp_FL2" is brake, temp, fl, 2.
[[nodiscard]] std::vector<std::string> words_of(std::string_view name);

/// A word of the name which says that the column was computed; empty without one.
[[nodiscard]] std::string word_of_result(std::string_view name);
/// A word of the name which says that it is a time, a counter, a distance or a coordinate; empty without one.
[[nodiscard]] std::string word_of_clock(std::string_view name);

/// Whether it is a temperature by its unit, or without a unit by its name. C and F count, which are no units of a temperature
/// but are written for one.
[[nodiscard]] bool is_temperature(std::string_view name, std::string_view unit);
/// A word which says that a temperature is one of the tire; empty without one.
[[nodiscard]] std::string word_of_tire(std::string_view name);
/// A word which says that a temperature is one of something that acts on the tire from outside (air, road, brake); empty
/// without one.
[[nodiscard]] std::string word_from_outside(std::string_view name);

}  // namespace tiretherm::input
