#include "solver/time_integration/run_to_end.hpp"

#include <exception>

#include <fmt/format.h>

#include "solver/stop_signal.hpp"

namespace tiretherm::solver {

Ending run_to_end(const solver::Problem& problem, const std::function<void(const solver::Snapshot&)>& watch) {
    Ending ending;
    try {
        if (const std::vector<std::string> defects = solver::defects(problem); !defects.empty()) {
            ending.failure = fmt::format("{}", fmt::join(defects, "; "));
            ending.is_numerical = true;
            return ending;
        }
        ending.report = solver::run(problem, [&](const solver::Snapshot& snapshot) {
            watch(snapshot);
            return !stop_requested();
        });
        if (!ending.report.status.ok()) {
            ending.failure = ending.report.status.message;
            ending.stopped = ending.report.status.outcome == solver::Outcome::stopped;
            ending.is_numerical = !ending.stopped;
        }
    } catch (const std::exception& error) {
        ending.failure = error.what();
    }
    return ending;
}

}  // namespace tiretherm::solver
