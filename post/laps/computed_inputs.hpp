// SPDX-License-Identifier: BSD-3-Clause
// The inputs that [vehicle] computes for each tire, as a table.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "solver/problem.hpp"

namespace tiretherm::post {

inline constexpr const char* inputs_name = "inputs.csv";

/// A tire whose inputs follow from a car.
struct DrivenRun {
    std::string name;
    const solver::Problem* problem;
};

/// Loads, slips, forces and speeds that were computed, in the units in which they are shown, a row for each moment of a run's log;
/// an empty cell where a run has an input from its file. @returns nothing where nothing was computed
[[nodiscard]] std::string computed_inputs_csv(const std::vector<DrivenRun>& runs);

}  // namespace tiretherm::post
