// SPDX-License-Identifier: BSD-3-Clause
// The motion of a car at the samples of its log, from what the log gives, and from what each part of it was taken.
#pragma once

#include <string>

#include "input/vehicle/vehicle_log.hpp"
#include "input/vehicle/vehicle_settings.hpp"
#include "physics/vehicle/wheel_loads.hpp"

namespace tiretherm::input {

/// The road under a car at the samples of its log.
struct Road {
    std::vector<physics::RoadPlane> planes{};  ///< [n]; empty: level
    std::vector<double> along{};               ///< [n] m/s2 of gravity against a car that goes up, beside them

    /// What a turn leaves for the tires, as an accelerometer reads it, and the reverse. @param turn [n] m/s2, V r
    [[nodiscard]] std::vector<double> for_tires(std::vector<double> turn) const;
    [[nodiscard]] std::vector<double> of_tires(std::vector<double> read) const;
    /// What the tires push for a speed that changes so. @param rate [n] m/s2
    [[nodiscard]] std::vector<double> uphill(std::vector<double> rate) const;
};

/// A car over time, as far as its road follows from it.
struct CarOnRoad {
    const std::vector<double>& time;   ///< [n] s
    const std::vector<double>& speed;  ///< [n] m/s
    const std::vector<double>& turns;  ///< [n] rad/s, positive to the left; empty: not known
};

/// From the columns bank and slope, or the constants of the case. @param said gets a sentence on the bank's sign
[[nodiscard]] Road road_of(const VehicleSettings& settings, const VehicleLog& log, const CarOnRoad& car,
                           std::vector<std::string>& said);

/// What presses a car onto its road.
struct CarOnPlane {
    const std::vector<double>& time;     ///< [n] s
    const std::vector<double>& lateral;  ///< [n] m/s2, as an accelerometer reads it
    const Road& road;
};

/// a_z, from the column vertical_acceleration, or else from the road. Where the car goes straight, the column shows whether it
/// contains gravity. @returns [n] m/s2, empty where the road is level as far as is known; nothing after an error
[[nodiscard]] std::optional<std::vector<double>> vertical_motion(const VehicleSettings& settings, const VehicleLog& log,
                                                                 const CarOnPlane& car, std::vector<std::string>& said,
                                                                 InputErrors& errors);

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
