// SPDX-License-Identifier: BSD-3-Clause
// The hottest temperature of a study's runs as a chart.
#pragma once

#include "diagnosis/study/study_record.hpp"
#include "post/report/report.hpp"

namespace tiretherm::post {

/// Against what is varied, with samples their median and the range of nine tenths of them; of two varied values a curve for each
/// value of the first, and maps; of samples alone how they are distributed.
[[nodiscard]] ReportSection study_chart_section(const diagnosis::StudyRecord& study);

/// A map of the first two sides of the grid for each value of the others; only the first of these where they are more than six.
/// @pre two sides have more than one value
void add_study_maps(ReportSection& section, const diagnosis::StudyRecord& study);

}  // namespace tiretherm::post
