// SPDX-License-Identifier: BSD-3-Clause
// Measured numbers beside simulated ones as charts.
#pragma once

#include <string>
#include <vector>

#include "diagnosis/validation/validation_table.hpp"
#include "post/report/report.hpp"

namespace tiretherm::post {

/// A chart for each unit: measured with their uncertainty beside the models with the reach of unknown inputs, the differences
/// below. @returns a section without text
[[nodiscard]] ReportSection validation_charts(const diagnosis::ValidationRecord& record);

/// The models against the experiments in sentences, a paragraph each.
[[nodiscard]] std::vector<std::string> validation_verdict(const diagnosis::ValidationRecord& record);

}  // namespace tiretherm::post
