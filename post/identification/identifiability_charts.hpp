// SPDX-License-Identifier: BSD-3-Clause
// How well each number of a fit is determined, as charts of the page.
#pragma once

#include "post/identification/identification_report.hpp"

namespace tiretherm::post {

/// What is left of the uncertainty of each number, which numbers the data tell apart, and the combinations that they see
/// least. Charts alone: the page as text has the same in its tables.
[[nodiscard]] ReportSection identifiability_section(const IdentificationRecord& record);

}  // namespace tiretherm::post
