// SPDX-License-Identifier: BSD-3-Clause
// Brings the histories of a log to one clock.
#pragma once

#include <vector>

#include "input/vehicle/vehicle_log.hpp"

namespace tiretherm::input {

/// The times of all samples of the car's speed, accelerations, yaw rate and steering, within those of every one of them.
/// @returns s, ascending, each once; empty where nothing is logged
[[nodiscard]] std::vector<double> clock_of(const VehicleLog& log);

/// A history at other times, straight between its points and held beyond them. @param history has points
/// @param time [n] s, ascending  @returns [n]
[[nodiscard]] std::vector<double> at_times(const solver::SignalHistory& history, const std::vector<double>& time);

}  // namespace tiretherm::input
