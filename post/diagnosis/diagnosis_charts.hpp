// SPDX-License-Identifier: BSD-3-Clause
// Charts of a diagnosis: candidate causes, channels before and after, gains on data left out, discriminating experiments,
// and the inferred heat over place and time.
#pragma once

#include "post/diagnosis/diagnosis_report.hpp"

namespace tiretherm::post {

/// Gain and standard deviations of the most likely causes; those of the set are framed.
void add_cause_charts(ReportSection& section, const diagnosis::Diagnosis& result);

/// Root mean square of each channel before and after, fitted and held out, a chart for each unit.
void add_channel_gain_charts(ReportSection& section, const DiagnosisRecord& record);

/// Share of the removable error that is removed on data that took no part, of all runs and of each alone, with 95 %.
void add_held_out_chart(ReportSection& section, const DiagnosisRecord& record);

/// By how many standard deviations the explanations differ, with these data and with each further experiment.
void add_experiment_chart(ReportSection& section, const diagnosis::Diagnosis& result);

/// Watts over time and place, a map for each run; what is larger than three standard deviations is framed.
void add_missing_heat_maps(ReportSection& section, const DiagnosisRecord& record);

}  // namespace tiretherm::post
