// SPDX-License-Identifier: BSD-3-Clause
// One run of many: its report, or the reason why it has none. Never throws.
#pragma once

#include <functional>
#include <string>

#include "solver/time_integration/march.hpp"

namespace tiretherm::solver {

/// How one of many runs ended.
struct RunEnd {
    std::string failure;        ///< why it has no result; empty when it has
    bool stopped = false;       ///< because the user asked for an end; `failure` says so
    bool is_numerical = false;  ///< the failure is the solver's, and would come again
    solver::MarchReport report;
};

/// Runs a problem to its end, until the solver fails or until the user asks for an end. Never throws: what one run cannot
/// do must not end the others.
[[nodiscard]] RunEnd run_to_end(const solver::Problem& problem,
                                const std::function<void(const solver::Snapshot&)>& watch);

}  // namespace tiretherm::solver
