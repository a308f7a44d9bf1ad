// SPDX-License-Identifier: BSD-3-Clause
// Marches through a run with its journal, its hot spots and its files.

#include "calls/simulated_run.hpp"

#include <chrono>
#include <cstdio>
#include <functional>

#include <fmt/format.h>

#include "calls/doing.hpp"
#include "calls/output.hpp"
#include "diagnosis/hot_spot/hot_spot_watch.hpp"
#include "input/studies/case_values.hpp"
#include "post/report/file.hpp"
#include "post/report/progress.hpp"
#include "post/run/run_journal.hpp"
#include "solver/stop_signal.hpp"
#include "solver/time_integration/march.hpp"

namespace tiretherm::calls {

namespace {

using Clock = std::chrono::steady_clock;

using Take = std::function<void(const solver::Snapshot&)>;

/// Marches through the case; stops where the user asks for it, with the field of that moment.
solver::MarchReport march(const solver::Problem& problem, const Take& take, const solver::Continuation& continuation,
                          Caller& caller) {
    post::ProgressLine line = caller.progress_line(problem.settings.steady);
    post::Progress progress(line, problem.name, problem.settings.start, problem.settings.end);
    const auto watch = [&](const solver::Snapshot& snapshot) {
        const bool stop = solver::stop_requested();
        solver::Snapshot seen = snapshot;
        seen.field = seen.field || stop;
        take(seen);
        caller.row(seen);
        progress.update(seen.time, seen.temperature);
        return !stop;
    };
    return solver::run(problem, watch, continuation);
}

/// The same from where an interrupted call had come to.
solver::MarchReport march(const solver::Problem& problem, post::RunFiles& files, diagnosis::HotSpotTracker& hot_spots,
                          post::RunJournal& journal, Caller& caller) {
    if (journal.is_damaged()) {
        tell_of_damage("the run begins anew", caller);
    }
    if (journal.checkpoint() != nullptr) {
        tell_of_continuation(fmt::format("{:.6g} s of {:.6g} s are kept", journal.time() - problem.settings.start,
                                         problem.settings.end - problem.settings.start),
                             caller);
        journal.replay([&](const solver::Snapshot& row) {
            files.take(row);
            caller.row(row);
        });
        solver::Archive archive = solver::Archive::reading(journal.follower());
        hot_spots.visit(archive);
    }
    const auto keep = [&](const solver::Checkpoint& checkpoint) {
        std::vector<double> follower;
        solver::Archive archive = solver::Archive::writing(follower);
        hot_spots.visit(archive);
        journal.keep(checkpoint, follower);
    };
    const auto take = [&](const solver::Snapshot& row) {
        files.take(row);
        hot_spots.take(row);
        journal.take(row);
    };
    return march(problem, take,
                 {.from = journal.checkpoint(), .every = 1, .keep = keep, .due = [&] { return journal.due(); }},
                 caller);
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
            .history = files ? files->history() : rows->history,
            .fields = files ? &files->fields() : &rows->fields,
            .provenance = provenance,
            .seconds = seconds,
            .warnings = reading.warnings,
            .files = files ? folder->homes(files->written()) : std::vector<std::filesystem::path>{},
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

namespace {

/// Seconds that a function takes.
template <typename Work>
double seconds_of(const Work& work) {
    const Clock::time_point begin = Clock::now();
    work();
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// What follows from a run that is over.
void conclude(SimulatedRun& it, const diagnosis::HotSpotTracker& tracker, const input::Reading& reading,
              const std::vector<input::ChangedRuns>& changes) {
    it.hot_spots = tracker.report(it.report.hottest);
    if (!changes.empty() && it.report.status.ok() && reading.chosen.size() < 2) {
        it.what_if = diagnosis::what_if(changes, {&it.run.problem}, {&it.report});
    }
}

void simulate_in_memory(SimulatedRun& it, const input::Reading& reading, const std::vector<input::ChangedRuns>& changes,
                        const RunOptions& options, Caller& caller) {
    now_doing("simulating " + options.case_file);
    const solver::Problem& problem = it.run.problem;
    diagnosis::HotSpotTracker tracker(options.case_file, problem, it.run.name);
    KeptRows& rows = it.rows.emplace(problem);
    const auto take = [&](const solver::Snapshot& row) {
        rows.history.take(row);
        rows.fields.take(row);
        tracker.take(row);
    };
    it.seconds = seconds_of([&] { it.report = march(problem, take, solver::Continuation{}, caller); });
    if (it.report.hottest.node >= 0) {
        rows.fields.take_hottest(it.report.hottest.time, it.report.hottest_field);
    }
    conclude(it, tracker, reading, changes);
    it.page = post::run_report(it.record(reading));
}

bool simulate_into_folder(SimulatedRun& it, const std::filesystem::path& directory, const input::Reading& reading,
                          const std::vector<input::ChangedRuns>& changes, const RunOptions& options, Caller& caller) {
    it.folder = open_output(directory, reading.files, post::RunFiles::names_in(directory), "nothing was run", caller);
    if (!it.folder) {
        return false;
    }
    now_doing(fmt::format("simulating {} and writing to {}", options.case_file, directory.string()));
    const solver::Problem& problem = it.run.problem;
    diagnosis::HotSpotTracker tracker(options.case_file, problem, it.run.name);
    return write_output(*it.folder, post::RunFiles::names_in(directory), caller, [&] {
        it.files.emplace(it.folder->stage(), problem, it.provenance, options.switched);
        // What a run with another law has left cannot be told from this one's.
        const bool fresh = options.fresh || !options.laws.empty();
        post::RunJournal journal(*it.folder, identity_of(options, it.run.name, reading.files), problem, fresh);
        const double before = journal.checkpoint() != nullptr ? journal.seconds() : 0.0;
        it.seconds = before + seconds_of([&] { it.report = march(problem, *it.files, tracker, journal, caller); });
        it.files->finish(it.report);
        conclude(it, tracker, reading, changes);
        if (it.hot_spots) {
            it.files->write_hot_spots(*it.hot_spots);
        }
        it.files->write_tables(it.record(reading));
        it.page = post::run_report(it.record(reading));
        it.files->write_page(it.page, page_origin(reading, options));
    });
}

}  // namespace

bool simulate(SimulatedRun& it, const std::filesystem::path& directory, const input::Reading& reading,
              const std::vector<input::ChangedRuns>& changes, const RunOptions& options, Caller& caller) {
    it.provenance = {
        .version = TIRETHERM_VERSION, .case_file = options.case_file, .case_text = post::read_text(options.case_file)};
    caller.begin(it.run);
    if (options.in_memory) {
        simulate_in_memory(it, reading, changes, options, caller);
    } else if (!simulate_into_folder(it, directory, reading, changes, options, caller)) {
        return false;
    }
    caller.end(it);
    return true;
}

}  // namespace tiretherm::calls
