// SPDX-License-Identifier: BSD-3-Clause
// The verdict of each run alone as a table, as data, and as a sentence on what only some runs show.
#pragma once

#include <string>

#include "post/diagnosis/diagnosis_report.hpp"

namespace tiretherm::post {

/// A row for each cause that a run shows alone, and the sentence; nothing where no runs were diagnosed alone.
[[nodiscard]] ReportSection run_verdicts_section(const DiagnosisRecord& record);
/// [{name, verdict, causes, gain}], in the order of the runs. `causes` are those of the set, the best hypothesis first.
[[nodiscard]] Value run_verdicts_data(const DiagnosisRecord& record);
/// "All runs agree on sensor_lag of surface_temperature.", "run2 alone shows sensor_lag of surface_temperature."; empty where
/// fewer than two runs can be compared.
[[nodiscard]] std::string agreement_of(const DiagnosisRecord& record);

}  // namespace tiretherm::post
