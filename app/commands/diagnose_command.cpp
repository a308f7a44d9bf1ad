// SPDX-License-Identifier: BSD-3-Clause
// `tiretherm diagnose`: fits a case to measured runs and reports which effects of the catalogue explain the remaining
// differences.

#include <memory>
#include <string>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/commands.hpp"
#include "app/measured_call.hpp"
#include "calls/calls.hpp"

namespace tiretherm::app {

void add_diagnose_command(CLI::App& program, int& exit_code) {
    CLI::App* command = program.add_subcommand(
        "diagnose", "Find which effect a model lacks in measured runs, and what adding it gains");
    const auto call = std::make_shared<Told<calls::DiagnoseOptions>>();
    add_measured_options(*command, *call, "[[run]] and [[parameter]]",
                         "files of an earlier diagnosis there are replaced. Default: out/<case name>");
    add_fresh_option(*command, call->fresh);
    add_seconds_option(*command, "--time-limit", call->time_limit,
                       "Of wall time after which the best answer so far is given; Ctrl-C does the same. The same call, "
                       "as often as it is made, goes on from there");
    CLI::Option* by_run = command->add_flag(
        "--by-run", call->by_run,
        "Each of several runs alone as well, however long that takes. Default: where all together took up to 60 s");
    command->add_flag("--no-by-run", call->no_by_run, "No run alone")->excludes(by_run);
    const auto of_table = std::make_shared<calls::TableOptions>();
    command->add_option("--model", of_table->model, "Of a table: the model that is diagnosed. Default: its first one")
        ->option_text("KEY");
    command
        ->add_option("--threads", of_table->threads,
                     "Of a table: runs at a time. Default: as many as the machine can do")
        ->option_text("N")
        ->check(CLI::Range(1, 1024));
    command->add_flag("--markdown", of_table->markdown, "Of a table: the page for a README")->excludes("--json");
    command->footer(
        "The free parameters of the case are fitted; what is left is compared with every effect of the catalogue that "
        "is\n"
        "not in the model (or those of [diagnose] candidates), alone and in pairs, and with heat that no effect is.\n"
        "The answer is a set: one cause is named, several that the data cannot tell apart are all listed.\n"
        "A camera is taken as the means of three rings about the spot.\n"
        "Dense logs are thinned to some 1500 values a sensor and run, by means over blocks; the page says how far.\n"
        "Each of several runs is diagnosed alone, too: what only one shows is a fault of that run.\n"
        "Columns that the model does not use may be causes where they drive the tire, or as [diagnose] signals and "
        "ignore say.\n"
        "CASE may also be a table of measured numbers over many experiments, as `validate` reads it. Then additions "
        "to\n"
        "one model (effects, parameters, another mesh, unprinted inputs, instruments) are judged by experiments that "
        "took\n"
        "no part in fitting them. Its files are report.html, page.txt and diagnosis.json.\n"
        "Differences are simulated - measured.\n"
        "Files: report.html (this page with charts, for a browser), page.txt (this page), diagnosis.json, "
        "extended.toml (the\n"
        "case with the cause switched on, where there is one), residuals.csv (a row for each sample), missing_heat.csv "
        "(heat\n"
        "that windows of the runs lack), laps.csv (of laps and of a car's tires). Charts as pictures: tiretherm report "
        "DIR --png\n\n"
        "The files appear together at the end, also after Ctrl-C or --time-limit: they then hold the best answer so "
        "far.\n"
        "A diagnosis that was killed, interrupted or cut short by --time-limit goes on when the same call is made "
        "again:\n"
        "its simulations are kept in the hidden folder .tiretherm until then.\n\n"
        "Exit code: 0 done, whatever the answer, also the best one within --time-limit; 1 an error in the call, the "
        "case\n"
        "or the data; 2 the solver failed, or --time-limit passed before there was an answer; 130 interrupted.\n\n"
        "Example:\n"
        "  tiretherm diagnose cases/practice/two_node_bench.toml \\\n"
        "      --data cases/practice/puzzle1.csv --out out/puzzle");
    command->callback([call, of_table, &exit_code] {
        exit_code = make(*call, [&](const calls::DiagnoseOptions& options, calls::Caller& caller) {
            return calls::diagnose(options, *of_table, caller);
        });
    });
}

}  // namespace tiretherm::app
