// SPDX-License-Identifier: BSD-3-Clause
// The direction in which a car drives, by its satellite receiver: it tells left from right without any sign of a sensor.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "solver/user_effect.hpp"

namespace tiretherm::input {

class DataFile;
class InputErrors;

inline constexpr std::string_view positions_as_source = "the positions";  ///< source of a course that no column has

/// Direction of travel at the receiver's own samples.
struct CourseOverGround {
    solver::SignalHistory course{};  ///< rad, counted to the left; without points: not known
    std::string source{};            ///< "GPS Heading", or "the positions"
    double pace = 0.0;               ///< s, in which the receiver has a new value

    /// The time over which its slope means something. @param least s
    [[nodiscard]] double window(double least) const { return std::max(least, 2.0 * pace); }
};

/// The same without jumps by a whole turn.
[[nodiscard]] solver::SignalHistory unwrapped(solver::SignalHistory course);

/// From the first column of headings that moves and does not go against the positions, or else from these. Values that are only
/// repeated are left out, as those between two of the receiver's samples are. @param time [n] s, of all rows  @param errors of the file so far, to which nothing is added
[[nodiscard]] CourseOverGround course_over_ground(const DataFile& file, const std::vector<double>& time,
                                                  const InputErrors& errors);

}  // namespace tiretherm::input
