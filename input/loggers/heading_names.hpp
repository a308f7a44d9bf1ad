// SPDX-License-Identifier: BSD-3-Clause
// Headings as loggers write them: units in round brackets, several channels of one name, the time under other names.
#pragma once

#include <string_view>
#include <vector>

#include "input/tables/column_reader.hpp"

namespace tiretherm::input {

/// "Speed (m/s) *gps" is "Speed *gps" in m/s.
[[nodiscard]] Heading read_round_heading(std::string_view text);

/// Adds its source to the name of each column whose name stands several times: "speed (gps)".
/// @param sources of the columns, such as "100: gps"
void distinguish(std::vector<ColumnHead>& heads, const std::vector<std::string_view>& sources);

/// Marks the column that is the time of the file where none is called `time`: Time, timestamp, or the only clock of the day.
void mark_clock(std::vector<ColumnHead>& heads);

/// A name in small letters.
[[nodiscard]] std::string in_small_letters(std::string_view name);

}  // namespace tiretherm::input
