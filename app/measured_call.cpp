// SPDX-License-Identifier: BSD-3-Clause
// Implements the options that compare, identify and diagnose share.

#include "app/measured_call.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/output.hpp"

namespace tiretherm::app {

void add_measured_options(CLI::App& command, calls::MeasuredCall& call, const char* case_is, const char* out_is) {
    command.add_option("CASE", call.case_file, fmt::format("Case file (TOML) with {}", case_is))
        ->required()
        ->option_text(" ");
    command
        .add_option("--data", call.data,
                    "A measured run (CSV or HDF5), once for each; they take the place of the case's own")
        ->option_text("FILE ...");
    add_out_option(command, call.directory, fmt::format("Where the files go; {}", out_is));
    command.add_flag("--no-report", call.no_report, "No report.html and no page.txt");
}

}  // namespace tiretherm::app
