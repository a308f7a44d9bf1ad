// SPDX-License-Identifier: BSD-3-Clause
// Marches through a run with its journal, its hot spots and its files.

#include "app/simulated_run.hpp"

#include <chrono>
#include <cstdio>

#include <fmt/format.h>

#include "app/failure.hpp"
#include "app/output.hpp"
#include "diagnosis/hot_spot/hot_spot_watch.hpp"
#include "input/studies/case_values.hpp"
#include "post/report/file.hpp"
#include "post/report/progress.hpp"
#include "post/run/run_journal.hpp"
#include "solver/stop_signal.hpp"
#include "solver/time_integration/march.hpp"

namespace tiretherm::app {

namespace {

using Clock = std::chrono::steady_clock;

/// Marches through the case, from where an interrupted call had come to; stops where the user asks for it, with the
/// field of that moment.
solver::MarchReport march(const solver::Problem& problem, post::RunFiles& files, diagnosis::HotSpotTracker& hot_spots,
                          post::RunJournal& journal, const RunOptions& options) {
    if (journal.is_damaged()) {
        tell_of_damage("the run begins anew");
    }
    if (journal.checkpoint() != nullptr) {
        tell_of_continuation(fmt::format("{:.6g} s of {:.6g} s are kept", journal.time() - problem.settings.start,
                                         problem.settings.end - problem.settings.start));
        journal.replay([&](const solver::Snapshot& row) { files.take(row); });
        solver::Archive archive = solver::Archive::reading(journal.follower());
        hot_spots.visit(archive);
    }
    const auto keep = [&](const solver::Checkpoint& checkpoint) {
        std::vector<double> follower;
        solver::Archive archive = solver::Archive::writing(follower);
        hot_spots.visit(archive);
        journal.keep(checkpoint, follower);
    };
    const solver::Continuation continuation{
        .from = journal.checkpoint(), .every = 1, .keep = keep, .due = [&] { return journal.due(); }};
    post::ProgressLine line(stderr, options.quiet || problem.settings.steady);
    post::Progress progress(line, problem.name, problem.settings.start, problem.settings.end);
    const auto watch = [&](const solver::Snapshot& snapshot) {
        const bool stop = solver::stop_requested();
        solver::Snapshot seen = snapshot;
        seen.field = seen.field || stop;
        files.take(seen);
        hot_spots.take(seen);
        journal.take(seen);
        progress.update(seen.time, seen.temperature);
        return !stop;
    };
    return solver::run(problem, watch, continuation);
}

/// What the files of a run follow from.
solver::Digest::Value identity_of(const RunOptions& options, const std::string& run,
                                  const std::vector<std::string>& files) {
    std::vector<std::string> arguments{"run", options.case_file, run, fmt::format("{}", options.field_interval)};
    arguments.insert(arguments.end(), options.switched.begin(), options.switched.end());
    return call_identity(files, arguments);
}

}  // namespace

post::RunRecord SimulatedRun::record(const input::Reading& reading) const {
    return {.problem = run.problem,
            .report = report,
            .history = files->history(),
            .fields = &files->fields(),
            .provenance = provenance,
            .seconds = seconds,
            .warnings = reading.warnings,
            .files = folder->homes(files->written()),
            .hot_spots = hot_spots ? &*hot_spots : nullptr,
            .run = run.name,
            .runs = reading.runs,
            .corner = run.corner,
            .laps = run.laps,
            .what_if = what_if ? &*what_if : nullptr};
}

post::PageOrigin page_origin(const input::Reading& reading, const RunOptions& options) {
    return {.kind = "run",
            .source = options.case_file,
            .files = reading.files,
            .case_values = input::case_values(options.case_file)};
}

bool simulate(SimulatedRun& it, const std::filesystem::path& directory, const input::Reading& reading,
              const std::vector<input::ChangedRuns>& changes, const RunOptions& options) {
    it.provenance = {
        .version = TIRETHERM_VERSION, .case_file = options.case_file, .case_text = post::read_text(options.case_file)};
    it.folder =
        open_output(directory, reading.files, post::RunFiles::names_in(directory), "nothing was run", options.json);
    if (!it.folder) {
        return false;
    }
    now_doing(fmt::format("simulating {} and writing to {}", options.case_file, directory.string()));
    const solver::Problem& problem = it.run.problem;
    diagnosis::HotSpotTracker tracker(options.case_file, problem, it.run.name);
    return write_output(*it.folder, post::RunFiles::names_in(directory), options.json, [&] {
        it.files.emplace(it.folder->stage(), problem, it.provenance, options.switched);
        post::RunJournal journal(*it.folder, identity_of(options, it.run.name, reading.files), problem, options.fresh);
        const Clock::time_point begin = Clock::now();
        it.seconds = journal.checkpoint() != nullptr ? journal.seconds() : 0.0;
        it.report = march(problem, *it.files, tracker, journal, options);
        it.seconds += std::chrono::duration<double>(Clock::now() - begin).count();
        it.files->finish(it.report);
        it.hot_spots = tracker.report(it.report.hottest);
        if (it.hot_spots) {
            it.files->write_hot_spots(*it.hot_spots);
        }
        if (!changes.empty() && it.report.status.ok() && reading.chosen.size() < 2) {
            it.what_if = diagnosis::what_if(changes, {&problem}, {&it.report});
        }
        it.files->write_tables(it.record(reading));
        it.page = post::run_report(it.record(reading));
        it.files->write_page(it.page, page_origin(reading, options));
    });
}

}  // namespace tiretherm::app
