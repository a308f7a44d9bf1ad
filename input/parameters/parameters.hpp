// SPDX-License-Identifier: BSD-3-Clause
// Reads what may be fitted and how: [[parameter]], [identify] and [diagnose].
#pragma once

#include <vector>

#include "input/columns/column_kinds.hpp"
#include "input/measurements/experiment.hpp"
#include "input/parameters/parameter_groups.hpp"
#include "input/parameters/parameter_kind.hpp"

namespace tiretherm::input {

/// The list [[parameter]]: the numbers of the case that may be fitted, what is known of them and their bounds. Needs
/// a case that has been read; what is missing from one with errors is not reported a second time.
/// @param runs in their order
void read_parameters(TomlTable& root, const CaseAsRead& in, const std::vector<RunOfParameter>& runs,
                     std::vector<solver::FreeParameter>& into);

/// The table [identify]: how the noise is modelled.
void read_identify(TomlTable& root, Experiment& into);
/// [diagnose]: which effects a diagnosis may name, and which columns it may take for causes.
/// @param problem the case's, whose effects are on
/// @returns the columns as the case names them: which there are is known when all runs have been read
SignalChoice read_diagnose(TomlTable& root, const solver::Problem& problem, Experiment& into);

}  // namespace tiretherm::input
