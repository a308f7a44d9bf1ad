// SPDX-License-Identifier: BSD-3-Clause
// The hottest temperature of a study's runs as a chart.
#pragma once

#include "diagnosis/study/study_record.hpp"
#include "post/report/report.hpp"

namespace tiretherm::post {

/// Against the varied number, with samples their median and the range of nine tenths of them; of two varied numbers a curve for each
/// value of the first; of samples alone how they are distributed. Nothing where what is varied is no number.
[[nodiscard]] Section study_chart_section(const diagnosis::StudyRecord& study);

}  // namespace tiretherm::post
