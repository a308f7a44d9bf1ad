// SPDX-License-Identifier: BSD-3-Clause
// Accelerations that a log names by the axes of the logger.
#pragma once

#include "input/new_case/log_columns.hpp"
#include "input/vehicle/vehicle_log.hpp"

namespace tiretherm::input {

/// X is taken to be along the car and Y across it (ISO 8855), as in AccX and AccY; a logger may lie across the car. The one that follows
/// the slope of speed is along it, and the other across. Where neither does they are not used.
/// @param of_car the log's signals by the names that they go by so far
void settle_axes(Log& log, const VehicleLog& of_car);

}  // namespace tiretherm::input
