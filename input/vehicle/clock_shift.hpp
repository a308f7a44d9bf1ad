// SPDX-License-Identifier: BSD-3-Clause
// Whether two channels of a log that tell the same thing were written by one clock.
#pragma once

#include <string>
#include <vector>

namespace tiretherm::input {

/// A part of a log in which one channel comes later than another.
struct ClockShift {
    double from = 0.0;             ///< s, in steps of the windows that were compared
    double to = 0.0;               ///< s
    double delay = 0.0;            ///< s, by which the second is late; negative: early
    double correlation = 0.0;      ///< with that shift
    double together = 0.0;         ///< without it
    std::size_t windows = 1;       ///< in which it was found
    bool all = false;              ///< no part of the log agrees without a shift, or with another one
    std::vector<double> others{};  ///< s, delays that are nearly as likely, most of them a lap apart
};

/// Looks for shifts of up to 120 s, in windows of 2 min: those with which the two agree and without which they do not.
/// Neighbouring windows that agree with one shift are one part.
/// @param time [n] s, ascending  @param first, second [n] what both tell, accelerations, m/s2
[[nodiscard]] std::vector<ClockShift> clock_shifts(const std::vector<double>& time, const std::vector<double>& first,
                                                   const std::vector<double>& second);

/// An acceleration that a log tells.
struct Told {
    std::string name;                  ///< by which signal
    std::vector<double> acceleration;  ///< [n] m/s2
};

/// What is to be said of the clocks of two that tell the same: "from about 600 s to 1200 s speed is 65.5 s late beside
/// longitudinal_acceleration ...", with a remedy; none where they agree.
/// @param time [n] s, ascending  @param may_be_turned one may have the other sign
[[nodiscard]] std::vector<std::string> clock_remarks(const std::vector<double>& time, const Told& one, Told other,
                                                     bool may_be_turned);

}  // namespace tiretherm::input
