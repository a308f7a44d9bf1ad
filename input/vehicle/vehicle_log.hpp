// SPDX-License-Identifier: BSD-3-Clause
// The signals of a car's log: their names and units, found among the columns of a case's files.
#pragma once

#include <span>
#include <string_view>

#include "input/laps/course_over_ground.hpp"
#include "input/measurements/driven_signals.hpp"
#include "input/toml/document.hpp"
#include "solver/digest.hpp"

namespace tiretherm::input {

struct VehicleLog;

/// A signal of a car that is no input of a tire.
struct VehicleSignal {
    std::string_view name;
    solver::SignalHistory VehicleLog::*member;
    std::string_view unit;           ///< UDUNITS; empty: any, only whether there is something counts
    std::string_view shown_unit{};   ///< the same in messages
    std::string_view logged_unit{};  ///< that loggers mostly write, as an example
    double low = 0.0;                ///< in the unit: beyond, it is an error of the unit or of the sensor
    double high = 0.0;
    std::string_view meaning;
    bool may_heat = false;  ///< it tells of the tire's heat, too: a motion that [vehicle] has used up is no news
};

/// Accelerations, yaw rate, steering, brakes, and the road's bank and slope.
[[nodiscard]] std::span<const VehicleSignal> vehicle_signals();

/// Adds their names where the case has [vehicle]: columns of its files are read like those that user effects follow.
/// @param names each once
void add_vehicle_columns(const TomlValue& document, std::vector<std::string>& names);
[[nodiscard]] bool is_vehicle_signal(std::string_view name);
/// Whether a signal does not tell how the car turns.
[[nodiscard]] bool is_along_the_car(std::string_view name);
/// Whether [vehicle] takes up all that a column of this name says.
[[nodiscard]] bool is_used_up_by_vehicle(std::string_view name);

/// What a log says of a car. A history without points is not given.
struct VehicleLog {
    solver::SignalHistory speed;                      ///< m/s
    solver::SignalHistory longitudinal_acceleration;  ///< m/s2
    solver::SignalHistory lateral_acceleration;       ///< m/s2, sign as logged
    solver::SignalHistory yaw_rate;                   ///< rad/s, sign as logged
    solver::SignalHistory steering_wheel_angle;       ///< rad, sign as logged
    solver::SignalHistory brake_pressure;             ///< any unit
    solver::SignalHistory vertical_acceleration;      ///< m/s2, as logged
    solver::SignalHistory bank;                       ///< rad, sign as logged
    solver::SignalHistory slope;                      ///< rad, positive uphill
    CourseOverGround course{};                        ///< where the car is not slow, without jumps by a whole turn
    bool speed_is_brought_back = false;               ///< [effects.input_delay] says by how much the speed is late
    std::vector<ErrorText> remarks{};                 ///< which channels say nothing, a sentence each
};

/// Where the log has a signal. @param name that vehicle_signals has
[[nodiscard]] solver::SignalHistory VehicleLog::*member_of(std::string_view name);

/// Factor from the base units of a column to those of a signal; nothing for another dimension.
[[nodiscard]] std::optional<double> factor_to(const VehicleSignal& signal, const std::string& base);

/// The course without what a receiver makes up while the car stands, and without jumps by a whole turn.
[[nodiscard]] CourseOverGround where_it_drives(CourseOverGround course, const solver::SignalHistory& speed);

/// Finds the signals among the columns of the run's file and of the logs of [drive]; the run's win. A unit of another
/// dimension and values that no car has are errors, but for single ones, which are left out with a warning; [g] of an
/// acceleration is standard gravity, not a gram. Channels to which no sensor is connected are left out with a remark; a constant
/// that alone says how the car turns stays unless another column is to be had.
/// @param place of [vehicle]  @returns nothing after an error
[[nodiscard]] std::optional<VehicleLog> find_vehicle_log(const DrivenSignals& signals, const SourceLocation& place,
                                                         InputErrors& errors);

}  // namespace tiretherm::input
