// SPDX-License-Identifier: BSD-3-Clause
// Groups of sensors that one camera, array, logger or amplifier reads: [[instrument]], and those that are assumed.
#pragma once

#include <string>
#include <vector>

#include "input/measurements/experiment.hpp"
#include "input/toml/toml_table.hpp"

namespace tiretherm::input {

/// The list [[instrument]] beside the sensors of the case, with channels that need not have been measured. Reported are names
/// that no sensor has, a sensor named twice, fewer than two sensors, and an instrument's name given twice.
[[nodiscard]] std::vector<Instrument> read_instruments(TomlTable& root, const solver::Problem& problem);

/// The stated instruments with those of their channels that were measured, where these are two at least; then assumed ones
/// of channels that no stated one has: sensors of one quantity whose names differ in a number or a word for a place alone,
/// and after them sensors of surfaces with one standard deviation. A camera's channels belong to none: it is one by itself.
[[nodiscard]] std::vector<Instrument> measured_instruments(const std::vector<Instrument>& stated,
                                                           const std::vector<MeasuredRun>& runs);

}  // namespace tiretherm::input
