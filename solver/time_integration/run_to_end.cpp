// SPDX-License-Identifier: BSD-3-Clause
// Checks the problem, runs it until the end or a stop signal, and turns every failure and exception into a result.

#include "solver/time_integration/run_to_end.hpp"

#include <exception>

#include <fmt/format.h>

#include "solver/stop_signal.hpp"

namespace tiretherm::solver {

RunEnd run_to_end(const solver::Problem& problem, const std::function<void(const solver::Snapshot&)>& watch) {
    RunEnd run_end;
    try {
        if (const std::vector<std::string> defects = solver::defects(problem); !defects.empty()) {
            run_end.failure = fmt::format("{}", fmt::join(defects, "; "));
            run_end.is_numerical = true;
            return run_end;
        }
        run_end.report = solver::run(problem, [&](const solver::Snapshot& snapshot) {
            watch(snapshot);
            return !stop_requested();
        });
        if (!run_end.report.status.ok()) {
            run_end.failure = run_end.report.status.message;
            run_end.stopped = run_end.report.status.outcome == solver::Outcome::stopped;
            run_end.is_numerical = !run_end.stopped;
        }
    } catch (const std::exception& error) {
        run_end.failure = error.what();
    }
    return run_end;
}

}  // namespace tiretherm::solver
