// SPDX-License-Identifier: BSD-3-Clause
// The tires of [vehicle]: Magic Formula of a .tir file, or a cornering and a slip stiffness for each axle.
#pragma once

#include "input/vehicle/vehicle_settings.hpp"

namespace tiretherm::input {

/// Reads a number of the car.
void take(TomlTable& table, VehicleNumber number, VehicleNumbers& into, Need need = Need::optional);

/// Reads property_file, or the four stiffnesses and the friction; with neither it is the .tir of [tire].
void read_vehicle_tires(TomlTable& table, const std::optional<physics::MagicFormula>& of_tire,
                        VehicleSettings& settings);

}  // namespace tiretherm::input
