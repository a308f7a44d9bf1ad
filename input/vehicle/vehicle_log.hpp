// SPDX-License-Identifier: BSD-3-Clause
// The signals of a car's log: their names and units, found among the columns of a case's files.
#pragma once

#include <span>
#include <string_view>

#include "input/model/problem_builder.hpp"

namespace tiretherm::input {

/// A signal of a car that is no input of a tire.
struct VehicleSignal {
    std::string_view name;
    std::string_view unit;  ///< UDUNITS; empty: any, only whether there is something counts
    double low = 0.0;       ///< in the unit: beyond, it is an error of the unit or of the sensor
    double high = 0.0;
    std::string_view meaning;
};

/// longitudinal_acceleration, lateral_acceleration, yaw_rate, steering_wheel_angle, brake_pressure.
[[nodiscard]] std::span<const VehicleSignal> vehicle_signals();

/// Adds their names where the case has [vehicle]: columns of its files are read like those that user effects follow.
/// @param names each once
void add_vehicle_columns(const TomlValue& document, std::vector<std::string>& names);
[[nodiscard]] bool is_vehicle_signal(std::string_view name);

/// What a log says of a car. A history without points is not given.
struct VehicleLog {
    solver::SignalHistory speed;                      ///< m/s
    solver::SignalHistory longitudinal_acceleration;  ///< m/s2
    solver::SignalHistory lateral_acceleration;       ///< m/s2, sign as logged
    solver::SignalHistory yaw_rate;                   ///< rad/s, sign as logged
    solver::SignalHistory steering_wheel_angle;       ///< rad, sign as logged
    solver::SignalHistory brake_pressure;             ///< any unit
};

/// Finds the signals among the columns of the run's file and of the logs of [drive]; the run's win. A unit of another
/// dimension and values that no car has are errors, but for single ones, which are left out with a warning; [g] of an
/// acceleration is standard gravity, not a gram.
/// @param place of [vehicle]  @returns nothing after an error
[[nodiscard]] std::optional<VehicleLog> find_vehicle_log(const ProblemBuilder& builder, const SourceLocation& place,
                                                         InputErrors& errors);

}  // namespace tiretherm::input
