// SPDX-License-Identifier: BSD-3-Clause
// Options that compare, identify and diagnose share.
#pragma once

#include "app/terminal.hpp"
#include "calls/measured_call.hpp"

namespace CLI {
class App;
}

namespace tiretherm::app {

/// CASE, --data, --out and --no-report.
/// @param case_is what the case must have   @param out_is what --out does to files that are there
void add_measured_options(CLI::App& command, calls::MeasuredCall& call, const char* case_is, const char* out_is);

/// The same with --quiet and --json.
template <class Options>
void add_measured_options(CLI::App& command, Told<Options>& call, const char* case_is, const char* out_is) {
    add_measured_options(command, static_cast<calls::MeasuredCall&>(call), case_is, out_is);
    add_told_options(command, call, "page");
}

}  // namespace tiretherm::app
