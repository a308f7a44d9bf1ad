// SPDX-License-Identifier: BSD-3-Clause
// What a diagnosis tried and what it rules out: in short in the sections of the page, in full behind them and as data.
#pragma once

#include <string>

#include "post/diagnosis/diagnosis_report.hpp"

namespace tiretherm::post {

/// "sensor_lag of surface_temperature, tau 1.4 s (0.9 to 1.9)", all causes of it.
[[nodiscard]] std::string name_of(const diagnosis::TriedAddition& one);
/// "surface_temperature 2.1 to 1.7 K rms, gain 0.4 K (-0.1 to 0.6)": on data that were left out.
[[nodiscard]] std::string change_text(const diagnosis::ChannelChange& change, const input::Experiment& experiment);
/// What stands against it, the rest of a sentence; empty: nothing.
[[nodiscard]] std::string text_of(diagnosis::AdditionDoubt doubt, bool within_run);

/// The three additions that remove most beside the answer, an item each.
[[nodiscard]] ReportSection tried_section(const DiagnosisRecord& record);
/// All of them.
[[nodiscard]] DataTable tried_table(const DiagnosisRecord& record);

/// How large the causes can be at most that are asked for first, an item for each effect.
[[nodiscard]] ReportSection limits_section(const DiagnosisRecord& record);
/// All of them.
[[nodiscard]] DataTable limits_table(const diagnosis::Diagnosis& result);

/// Where the case's mesh is too coarse: what a richer one gains, and the free numbers on it; empty: it is not.
[[nodiscard]] std::string richer_mesh_sentence(const DiagnosisRecord& record);

}  // namespace tiretherm::post
