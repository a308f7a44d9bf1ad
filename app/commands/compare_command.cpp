// SPDX-License-Identifier: BSD-3-Clause
// `tiretherm compare`: simulates the measured runs of a case without fitting and reports the differences.

#include <memory>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/commands.hpp"
#include "app/measured_call.hpp"
#include "calls/calls.hpp"

namespace tiretherm::app {

void add_compare_command(CLI::App& program, int& exit_code) {
    CLI::App* command =
        program.add_subcommand("compare", "Compare measured runs with the simulation, channel by channel");
    const auto call = std::make_shared<Told<calls::MeasuredCall>>();
    add_measured_options(*command, *call, "measured runs or values",
                         "files of an earlier comparison there are replaced. Default: out/<case name>");
    command->footer(
        "The case is simulated as it stands: nothing is fitted. Differences are simulated - measured.\n"
        "Files: report.html (this page with charts, for a browser), page.txt (this page), compare.csv (a row for each "
        "sample),\n"
        "compare_statistics.csv (a row for each figure); of laps and of a car's tires laps.csv (measured and simulated "
        "mean,\n"
        "maximum and end of each sensor in each lap) and heat.csv (friction power and heat); of cameras "
        "compare_pixels.csv (a row for each pixel); of a car inputs.csv (loads, slips and forces of each tire).\n"
        "Charts as pictures, the frames of a camera among them: tiretherm report DIR --png\n\n"
        "The files appear together at the end.\n\n"
        "Exit code: 0 done, however far apart; 1 an error in the call, the case or the data; 2 the solver failed;\n"
        "130 interrupted.\n\n"
        "Example:\n"
        "  tiretherm compare cases/practice/two_node_bench.toml \\\n"
        "      --data cases/practice/puzzle1.csv --out out/puzzle");
    command->callback([call, &exit_code] { exit_code = make(*call, calls::compare); });
}

}  // namespace tiretherm::app
