// SPDX-License-Identifier: BSD-3-Clause
// Words in clocks, and units that say how clocks are written.
#pragma once

#include <optional>
#include <string_view>

#include "input/clock/clock.hpp"

namespace tiretherm::input {

/// The month that an English or German word names by its first three letters, in small ones; 0 for another word.
[[nodiscard]] int month_of(std::string_view word);
/// Whether a word in small letters names an English weekday.
[[nodiscard]] bool is_weekday(std::string_view word);
/// Hours ahead of UTC by the name of a zone in small letters.
[[nodiscard]] std::optional<int> zone_of(std::string_view name);

/// What a unit says of a clock, such as "dd/mm/yyyy hh:mm" or "m:ss".
struct ClockSpelling {
    std::optional<DateOrder> order{};
    std::optional<bool> is_minutes{};  ///< whether 11:20 is minutes and seconds, not hours and minutes
};
/// @returns nothing for a unit of another kind, and for "hh:mm:ss", which leaves nothing open
[[nodiscard]] std::optional<ClockSpelling> clock_spelling(std::string_view unit);

}  // namespace tiretherm::input
