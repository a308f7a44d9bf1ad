// SPDX-License-Identifier: BSD-3-Clause
// How channels and single measured numbers fit: a section of the page of a fit.
#pragma once

#include "post/identification/identification_report.hpp"

namespace tiretherm::post {

/// Root mean square and noise of each channel before and after the fit.
[[nodiscard]] DataTable fitted_channels(const IdentificationRecord& record);
/// Each single measured number with what is simulated before and after the fit.
[[nodiscard]] DataTable fitted_single_numbers(const IdentificationRecord& record);
/// Both with the cautions about the noise.
[[nodiscard]] ReportSection fit_section(const IdentificationRecord& record, DataTable of_channels,
                                        DataTable of_numbers);

/// What was left out in turn, a row for each channel of it: how well a fit without it predicts it, and which parameter moves most.
[[nodiscard]] DataTable left_out_table(const IdentificationRecord& record);
[[nodiscard]] ReportSection left_out_section(const IdentificationRecord& record, DataTable table);

}  // namespace tiretherm::post
