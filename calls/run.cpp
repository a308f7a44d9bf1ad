// SPDX-License-Identifier: BSD-3-Clause
// Simulates a case, of a car all its tires, and writes channels, fields and, for [[critical]]
// temperatures, the hot spots.

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "calls/calls.hpp"
#include "calls/doing.hpp"
#include "calls/output.hpp"
#include "input/runs/reader.hpp"
#include "input/studies/what_if.hpp"
#include "post/run/run_report.hpp"
#include "solver/stop_signal.hpp"
#include "solver/user_effect.hpp"

namespace tiretherm::calls {

namespace {

/// How a run ended, once its page is told.
int end_of(const SimulatedRun& it, Caller& caller) {
    if (it.report.status.ok() && solver::stop_requested() && it.hot_spots) {
        caller.note("stopped; the run is complete; the continuation for its hot spots was interrupted");
        return Exit::interrupted;
    }
    if (it.report.status.ok()) {
        return Exit::done;
    }
    caller.complain(it.report.status.message,
                    it.folder ? "the results so far are in " + it.folder->path().string() : "");
    return it.report.status.outcome == solver::Outcome::stopped ? Exit::interrupted : Exit::numerical_failure;
}

/// The page of a car in its folder, with its tables.
post::Report written_page(const std::vector<post::RunRecord>& records, const diagnosis::WhatIf* what_if,
                          post::OutputFolder& folder, const input::Reading& reading, const RunOptions& options) {
    const bool with_page = !options.switched.contains("report");
    std::vector<std::filesystem::path> files = post::write_car_tables(folder.stage(), records);
    if (with_page) {
        std::ranges::copy(post::page_files(folder.stage()), std::back_inserter(files));
    }
    files = folder.homes(files);
    for (const post::RunRecord& record : records) {
        files.insert(files.end(), record.files.begin(), record.files.end());
    }
    post::Report page = post::car_report(records, what_if, reading.warnings, files);
    if (with_page) {
        post::write_page(folder.stage(), page, page_origin(reading, options));
    }
    return page;
}

/// The tires of a car, each into a folder in `directory`, and their common page. Where one fails, the rest is not run.
int run_corners(input::Reading& reading, const std::filesystem::path& directory,
                const std::vector<input::ChangedRuns>& changes, const RunOptions& options, Caller& caller) {
    std::vector<std::string> names = post::RunFiles::names_in(directory);
    const auto folder =
        options.in_memory ? nullptr : open_output(directory, reading.files, names, "nothing was run", caller);
    if (!folder && !options.in_memory) {
        return Exit::input_error;
    }
    std::vector<std::unique_ptr<SimulatedRun>> tires;
    std::vector<post::RunRecord> records;
    for (input::RunOfCase& chosen : reading.chosen) {
        const std::string name = chosen.name;
        SimulatedRun& tire = *tires.emplace_back(new SimulatedRun{.run = std::move(chosen)});
        if (!simulate(tire, directory / name, reading, changes, options, caller)) {
            return Exit::input_error;
        }
        if (!tire.report.status.ok()) {
            caller.take(tire.page);
            return end_of(tire, caller);
        }
        records.push_back(tire.record(reading));
    }
    std::optional<diagnosis::WhatIf> what_if;
    if (!changes.empty()) {
        std::vector<const solver::Problem*> problems;
        std::vector<const solver::MarchReport*> reports;
        for (const std::unique_ptr<SimulatedRun>& tire : tires) {
            problems.push_back(&tire->run.problem);
            reports.push_back(&tire->report);
        }
        what_if = diagnosis::what_if(changes, problems, reports);
    }
    const diagnosis::WhatIf* const changed = what_if ? &*what_if : nullptr;
    if (options.in_memory) {
        caller.take(post::car_report(records, changed, reading.warnings, {}));
        return Exit::done;
    }
    post::Report page;
    const bool written =
        write_output(*folder, names, caller, [&] { page = written_page(records, changed, *folder, reading, options); });
    if (!written) {
        return Exit::input_error;
    }
    caller.take(page);
    return Exit::done;
}

/// What keeps the runs of a case from being run as the call asks for; reports it.
bool are_sound(input::Reading& reading, const RunOptions& options, Caller& caller) {
    for (input::RunOfCase& chosen : reading.chosen) {
        solver::Problem& problem = chosen.problem;
        if (options.field_interval > 0.0) {
            problem.settings.field_interval = options.field_interval;
            if (const auto excess = input::excess_of(problem, reading.limits)) {
                caller.refuse("--fields: " + excess->what, excess->remedy);
                return false;
            }
        }
        if (const std::vector<std::string> defects = solver::defects(problem); !defects.empty()) {
            caller.refuse(fmt::format("{}: {}", options.case_file, fmt::join(defects, "; ")), "nothing was run");
            return false;
        }
    }
    return true;
}

/// The changes that are asked for; reports what is wrong with them. @returns nothing after an error
std::optional<std::vector<input::ChangedRuns>> read_changes(const input::Reading& reading, const RunOptions& options,
                                                            Caller& caller) {
    std::vector<std::string> texts = options.what_if ? input::standard_changes() : std::vector<std::string>{};
    texts.insert(texts.end(), options.changes.begin(), options.changes.end());
    std::vector<input::ChangedRuns> changes;
    std::vector<input::InputError> errors;
    for (const std::string& text : texts) {
        for (input::ChangedRuns& change : input::change_runs(options.case_file, options.run, reading.chosen, text)) {
            errors.insert(errors.end(), change.errors.begin(), change.errors.end());
            changes.push_back(std::move(change));
        }
    }
    if (!errors.empty()) {
        caller.refuse(input::CaseFindings{.errors = std::move(errors)}, "nothing was run");
        return std::nullopt;
    }
    return changes;
}

/// Gives the sources of the runs their laws; reports a name that is none.
bool give_laws(const RunOptions& options, std::vector<input::RunOfCase>& runs, Caller& caller) {
    for (input::RunOfCase& run : runs) {
        for (const auto& [source, law] : options.laws) {
            if (!solver::give_law(run.problem, source, law)) {
                caller.refuse(fmt::format("the case has no [[source]] \"{}\" to give a law to", source),
                              "nothing was run");
                return false;
            }
        }
    }
    return true;
}

}  // namespace

int run(const RunOptions& options, Caller& caller) {
    input::Reading reading =
        while_reading(options.case_file, [&] { return input::read_case_run(options.case_file, options.run); });
    if (!reading.problem) {
        caller.refuse(reading, "nothing was run");
        return Exit::input_error;
    }
    if (!are_sound(reading, options, caller)) {
        return Exit::input_error;
    }
    std::optional<std::vector<input::ChangedRuns>> changes = read_changes(reading, options, caller);
    if (!changes || !give_laws(options, reading.chosen, caller)) {
        return Exit::input_error;
    }
    for (input::ChangedRuns& change : *changes) {
        if (!give_laws(options, change.runs, caller)) {
            return Exit::input_error;
        }
    }
    if (was_stopped("nothing was run", caller)) {
        return Exit::interrupted;
    }
    const std::string name = reading.problem->name;
    // What is run has its own: a second mesh of a million cells would be a fifth of all memory.
    reading.problem.reset();
    const std::string directory = !options.directory.empty() ? options.directory
                                  : options.run.empty()      ? "out/" + name
                                                             : "out/" + name + "/" + options.run;
    if (reading.chosen.size() > 1) {
        return run_corners(reading, directory, *changes, options, caller);
    }
    SimulatedRun it{.run = std::move(reading.chosen.front())};
    if (!simulate(it, directory, reading, *changes, options, caller)) {
        return Exit::input_error;
    }
    caller.take(it.page);
    return end_of(it, caller);
}

}  // namespace tiretherm::calls
