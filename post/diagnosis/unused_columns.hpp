// SPDX-License-Identifier: BSD-3-Clause
// The columns of the files that the model does not use, as the report of a diagnosis lists them.
#pragma once

#include "input/measurements/experiment.hpp"
#include "post/report/report.hpp"

namespace tiretherm::post {

/// Each column, what it is, whether a cause was looked for that follows it, and why not. Empty without such columns.
[[nodiscard]] DataTable unused_columns_table(const input::Experiment& experiment);
[[nodiscard]] ReportSection unused_columns_section(const input::Experiment& experiment);

}  // namespace tiretherm::post
