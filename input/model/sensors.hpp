// SPDX-License-Identifier: BSD-3-Clause
// The lists [[sensor]] and [[measured]]: what a sensor may be, and the channels that they are.
#pragma once

#include <string_view>
#include <vector>

#include "input/measurements/driven_signals.hpp"
#include "input/toml/toml_table.hpp"
#include "solver/problem.hpp"

namespace tiretherm::input {

struct SensorKind {
    std::string_view name;     ///< its key `kind`
    std::string_view meaning;  ///< of what it measures
    bool is_place = false;     ///< the temperature of a place; otherwise another quantity
};

/// All of them, places first.
[[nodiscard]] std::vector<SensorKind> sensor_kinds();

/// The channels of [[sensor]]. @param problem with its mesh, effects and inputs
[[nodiscard]] std::vector<solver::Channel> read_sensors(TomlTable& root, const solver::Problem& problem, bool has_tire,
                                                        const GivenSignals& given);

/// What a measured value of a channel must be.
[[nodiscard]] QuantitySpec value_spec(solver::Quantity quantity);
/// A standard deviation of such values: positive, a difference where it is one of temperatures.
[[nodiscard]] QuantitySpec deviation_spec(solver::Quantity quantity);

/// The numbers of [[measured]]. @param problem with all channels  @param from s: before, nothing was measured
[[nodiscard]] std::vector<solver::Measured> read_measured(TomlTable& root, const solver::Problem& problem, double from);

}  // namespace tiretherm::input
