// SPDX-License-Identifier: BSD-3-Clause
// Diagnosis of a table of measured numbers over many experiments.
#pragma once

#include <string>

#include "calls/measured_call.hpp"

namespace tiretherm::calls {

/// What a table needs to know beside what every diagnosis does.
struct TableOptions {
    std::string model{};  ///< key; empty: the first of the table
    unsigned threads = 0;
    bool markdown = false;
};

/// Diagnoses a table. @returns the exit code
[[nodiscard]] int diagnose_table(const MeasuredCall& call, const TableOptions& options, Caller& caller);

}  // namespace tiretherm::calls
