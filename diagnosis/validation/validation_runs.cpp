// SPDX-License-Identifier: BSD-3-Clause
// Runs the cases in parallel, the largest first, and collects channels, failures and the energy closure.

#include "diagnosis/validation/validation_runs.hpp"

#include <algorithm>
#include <mutex>
#include <numeric>

#include <fmt/format.h>

#include "diagnosis/study/study_record.hpp"
#include "mesh/parallel.hpp"
#include "solver/time_integration/run_to_end.hpp"

namespace tiretherm::diagnosis {

namespace {

/// The order in which runs are begun: the large ones first, so that no thread is left alone with one at the end.
std::vector<std::size_t> largest_first(const std::vector<input::ValidationRun>& runs) {
    std::vector<std::size_t> order(runs.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return runs[a].problem.mesh.n_cells > runs[b].problem.mesh.n_cells;
    });
    return order;
}

}  // namespace

RunResults run_all(const std::vector<input::ValidationRun>& runs, unsigned threads,
                   const std::function<void(std::size_t done)>& progress) {
    RunResults results{.traces = std::vector<input::Trace>(runs.size()),
                       .failures = std::vector<std::string>(runs.size()),
                       .warnings = {}};
    std::vector<std::vector<solver::RangeWarning>> warnings(runs.size());
    const std::vector<std::size_t> order = largest_first(runs);
    std::mutex talk;
    std::size_t done = 0;
    const auto work = [&](std::size_t i) {
        const std::size_t run = order[i];
        const solver::Problem& problem = runs[run].problem;
        const solver::RunEnd run_end =
            solver::run_to_end(problem, [&](const solver::Snapshot& snapshot) { results.traces[run].take(snapshot); });
        if (!run_end.failure.empty()) {
            const std::string& changed = runs[run].changed;
            results.failures[run] =
                fmt::format("{}{}: {}", problem.name, changed.empty() ? "" : ", " + changed, run_end.failure);
        }
        const std::lock_guard lock(talk);
        if (run_end.failure.empty()) {
            warnings[run] = run_end.report.warnings;
            results.energy_closure = std::max(results.energy_closure, run_end.report.energy_closure);
        }
        progress(++done);
    };
    in_parallel(order.size(), work, threads);
    results.warnings = left_ranges(warnings);
    return results;
}

}  // namespace tiretherm::diagnosis
