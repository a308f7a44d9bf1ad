// SPDX-License-Identifier: BSD-3-Clause
// Simulates all cases that a validation table needs, each once, and keeps their channels.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "diagnosis/remarks/remark.hpp"
#include "input/validation/validation.hpp"

namespace tiretherm::diagnosis {

/// The cases of a table, run.
struct RunResults {
    std::vector<input::Trace> traces;   ///< [runs]
    std::vector<std::string> failures;  ///< [runs] why a run has no result: "case: reason"; empty when it has
    Remarks warnings;                   ///< laws that the runs left the ranges of
    double energy_closure = 0.0;        ///< largest of all runs that came to their end
};

/// Runs every case once, several at a time; the results do not depend on how many.
/// @param threads 0: as many as the machine has   @param progress called after each run with the number that are done
[[nodiscard]] RunResults run_all(const std::vector<input::ValidationRun>& runs, unsigned threads,
                                 const std::function<void(std::size_t done)>& progress);

}  // namespace tiretherm::diagnosis
