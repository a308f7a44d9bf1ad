// SPDX-License-Identifier: BSD-3-Clause
// In which turns a signal of a car is positive, by what else its log says of them.
#pragma once

#include <string>
#include <string_view>

#include "input/vehicle/clock_shift.hpp"
#include "input/vehicle/vehicle_settings.hpp"

namespace tiretherm::input {

/// What tells left from right beside a signal.
struct Witness {
    Told told{};             ///< to the left; empty: nothing does
    bool is_course = false;  ///< the course over ground; else the steering
    bool is_sure = false;    ///< its own sign is known
};

/// What comes of it.
struct Settled {
    TurnSign sign = TurnSign::automatic;
    double agrees = 0.0;     ///< 1: the sign that counts is that of the witness; -1: it is not
    std::string sentence{};  ///< empty: nothing is to be said
};

/// "left" or "right"; automatic is left, as in ISO 8855.
[[nodiscard]] std::string_view turns(TurnSign sign);

/// The sign of a signal: as it is stated, or else as a witness says that is sure. A statement that the witness contradicts stands,
/// with a warning.
/// @param stated automatic: not  @param r correlation of the signal as logged with the witness, far from 0
[[nodiscard]] Settled settle_sign(std::string_view name, TurnSign stated, double r, const Witness& beside);

/// What is wrong with an acceleration that goes along with another one, but is not as large.
/// @param least share of the other that is possible; twice as much is the most
[[nodiscard]] std::optional<ErrorText> wrong_size(std::string_view name, const std::vector<double>& acceleration,
                                                  const std::vector<double>& expected, std::string_view what,
                                                  double least);

}  // namespace tiretherm::input
