// SPDX-License-Identifier: BSD-3-Clause
// Measured total of the strain-energy loss in [effects.strain_energy_loss]: a table from a drum, or a coastdown fit by
// SAE J2452.
#pragma once

#include "input/measurements/driven_signals.hpp"
#include "input/toml/toml_table.hpp"

/// The total of the strain-energy loss as a machine measured it:
///     [effects.strain_energy_loss]
///     total = "drum.csv"             # columns speed, vertical_load, inflation_pressure, air_temperature or
///                                    # bulk_temperature, and force or power: a row for each point of the full grid
///     coastdown = { alpha = -0.4, beta = 0.9, a = 0.1, b = 2e-5, c = 3e-7 }     # SAE J2452 in kPa, N, km/h
namespace tiretherm::input {

/// Reads one of them into the effect, where it is given. @returns inputs over which it was measured
[[nodiscard]] std::vector<std::string> read_measured_loss(TomlTable& table, const solver::InputSignals& inputs,
                                                          const GivenSignals& given, physics::ActiveEffect& active);

}  // namespace tiretherm::input
