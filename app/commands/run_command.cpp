// SPDX-License-Identifier: BSD-3-Clause
// `tiretherm run`: simulates a case, of a car all its tires, and writes channels, fields and the hot spots.

#include <memory>
#include <string>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/commands.hpp"
#include "app/terminal.hpp"
#include "calls/calls.hpp"
#include "post/fields/output_format.hpp"

namespace tiretherm::app {

void add_run_command(CLI::App& program, int& exit_code) {
    CLI::App* command = program.add_subcommand("run", "Simulate a case");
    const auto options = std::make_shared<Told<calls::RunOptions>>();
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
    add_told_options(*command, *options, "summary");
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
    command->callback([options, &exit_code] { exit_code = make(*options, calls::run); });
}

}  // namespace tiretherm::app
