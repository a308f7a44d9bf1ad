// SPDX-License-Identifier: BSD-3-Clause
// Runs the cases of a study in parallel, watches the hottest temperature, and stores each outcome as soon as it is
// known.

#include "diagnosis/study/study_runs.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <limits>
#include <mutex>

#include <fmt/format.h>

#include "mesh/parallel.hpp"
#include "mesh/place.hpp"
#include "solver/hot_spot_finder.hpp"
#include "solver/stop_signal.hpp"
#include "solver/time_integration/run_to_end.hpp"

namespace tiretherm::diagnosis {

namespace {

using Clock = std::chrono::steady_clock;

/// The hottest place of each part of the case that has a critical temperature, row by row.
class HottestParts {
public:
    explicit HottestParts(const input::StudyCase& of) {
        for (const solver::Critical& critical : of.critical) {
            finders_.emplace_back(of.problem.mesh, critical.nodes);
            parts.push_back({.hottest = -std::numeric_limits<double>::infinity(), .critical = critical.temperature});
        }
    }
    void take(const solver::Snapshot& snapshot) {
        for (std::size_t i = 0; i < parts.size(); ++i) {
            parts[i].hottest = std::max(parts[i].hottest, finders_[i].find(snapshot.temperature).temperature);
        }
    }

    std::vector<diagnosis::StudyOutcome::Part> parts;

private:
    std::vector<solver::HotSpotFinder> finders_;
};

diagnosis::StudyOutcome outcome_of(const solver::Problem& problem, const solver::RunEnd& run_end,
                                   std::vector<diagnosis::StudyOutcome::Part> parts) {
    const solver::MarchReport& report = run_end.report;
    if (!run_end.failure.empty()) {
        return {.failure = run_end.failure};
    }
    const solver::MarchReport::Extreme& hottest = report.hottest;
    const mesh::Place place = mesh::place_of(problem.mesh, hottest.node);
    return {.failure = {},
            .hottest = hottest.temperature,
            .hottest_time = hottest.time,
            .hottest_layer = place.layer,
            .hottest_zone = place.zone,
            .channel_final = report.channel_final,
            .channel_min = report.channel_min,
            .channel_max = report.channel_max,
            .energy_closure = report.energy_closure,
            .steps = report.steps,
            .parts = std::move(parts),
            .warnings = report.warnings};
}

}  // namespace

diagnosis::RunIdentity identity(const input::Study& study, std::size_t run) {
    diagnosis::RunIdentity identity{.fingerprint = study.runs[run].fingerprint, .values = {}};
    for (std::size_t i = 0; i < study.inputs.size(); ++i) {
        identity.values.push_back(fmt::format("{} = {}", study.inputs[i].key.text, study.value(run, i).text));
    }
    return identity;
}

StudyResults run_study(const input::Study& study, CompletedRuns& journal, unsigned threads,
                       const std::function<void(std::size_t done)>& progress, const StudyPart& part) {
    StudyResults results{.outcomes = std::vector<diagnosis::StudyOutcome>(study.runs.size()), .error = {}};
    std::vector<std::size_t> open;
    for (std::size_t run = part.index - 1; run < study.runs.size(); run += part.count) {
        const diagnosis::StudyOutcome* known = journal.find(identity(study, run));
        if (known != nullptr && (!known->ok() || known->parts.size() == study.parts.size())) {
            results.outcomes[run] = *known;
            ++results.kept;
        } else {
            open.push_back(run);
        }
    }
    results.done = results.kept;
    std::mutex talk;
    std::atomic<bool> broken{false};
    const auto work = [&](std::size_t i) {
        if (broken || solver::stop_requested()) {
            return;
        }
        const std::size_t run = open[i];
        const Clock::time_point begin = Clock::now();
        solver::RunEnd run_end;
        diagnosis::StudyOutcome outcome;
        try {
            const input::StudyCase made = study.case_of(run);
            HottestParts hottest(made);
            run_end =
                solver::run_to_end(made.problem, [&](const solver::Snapshot& snapshot) { hottest.take(snapshot); });
            outcome = outcome_of(made.problem, run_end, std::move(hottest.parts));
        } catch (const std::exception& error) {
            run_end.failure = error.what();
        }
        const std::lock_guard lock(talk);
        if (run_end.stopped || broken) {
            return;
        }
        try {
            // What is no fault of the solver's, such as memory, may be well another time: it is not kept.
            if (!run_end.failure.empty() && !run_end.is_numerical) {
                throw std::runtime_error(fmt::format("run {}: {}", run + 1, run_end.failure));
            }
            journal.add(identity(study, run), outcome);
        } catch (const std::exception& error) {
            broken = true;
            results.error = error.what();
            return;
        }
        results.outcomes[run] = outcome;
        results.run_seconds += std::chrono::duration<double>(Clock::now() - begin).count();
        progress(++results.done);
    };
    in_parallel(open.size(), work, threads);
    return results;
}

}  // namespace tiretherm::diagnosis
