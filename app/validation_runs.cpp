#include "app/validation_runs.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <numeric>
#include <thread>

#include <fmt/format.h>

#include "app/stop_signal.hpp"
#include "solver/march.hpp"

namespace tiretherm::app {

namespace {

struct Ending {
    std::string failure;
    std::vector<std::string> warnings;
    double energy_closure = 0.0;
};

Ending run_one(const solver::Problem& problem, cases::Trace& trace) {
    const auto because = [&](const std::string& reason) {
        return Ending{.failure = fmt::format("{}: {}", problem.name, reason), .warnings = {}};
    };
    try {
        if (const std::vector<std::string> defects = solver::defects(problem); !defects.empty()) {
            return because(fmt::format("{}", fmt::join(defects, "; ")));
        }
        const solver::Report report = solver::run(problem, [&](const solver::Snapshot& snapshot) {
            trace.take(snapshot);
            return !stop_requested();
        });
        if (!report.status.ok()) {
            return because(report.status.message);
        }
        Ending ending{.failure = {}, .warnings = {}, .energy_closure = report.energy_closure};
        for (const std::string& warning : report.warnings) {
            ending.warnings.push_back(fmt::format("{}: {}", problem.name, warning));
        }
        return ending;
    } catch (const std::exception& error) {
        return because(error.what());
    }
}

/// The order in which runs are begun: the large ones first, so that no thread is left alone with one at the end.
std::vector<std::size_t> largest_first(const std::vector<cases::ValidationRun>& runs) {
    std::vector<std::size_t> order(runs.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return runs[a].problem.mesh.n_cells > runs[b].problem.mesh.n_cells;
    });
    return order;
}

}  // namespace

RunResults run_all(const std::vector<cases::ValidationRun>& runs, unsigned threads,
                   const std::function<void(std::size_t done)>& progress) {
    RunResults results{.traces = std::vector<cases::Trace>(runs.size()),
                       .failures = std::vector<std::string>(runs.size()),
                       .warnings = {}};
    std::vector<std::vector<std::string>> warnings(runs.size());
    const std::vector<std::size_t> order = largest_first(runs);
    std::atomic<std::size_t> next{0};
    std::mutex talk;
    std::size_t done = 0;
    const auto work = [&] {
        for (std::size_t i = next++; i < order.size(); i = next++) {
            Ending ending = run_one(runs[order[i]].problem, results.traces[order[i]]);
            results.failures[order[i]] = std::move(ending.failure);
            warnings[order[i]] = std::move(ending.warnings);
            const std::lock_guard lock(talk);
            results.energy_closure = std::max(results.energy_closure, ending.energy_closure);
            progress(++done);
        }
    };
    const std::size_t wanted = threads > 0 ? threads : std::max(1U, std::thread::hardware_concurrency());
    std::vector<std::jthread> others(std::min(wanted, std::max<std::size_t>(1, runs.size())) - 1);
    for (std::jthread& other : others) {
        other = std::jthread(work);
    }
    work();
    others.clear();
    for (const std::vector<std::string>& of_run : warnings) {
        results.warnings.insert(results.warnings.end(), of_run.begin(), of_run.end());
    }
    return results;
}

}  // namespace tiretherm::app
