// SPDX-License-Identifier: BSD-3-Clause
// Headings as loggers write them: units in round brackets, several channels of one name.
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

/// The second of two columns that are called Time is "Time (2)".
void number_duplicates(std::vector<ColumnHead>& heads);

/// "speed [km/h]", "Speed (km/h)" and "Speed (km/h) *OBD" where the round brackets have a unit that loggers write, and
/// "Speed"|"km/h"|0|300|10.
[[nodiscard]] Heading read_heading_of_logger(std::string_view text);

}  // namespace tiretherm::input
