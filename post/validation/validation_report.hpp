// SPDX-License-Identifier: BSD-3-Clause
// A validation table as a report, and as Markdown.
#pragma once

#include <string>

#include "diagnosis/validation/validation_table.hpp"
#include "post/report/report.hpp"

namespace tiretherm::post {

/// A line for each number beside those of the models, the figures of each model: over the numbers that all of them
/// give, then of one that gives more; and the inputs of the experiments with what they change. Keys of the data: title, numbers, summary, runs, seconds, energy_closure, warnings;
/// an open end of a measured range is null.
/// @param with_inputs the page has the inputs, too; the data always have them
[[nodiscard]] Report validation_report(const diagnosis::ValidationRecord& record, bool with_inputs = false);
/// The table and the figures under it for a README.
[[nodiscard]] std::string validation_markdown(const diagnosis::ValidationRecord& record);
/// All inputs with standing, value and range, and for each number what is known of its inputs and what they change.
[[nodiscard]] std::string validation_inputs_markdown(const diagnosis::ValidationRecord& record);

}  // namespace tiretherm::post
