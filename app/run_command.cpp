// SPDX-License-Identifier: BSD-3-Clause
// `tiretherm run`: simulates a case and writes channels, fields, pictures and, for [[critical]] temperatures, the hot
// spots.

#include <chrono>
#include <cstdio>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/commands.hpp"
#include "app/failure.hpp"
#include "app/messages.hpp"
#include "app/output.hpp"
#include "diagnosis/hot_spot/hot_spot_watch.hpp"
#include "input/model/reader.hpp"
#include "post/report/file.hpp"
#include "post/report/progress.hpp"
#include "post/run/run_files.hpp"
#include "post/run/run_journal.hpp"
#include "post/run/run_report.hpp"
#include "solver/stop_signal.hpp"
#include "solver/time_integration/march.hpp"

namespace tiretherm::app {

namespace {

struct RunOptions {
    std::string case_file;
    std::string run;  ///< of the case's [[run]] tables; empty: the first
    std::string directory;
    double field_interval = 0.0;  ///< s; 0: as the case says
    bool json = false;
    bool quiet = false;
    bool fresh = false;
    std::set<std::string> switched;  ///< formats that are refused or wanted, by name
};

using Clock = std::chrono::steady_clock;

/// Marches through the case, from where an interrupted call had come to; stops where the user asks for it, with the
/// field of that moment.
solver::Report march(const solver::Problem& problem, post::RunFiles& files, diagnosis::HotSpotTracker& hot_spots,
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
solver::Digest::Value identity_of(const RunOptions& options, const std::vector<std::string>& files) {
    std::vector<std::string> arguments{"run", options.case_file, options.run,
                                       fmt::format("{}", options.field_interval)};
    arguments.insert(arguments.end(), options.switched.begin(), options.switched.end());
    return call_identity(files, arguments);
}

int run(const RunOptions& options) {
    solver::install_stop_handlers();
    input::Reading reading =
        while_reading(options.case_file, [&] { return input::read_case_run(options.case_file, options.run); });
    if (!reading.problem) {
        report_errors(reading, "nothing was run", options.json);
        return Exit::input_error;
    }
    solver::Problem& problem = *reading.problem;
    if (options.field_interval > 0.0) {
        problem.settings.field_interval = options.field_interval;
        if (const auto excess = input::excess_of(problem, reading.limits)) {
            report_error("--fields: " + excess->what, excess->remedy, options.json);
            return Exit::input_error;
        }
    }
    if (const std::vector<std::string> defects = solver::defects(problem); !defects.empty()) {
        report_error(fmt::format("{}: {}", options.case_file, fmt::join(defects, "; ")), "nothing was run",
                     options.json);
        return Exit::input_error;
    }

    if (was_stopped("nothing was run", options.json)) {
        return Exit::interrupted;
    }
    const std::string directory = !options.directory.empty() ? options.directory
                                  : options.run.empty()      ? "out/" + problem.name
                                                             : "out/" + problem.name + "/" + options.run;
    const post::Provenance provenance{
        .version = TIRETHERM_VERSION, .case_file = options.case_file, .case_text = post::read_text(options.case_file)};
    const auto folder =
        open_output(directory, reading.files, post::RunFiles::names_in(directory), "nothing was run", options.json);
    if (!folder) {
        return Exit::input_error;
    }
    now_doing(fmt::format("simulating {} and writing to {}", options.case_file, directory));
    std::optional<post::RunFiles> files;
    diagnosis::HotSpotTracker tracker(options.case_file, problem, options.run);
    solver::Report report;
    double seconds = 0.0;
    std::optional<diagnosis::HotSpots> hot_spots;
    post::Report page;
    const bool written = write_output(*folder, post::RunFiles::names_in(directory), options.json, [&] {
        files.emplace(folder->stage(), problem, provenance, options.switched);
        post::RunJournal journal(*folder, identity_of(options, reading.files), problem, options.fresh);
        const Clock::time_point begin = Clock::now();
        seconds = journal.checkpoint() != nullptr ? journal.seconds() : 0.0;
        report = march(problem, *files, tracker, journal, options);
        seconds += std::chrono::duration<double>(Clock::now() - begin).count();
        files->finish(report);
        hot_spots = tracker.report();
        if (hot_spots) {
            files->write_hot_spots(*hot_spots);
        }
        page = post::run_report({.problem = problem,
                                 .report = report,
                                 .history = files->history(),
                                 .fields = &files->fields(),
                                 .provenance = provenance,
                                 .seconds = seconds,
                                 .warnings = reading.warnings,
                                 .files = folder->homes(files->written()),
                                 .hot_spots = hot_spots ? &*hot_spots : nullptr,
                                 .run = reading.run,
                                 .runs = reading.runs});
        files->write_page(page, {.kind = "run", .source = options.case_file, .files = reading.files});
    });
    if (!written) {
        return Exit::input_error;
    }

    if (options.json || !options.quiet) {
        print_report(page, options.json);
    }
    if (report.status.ok() && solver::stop_requested() && hot_spots) {
        std::fflush(stdout);
        report_error("stopped", "the run is complete; the continuation for its hot spots was interrupted", false);
        return Exit::interrupted;
    }
    if (report.status.ok()) {
        return Exit::done;
    }
    if (!options.json) {
        std::fflush(stdout);
        report_error(report.status.message, "the results so far are in " + directory, false);
    }
    return report.status.outcome == solver::Outcome::stopped ? Exit::interrupted : Exit::numerical_failure;
}

}  // namespace

void add_run_command(CLI::App& program, int& exit_code) {
    CLI::App* command = program.add_subcommand("run", "Simulate a case");
    const auto options = std::make_shared<RunOptions>();
    command->add_option("CASE", options->case_file, "Case file (TOML)")->required()->option_text(" ");
    command->add_option("--run", options->run, "Which of the case's [[run]] tables, by its name. Default: the first")
        ->option_text("NAME");
    add_out_option(
        *command, options->directory,
        "Where the files go; files of an earlier run there are replaced at the end. Default: out/<case name>, "
        "with --run a folder of the run's name in it");
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
    command->add_flag_callback(
        "--no-report", [options] { options->switched.insert("report"); }, "No report.html and no page.txt");
    add_fresh_option(*command, options->fresh);
    add_quiet_option(*command, options->quiet);
    command->add_flag("--json", options->json, "One JSON object instead of the summary");
    command->footer(
        "Files: report.html (the summary with charts, for a browser), page.txt (the summary), results.h5 (everything, "
        "SI\n"
        "units), channels.csv, field.pvd with field_*.vtu (ParaView; File > Load State > field_view.py shows them),\n"
        "picture.png (temperature across the thickness), of a ring tread.png.\n"
        "Charts as pictures: tiretherm report DIR --png\n"
        "A case with [[critical]] temperatures: where and when it passes them, what is left if it does not, in\n"
        "which further step it would, and what drives that; hot_spots.csv has the hottest places against time.\n"
        "The files appear together when the run ends; those of an earlier run stay until then. Ctrl-C ends a run "
        "early\n"
        "and keeps what it has. A run that was killed goes on when the same call is made again; what it has come to is "
        "in\n"
        "the hidden folder .tiretherm meanwhile (a checkpoint every 2 s, or TIRETHERM_CHECKPOINT_SECONDS).\n\n"
        "Exit code: 0 done, 1 an error in the call or the case, 2 the solver failed, 130 interrupted.\n\n"
        "Example:\n"
        "  tiretherm run cases/laser/one_watt.toml --out out/laser --fields 60");
    command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace tiretherm::app
