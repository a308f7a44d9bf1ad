// SPDX-License-Identifier: BSD-3-Clause
// The motion of a car at the samples of its log, from what the log gives, and from what each part of it was taken.
#pragma once

#include <string>

#include "input/vehicle/vehicle_log.hpp"
#include "input/vehicle/vehicle_settings.hpp"

namespace tiretherm::input {

/// How a car moved, in the axes of ISO 8855.
struct MotionHistory {
    solver::SharedSamples time;                  ///< [n] s, ascending
    std::vector<physics::VehicleMotion> motion;  ///< [n]
    std::vector<std::string> sources;            ///< from what it was taken, a sentence each
    double course_agrees = 0.0;  ///< correlation of its turns with those over ground; 0: these are not known
};

/// A digest of all that `motion_of` looks at.
[[nodiscard]] solver::Digest::Value motion_origin(const VehicleSettings& settings, const VehicleLog& log);

/// Smooths the signals of the log, turns them into the axes of the car, and takes what is missing from the others:
///     a_x = dV/dt;   a_y = V r;   r = a_y / V;   r = d(course)/dt;   r = V delta / (L + K V^2) of a steady turn
/// (Gillespie 1992, ch. 6). The course over ground also tells the signs of the others.
/// Errors are an unknown speed, no signal of a turn, a speed beyond the critical one of an oversteering car whose turn is
/// known from the steering alone, and signs that contradict each other.
[[nodiscard]] std::optional<MotionHistory> motion_of(const VehicleSettings& settings, const VehicleLog& log,
                                                     InputErrors& errors);
/// The same for a car with other numbers, of a log from which a motion has been taken. Beyond the critical speed of a car that
/// oversteers, the turn that the steering tells no longer grows.
[[nodiscard]] MotionHistory motion_again(const VehicleSettings& settings, const VehicleLog& log);

}  // namespace tiretherm::input
