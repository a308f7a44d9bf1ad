// SPDX-License-Identifier: BSD-3-Clause
// Fitted material laws against temperature.
#pragma once

#include "post/identification/identification_report.hpp"

namespace tiretherm::post {

/// k(T) and c(T) of the materials that a fit has changed: the case's, the fitted one, and its 95 % band, of fitted_laws. Where a
/// parameter has no interval there is no band.
[[nodiscard]] ReportSection law_charts(const IdentificationRecord& record);

}  // namespace tiretherm::post
