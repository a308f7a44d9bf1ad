// SPDX-License-Identifier: BSD-3-Clause
// `tiretherm run`: simulates a case, of a car all its tires, and writes channels, fields and, for [[critical]]
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
#include <CLI/CLI.hpp>

#include "app/commands.hpp"
#include "app/failure.hpp"
#include "app/messages.hpp"
#include "app/output.hpp"
#include "app/simulated_run.hpp"
#include "input/runs/reader.hpp"
#include "input/studies/what_if.hpp"
#include "post/run/run_report.hpp"
#include "solver/stop_signal.hpp"

namespace tiretherm::app {

namespace {

/// How a run ended, once its page is told.
int end_of(const SimulatedRun& it, const RunOptions& options) {
    if (it.report.status.ok() && solver::stop_requested() && it.hot_spots) {
        std::fflush(stdout);
        report_error("stopped", "the run is complete; the continuation for its hot spots was interrupted", false);
        return Exit::interrupted;
    }
    if (it.report.status.ok()) {
        return Exit::done;
    }
    if (!options.json) {
        std::fflush(stdout);
        report_error(it.report.status.message, "the results so far are in " + it.folder->path().string(), false);
    }
    return it.report.status.outcome == solver::Outcome::stopped ? Exit::interrupted : Exit::numerical_failure;
}

void tell(const post::Report& page, const RunOptions& options) {
    if (options.json || !options.quiet) {
        print_report(page, options.json);
    }
}

/// The tires of a car, each into a folder in `directory`, and their common page. Where one fails, the rest is not run.
int run_corners(input::Reading& reading, const std::filesystem::path& directory,
                const std::vector<input::ChangedRuns>& changes, const RunOptions& options) {
    std::vector<std::string> names = post::RunFiles::names_in(directory);
    const auto folder = open_output(directory, reading.files, names, "nothing was run", options.json);
    if (!folder) {
        return Exit::input_error;
    }
    std::vector<std::unique_ptr<SimulatedRun>> tires;
    std::vector<post::RunRecord> records;
    for (input::RunOfCase& chosen : reading.chosen) {
        const std::string name = chosen.name;
        SimulatedRun& tire = *tires.emplace_back(new SimulatedRun{.run = std::move(chosen)});
        if (!simulate(tire, directory / name, reading, changes, options)) {
            return Exit::input_error;
        }
        if (!tire.report.status.ok()) {
            tell(tire.page, options);
            return end_of(tire, options);
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
    post::Report page;
    const bool written = write_output(*folder, names, options.json, [&] {
        const bool with_page = !options.switched.contains("report");
        std::vector<std::filesystem::path> files = post::write_car_tables(folder->stage(), records);
        if (with_page) {
            std::ranges::copy(post::page_files(folder->stage()), std::back_inserter(files));
        }
        files = folder->homes(files);
        for (const post::RunRecord& record : records) {
            files.insert(files.end(), record.files.begin(), record.files.end());
        }
        page = post::car_report(records, what_if ? &*what_if : nullptr, reading.warnings, files);
        if (with_page) {
            post::write_page(folder->stage(), page, page_origin(reading, options));
        }
    });
    if (!written) {
        return Exit::input_error;
    }
    tell(page, options);
    return Exit::done;
}

/// What keeps the runs of a case from being run as the call asks for; reports it.
bool are_sound(input::Reading& reading, const RunOptions& options) {
    for (input::RunOfCase& chosen : reading.chosen) {
        solver::Problem& problem = chosen.problem;
        if (options.field_interval > 0.0) {
            problem.settings.field_interval = options.field_interval;
            if (const auto excess = input::excess_of(problem, reading.limits)) {
                report_error("--fields: " + excess->what, excess->remedy, options.json);
                return false;
            }
        }
        if (const std::vector<std::string> defects = solver::defects(problem); !defects.empty()) {
            report_error(fmt::format("{}: {}", options.case_file, fmt::join(defects, "; ")), "nothing was run",
                         options.json);
            return false;
        }
    }
    return true;
}

/// The changes that are asked for; reports what is wrong with them. @returns nothing after an error
std::optional<std::vector<input::ChangedRuns>> read_changes(const input::Reading& reading, const RunOptions& options) {
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
        report_errors({.errors = std::move(errors)}, "nothing was run", options.json);
        return std::nullopt;
    }
    return changes;
}

int run(const RunOptions& options) {
    solver::install_stop_handlers();
    input::Reading reading =
        while_reading(options.case_file, [&] { return input::read_case_run(options.case_file, options.run); });
    if (!reading.problem) {
        report_errors(reading, "nothing was run", options.json);
        return Exit::input_error;
    }
    if (!are_sound(reading, options)) {
        return Exit::input_error;
    }
    const std::optional<std::vector<input::ChangedRuns>> changes = read_changes(reading, options);
    if (!changes) {
        return Exit::input_error;
    }
    if (was_stopped("nothing was run", options.json)) {
        return Exit::interrupted;
    }
    const std::string name = reading.problem->name;
    // What is run has its own: a second mesh of a million cells would be a fifth of all memory.
    reading.problem.reset();
    const std::string directory = !options.directory.empty() ? options.directory
                                  : options.run.empty()      ? "out/" + name
                                                             : "out/" + name + "/" + options.run;
    if (reading.chosen.size() > 1) {
        return run_corners(reading, directory, *changes, options);
    }
    SimulatedRun it{.run = std::move(reading.chosen.front())};
    if (!simulate(it, directory, reading, *changes, options)) {
        return Exit::input_error;
    }
    tell(it.page, options);
    return end_of(it, options);
}

}  // namespace

void add_run_command(CLI::App& program, int& exit_code) {
    CLI::App* command = program.add_subcommand("run", "Simulate a case");
    const auto options = std::make_shared<RunOptions>();
    command->add_option("CASE", options->case_file, "Case file (TOML)")->required()->option_text(" ");
    command
        ->add_option("--run", options->run,
                     "Which of the case's [[run]] tables, by its name; of a car's tires RUN is all, RUN_FL one. "
                     "Default: the first")
        ->option_text("NAME");
    add_out_option(*command, options->directory,
                   "Where the files go; files of an earlier run there are replaced at the end. Default: out/<case "
                   "name>, with --run a folder of the run's name in it");
    add_seconds_option(*command, "--fields", options->field_interval,
                       "Store the field this often, whatever the case says");
    for (const post::OutputFormat* format : post::output_formats()) {
        if (format->use != post::OutputFormat::Use::always) {
            const bool wanted = format->use == post::OutputFormat::Use::on_request;
            command->add_flag_callback(
                fmt::format("--{}{}", wanted ? "" : "no-", format->name),
                [options, format] { options->switched.insert(format->name); }, format->help);
        }
    }
    command->add_flag("--no-pictures")
        ->group("");  // of calls that were written for version 0.2, which drew some itself
    command->add_flag_callback(
        "--no-report", [options] { options->switched.insert("report"); }, "No report.html and no page.txt");
    command->add_flag(
        "--what-if", options->what_if,
        "Run again with 0.1 bar, 0.5 deg of camber, 5 K of air and 5 K of road more and less, and compare");
    command
        ->add_option("--change", options->changes,
                     "The same with any value of the case: \"drive.speed=+10 km/h\", "
                     "\"effects.air_convection.lambda_h=+-10 %\", \"KEY=VALUE\"; once for each")
        ->option_text("KEY=CHANGE ...");
    add_fresh_option(*command, options->fresh);
    add_quiet_option(*command, options->quiet);
    command->add_flag("--json", options->json, "One JSON object instead of the summary");
    command->footer(
        "Files: report.html (the summary with charts, for a browser), page.txt (the summary), results.h5 (everything, "
        "SI\n"
        "units), channels.csv, field.pvd with field_*.vtu (ParaView; File > Load State > field_view.py shows them).\n"
        "Charts as pictures, the temperature field and the tread of a ring among them: tiretherm report DIR --png\n"
        "A log with laps: laps.csv (mean, maximum and end of each sensor in each lap) and heat.csv (heat of each "
        "effect,\n"
        "friction power). A case with [[corner]]: all tires of the car, each in a folder RUN_CORNER of its own, and "
        "one page\n"
        "with channels.csv, laps.csv and heat.csv of all in DIR. With [vehicle]: inputs.csv (its loads, slips and "
        "forces).\n"
        "A case with [[critical]] temperatures: where and when it passes them, what is left if it does not, in\n"
        "which further step it would, and what drives that; hot_spots.csv has the hottest places against time.\n"
        "The files appear together when the run ends; those of an earlier run stay until then. Ctrl-C ends a run "
        "early\n"
        "and keeps what it has. A run that was killed goes on when the same call is made again; what it has come to is "
        "in\n"
        "the hidden folder .tiretherm meanwhile (a checkpoint every 2 s, or TIRETHERM_CHECKPOINT_SECONDS).\n\n"
        "Exit code: 0 done, 1 an error in the call or the case, 2 the solver failed, 130 interrupted.\n\n"
        "Example:\n"
        "  tiretherm run cases/laser/one_watt.toml --out out/laser --fields 60\n"
        "  tiretherm run cases/laser/three_watts.toml --out out/three_watts");
    command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace tiretherm::app
