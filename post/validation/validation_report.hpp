// SPDX-License-Identifier: BSD-3-Clause
// A validation table as a report, and as Markdown.
#pragma once

#include <string>

#include "diagnosis/validation/validation_table.hpp"
#include "post/report/report.hpp"

namespace tiretherm::post {

/// A line for each number beside those of the models, and the figures of each model: over the numbers that all of them
/// give, then of one that gives more. Keys of the data: title, numbers, summary, runs, seconds, energy_closure, warnings;
/// an open end of a measured range is null.
[[nodiscard]] Report validation_report(const diagnosis::ValidationRecord& record);
/// The table and the figures under it for a README.
[[nodiscard]] std::string validation_markdown(const diagnosis::ValidationRecord& record);

}  // namespace tiretherm::post
