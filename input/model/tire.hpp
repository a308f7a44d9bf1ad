// SPDX-License-Identifier: BSD-3-Clause
// The table [tire] as it was read.
#pragma once

#include "input/measurements/driven_signals.hpp"
#include "input/toml/toml_table.hpp"
#include "solver/problem.hpp"

namespace tiretherm::input {

struct TireTable {
    bool given = false;
    bool has_density = false;  ///< in [tire], not only by a material
    physics::Tire tire{};      ///< as far as it could be read
    solver::Handling handling{};
};

[[nodiscard]] TireTable read_tire(TomlTable& root);

/// Whether the tire's laws follow the pressure, and warnings about inputs outside their range.
void settle_tire(TomlTable& root, bool has_tire, const GivenSignals& given, solver::Problem& problem);

}  // namespace tiretherm::input
