// SPDX-License-Identifier: BSD-3-Clause
// Where and when a model and its measured runs differ.
#pragma once

#include "post/diagnosis/diagnosis_report.hpp"

namespace tiretherm::post {

/// Where and when measured and simulated differ, with the base model and, where there is one, with the extended one.
/// Single numbers stand for themselves.
[[nodiscard]] ReportSection residual_breakdown(const DiagnosisRecord& record);

}  // namespace tiretherm::post
