// SPDX-License-Identifier: BSD-3-Clause
// `tiretherm identify`: fits the [[parameter]] values of a case to measured runs, or with --plan predicts the intervals
// before anything is measured.

#include <memory>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/commands.hpp"
#include "app/measured_call.hpp"
#include "calls/calls.hpp"

namespace tiretherm::app {

void add_identify_command(CLI::App& program, int& exit_code) {
    CLI::App* command =
        program.add_subcommand("identify", "Fit parameters of a case to measured runs, with 95 % intervals");
    const auto options = std::make_shared<Told<calls::IdentifyOptions>>();
    add_measured_options(*command, *options, "[[run]] and [[parameter]]",
                         "files of an earlier fit there are replaced. Default: out/<case name>; of a plan none");
    add_fresh_option(*command, options->fresh);
    command->add_flag("--profile", options->profile,
                      "Intervals by profile likelihood, which need not be symmetric: some ten fits for each parameter");
    command->add_flag("--plan", options->plan,
                      "Before anything is measured: the intervals that these runs and sensors would give");
    command
        ->add_option("--leave-out", options->leave_out,
                     "Each lap, or each run, is predicted by a fit without it as well: some three fits for each")
        ->option_text("lap|run")
        ->check(CLI::IsMember({"lap", "run"}));
    add_seconds_option(*command, "--correlation-time", options->correlation_time,
                       "Of the noise that a plan assumes. Default: 10", Seconds::from_zero);
    command->footer(
        "All runs and channels are fitted at once. The noise of each channel, correlated and white, is estimated from\n"
        "what no parameter can explain. A parameter that the data do not see is named as such.\n"
        "Findings say which parameters are not as expected, and why: far off what was known before, at a size that no "
        "tire\n"
        "has (tiretherm effects EFFECT). Beside such a parameter, or where an error of the model may pass for noise, "
        "the others\n"
        "are called doubtful.\n"
        "Of a camera's frames every pixel is taken, and what the grid and the steps make of them is corrected.\n"
        "A plan takes every sensor with a standard_deviation, at the times of the runs' files or of [time] output.\n"
        "Files: report.html (this page with charts, for a browser), page.txt (this page), identified.toml (the case "
        "with the\n"
        "fitted values), identify.csv (a row for each sample), parameters.csv (values, intervals and correlations), "
        "laws.csv\n"
        "(k(T) and c(T) that were fitted, with their 95 % bands); of laps and of a car's tires laps.csv; of a plan the "
        "page and\n"
        "plan.json.\n"
        "Charts as pictures: tiretherm report DIR --png\n\n"
        "The files appear together at the end. A fit that was interrupted or killed goes on when the same call is "
        "made\n"
        "again: its simulations are kept in the hidden folder .tiretherm until then.\n\n"
        "Exit code: 0 done; 1 an error in the call, the case or the data; 2 the solver failed or the search did not\n"
        "converge; 130 interrupted.\n\n"
        "Example:\n"
        "  tiretherm identify cases/practice/two_node_bench.toml \\\n"
        "      --data cases/practice/puzzle1.csv --out out/puzzle\n"
        "  tiretherm identify cases/laser/identify.toml --plan");
    command->callback([options, &exit_code] { exit_code = make(*options, calls::identify); });
}

}  // namespace tiretherm::app
