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
#include "app/messages.hpp"
#include "diagnosis/hot_spot/hot_spot_watch.hpp"
#include "input/model/reader.hpp"
#include "post/report/file.hpp"
#include "post/report/progress.hpp"
#include "post/run/run_files.hpp"
#include "post/run/run_report.hpp"
#include "solver/stop_signal.hpp"
#include "solver/time_integration/march.hpp"

namespace tiretherm::app {

namespace {

struct Options {
    std::string case_file;
    std::string directory;
    double field_interval = 0.0;  ///< s; 0: as the case says
    bool json = false;
    bool quiet = false;
    std::set<std::string> switched;  ///< formats that are refused or wanted, by name
};

using Clock = std::chrono::steady_clock;

/// Marches through the case; stops where the user asks for it, with the field of that moment.
solver::Report march(const solver::Problem& problem, post::RunFiles& files, diagnosis::HotSpotTracker& hot_spots,
                     const Options& options) {
    const bool watched = on_terminal(stdout) && on_terminal(stderr) && !options.quiet && !problem.settings.steady;
    post::Progress progress(stderr, watched, problem.name, problem.settings.start, problem.settings.end);
    return solver::run(problem, [&](const solver::Snapshot& snapshot) {
        const bool stop = solver::stop_requested();
        solver::Snapshot seen = snapshot;
        seen.field = seen.field || stop;
        files.take(seen);
        hot_spots.take(seen);
        progress.update(seen.time, seen.temperature);
        return !stop;
    });
}

int run(const Options& options) {
    input::Reading reading = input::read_case(options.case_file);
    if (!reading.problem) {
        report_errors(reading, "nothing was run", options.json);
        return Exit::input_error;
    }
    solver::Problem& problem = *reading.problem;
    if (options.field_interval > 0.0) {
        problem.settings.field_interval = options.field_interval;
    }
    if (const std::vector<std::string> defects = solver::defects(problem); !defects.empty()) {
        report_error(fmt::format("{}: {}", options.case_file, fmt::join(defects, "; ")), "nothing was run",
                     options.json);
        return Exit::input_error;
    }

    const std::string directory = options.directory.empty() ? "out/" + problem.name : options.directory;
    const post::Provenance provenance{
        .version = TIRETHERM_VERSION, .case_file = options.case_file, .case_text = post::read_text(options.case_file)};
    std::optional<post::RunFiles> files;
    try {
        files.emplace(directory, problem, provenance, options.switched);
    } catch (const post::FileError& error) {
        report_error(error.what(), "nothing was run; choose another directory with --out", options.json);
        return Exit::input_error;
    }
    solver::install_stop_handlers();
    const Clock::time_point begin = Clock::now();
    diagnosis::HotSpotTracker tracker(options.case_file, problem);
    const solver::Report report = march(problem, *files, tracker, options);
    const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    files->finish();
    const std::optional<diagnosis::HotSpots> hot_spots = tracker.report();
    if (hot_spots) {
        files->write_hot_spots(*hot_spots);
    }

    const post::RunRecord record{.problem = problem,
                                 .report = report,
                                 .history = files->history(),
                                 .provenance = provenance,
                                 .seconds = seconds,
                                 .warnings = reading.warnings,
                                 .files = files->written(),
                                 .hot_spots = hot_spots ? &*hot_spots : nullptr};
    if (options.json || !options.quiet) {
        print_report(post::run_report(record), options.json);
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
    CLI::App* command = program.add_subcommand("run", "Simulate a case: progress, summary, files");
    const auto options = std::make_shared<Options>();
    command->add_option("CASE", options->case_file, "Case file (TOML)")->required()->option_text(" ");
    command
        ->add_option("--out", options->directory,
                     "Where the files go; files of an earlier run there are replaced. Default: out/<case name>")
        ->option_text("DIR");
    command->add_option("--fields", options->field_interval, "Store the field this often, whatever the case says")
        ->option_text("SECONDS")
        ->check(CLI::PositiveNumber);
    for (const post::OutputFormat* format : post::output_formats()) {
        if (format->use != post::OutputFormat::Use::always) {
            const bool wanted = format->use == post::OutputFormat::Use::on_request;
            command->add_flag_callback(
                fmt::format("--{}{}", wanted ? "" : "no-", format->name),
                [options, format] { options->switched.insert(format->name); }, format->help);
        }
    }
    command->add_flag("--quiet", options->quiet, "No summary and no progress");
    command->add_flag("--json", options->json, "One JSON object instead of the summary");
    command->footer(
        "Files: results.h5 (everything, SI units), channels.csv, field.pvd with field_*.vtu (ParaView),\n"
        "picture.png (temperature across the thickness), channels.png (channels against time).\n"
        "A case with [[critical]] temperatures: where and when it passes them, what is left if it does not, in\n"
        "which further step it would, and what drives that; hot_spots.csv and .png have the hottest places against "
        "time.\n"
        "Ctrl-C ends a run early and keeps what it has.\n\n"
        "Exit code: 0 done, 1 an error in the call or the case, 2 the solver failed, 130 interrupted.\n\n"
        "Example:\n"
        "  tiretherm run cases/laser/one_watt.toml --out /tmp/laser --fields 60");
    command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace tiretherm::app
