// SPDX-License-Identifier: BSD-3-Clause
// The calls themselves. Each says what comes of it to its caller and returns how it ended.
#pragma once

#include <string>

#include "calls/caller.hpp"
#include "calls/diagnose_table.hpp"
#include "calls/measured_call.hpp"
#include "calls/simulated_run.hpp"

namespace tiretherm::calls {

struct IdentifyOptions : MeasuredCall {
    double correlation_time = 10.0;  ///< s, of a plan's noise
    bool profile = false;
    bool plan = false;
    std::string leave_out{};  ///< "lap" or "run"
};

struct DiagnoseOptions : MeasuredCall {
    double time_limit = 0.0;  ///< s; 0: none
    bool by_run = false;      ///< each run alone, too, however long that takes
    bool no_by_run = false;   ///< neither: where that is quick
};

struct StudyOptions {
    std::string study_file;
    std::string directory;
    unsigned threads = 0;  ///< 0: as many as the machine can do
    std::string part;      ///< "3/16"; empty: all runs
    bool merge = false;    ///< puts the parts together
    bool fresh = false;
    bool no_report = false;
};

/// Simulates a case, of a car all its tires, and writes channels, fields and, for [[critical]] temperatures, the hot spots.
[[nodiscard]] int run(const RunOptions& options, Caller& caller);
/// Simulates the measured runs of a case without fitting; the differences, channel by channel.
[[nodiscard]] int compare(const MeasuredCall& call, Caller& caller);
/// Fits the [[parameter]] values of a case to measured runs.
[[nodiscard]] int identify(const IdentifyOptions& options, Caller& caller);
/// Finds which effects of the catalogue explain what a fit leaves. @param of_table where the case is a table of numbers
[[nodiscard]] int diagnose(DiagnoseOptions call, const TableOptions& of_table, Caller& caller);
/// Runs a case many times.
[[nodiscard]] int study(const StudyOptions& options, Caller& caller);

}  // namespace tiretherm::calls
