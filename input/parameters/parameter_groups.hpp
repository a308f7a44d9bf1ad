// SPDX-License-Identifier: BSD-3-Clause
// Parameters that differ from axle to axle, side to side or corner to corner of a car.
#pragma once

#include <string>
#include <vector>

#include "input/toml/toml_table.hpp"
#include "solver/sensitivity/free_parameter.hpp"

namespace tiretherm::input {

/// A run whose parameters may differ from those of other runs.
struct RunOfParameter {
    std::string name;
    std::string corner;                        ///< empty: the case has no [[corner]]
    const solver::Problem* problem = nullptr;  ///< its own, with the values of its corner
};

/// The key `each` of a [[parameter]]: a parameter of its own for each axle, side or corner in the place of one for all.
/// @param problem of the case  @param numbers out: with their groups in the name, and their runs
/// @returns false after an error
[[nodiscard]] bool give_each_group_its_own(TomlTable& table, const solver::Problem& problem,
                                           const std::vector<RunOfParameter>& runs,
                                           std::vector<solver::FreeParameter>& numbers);

}  // namespace tiretherm::input
