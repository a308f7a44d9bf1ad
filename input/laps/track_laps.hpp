// SPDX-License-Identifier: BSD-3-Clause
// Crossings of a start line by the positions of a car, and a start line where the track closes.
#pragma once

#include <optional>
#include <vector>

#include "input/loggers/log_description.hpp"

namespace tiretherm::input {

/// Where a car was. NaN where it is not known.
struct Positions {
    std::vector<double> time;       ///< [n] s
    std::vector<double> latitude;   ///< [n] degrees, north
    std::vector<double> longitude;  ///< [n] degrees, east
};

/// Times at which the car crosses the line in the direction in which it does so more often; between two samples straight. Of
/// crossings within 10 s the first counts.
/// @returns s, ascending
[[nodiscard]] std::vector<double> crossings_of(const Positions& positions, const StartLine& line);

/// How near the car comes to the line. @returns m; infinite where its way is not known
[[nodiscard]] double nearest_to(const Positions& positions, const StartLine& line);

/// A line as it is meant: some loggers write the way over the line in the place of the line. Where the car passes it along rather than across, within
/// 30 degrees, it is the line of 40 m at its middle across the car's way.
[[nodiscard]] StartLine line_across(const Positions& positions, const StartLine& line);

/// A line across the track at a place that the car passes again and again in the same direction, 40 m wide; nothing where
/// there is none: it never comes back. The place is where it is fastest: there a line is crossed squarely and never by a stop.
[[nodiscard]] std::optional<StartLine> find_start_line(const Positions& positions);

}  // namespace tiretherm::input
