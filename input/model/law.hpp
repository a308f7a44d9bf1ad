// SPDX-License-Identifier: BSD-3-Clause
// Material properties as functions of temperature, and other curves that a case gives as tables.
#pragma once

#include <optional>
#include <string_view>

#include "input/toml/toml_table.hpp"
#include "physics/curve.hpp"

namespace tiretherm::input {

/// A law of temperature, in one of the forms
///     "0.25 W/mK"                                                                 a constant
///     { at = "20 degC", value = "0.29 W/mK", slope = "0.00943 W/mK/K", curvature = "0 W/mK/K2" }
///     { through = [["20 degC", "0.29 W/mK"], ["90 degC", "0.95 W/mK"]] }          a line; three points: a parabola
///     { columns = ["temperature [degC]", "conductivity [W/mK]"], rows = [[20, 0.29], [90, 0.95]] }
/// @returns the curve against kelvin; nothing when absent or wrong
[[nodiscard]] std::optional<physics::Curve> read_law(TomlTable& table, std::string_view key, const QuantitySpec& value,
                                                     Need need);

/// A measured table { columns, rows } of two columns. @returns the curve of the second against the first
[[nodiscard]] std::optional<physics::Curve> read_curve(TomlTable& table, std::string_view key,
                                                       const QuantitySpec& variable, const QuantitySpec& value);

}  // namespace tiretherm::input
