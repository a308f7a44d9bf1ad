// SPDX-License-Identifier: BSD-3-Clause
// The causes of a diagnosis as sections of the page and as data, the unknown source among them.
#pragma once

#include <string>

#include "post/diagnosis/diagnosis_report.hpp"
#include "post/report/report.hpp"

namespace tiretherm::post {

/// "-" of a pure number.
[[nodiscard]] std::string unit_or_dash(const std::string& unit);

/// What each cause of the set is, and what is confounded with it.
[[nodiscard]] ReportSection interpretation(const DiagnosisRecord& record);

/// A row for each number of the causes of the set and of the likeliest others, with charts.
[[nodiscard]] ReportSection causes_section(const diagnosis::Diagnosis& result);
/// All causes.
[[nodiscard]] Value causes_data(const diagnosis::Diagnosis& result);
/// Ids of the causes of each explanation.
[[nodiscard]] Value set_data(const diagnosis::Diagnosis& result);
/// `watts` of heat; of a reading that is off there are none, and `size` is in the channel's unit.
[[nodiscard]] Value unknown_data(const diagnosis::UnknownSource& source, const input::Experiment& experiment);

}  // namespace tiretherm::post
