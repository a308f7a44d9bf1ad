// SPDX-License-Identifier: BSD-3-Clause
// A column of clocks as times: what one field leaves open, the whole column decides.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "input/clock/clock.hpp"
#include "input/tables/columns.hpp"

namespace tiretherm::input {

/// Times of a column of clocks.
struct ClockTimes {
    std::vector<double> seconds;          ///< [n] from the first one that could be read on; NaN of what is no clock
    std::vector<std::string> remarks{};   ///< what was decided that the reader should know, a sentence each
    std::optional<ErrorText> question{};  ///< what the column leaves open; `seconds` are then one of the readings
};

/// Past midnight a clock without a date goes on. The order of day and month is that in which there are such days, in which they
/// do not go backwards, or in which they follow one another while they are weeks apart in the others; else it is asked for.
/// The hour in which daylight saving ends or begins is put right where the clock shows it. Lines with the same time are spread, see
/// `share_out`.
/// @param form of the column, not `number`  @param heading whose unit may say how the clocks are written
/// @param spread whether lines that have one time may be spread; points of a picture have one on purpose
[[nodiscard]] ClockTimes clock_times(const std::vector<Stamp>& stamps, FieldForm form, const Heading& heading,
                                     bool spread);

/// Spreads lines that have one time because the clock counts in steps that are too coarse, evenly over the step. Two lines
/// at one time stay where the clock is fine enough to tell them apart: that is a jump.
/// @param times [n] s, changed; NaN of what is no time  @param least how many lines with one time there must be on the median
/// for any to be spread  @returns a sentence; empty: all stay
[[nodiscard]] std::string share_out(std::vector<double>& times, std::size_t least);

}  // namespace tiretherm::input
