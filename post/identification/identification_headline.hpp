// SPDX-License-Identifier: BSD-3-Clause
// The answer of a fit or a plan in its first sentences.
#pragma once

#include <string>
#include <vector>

#include "post/identification/identification_report.hpp"

namespace tiretherm::post {

/// The 95 % interval: "1.05 to 1.13", of a plan "+- 0.04"; "-" where nothing determines the parameter.
[[nodiscard]] std::string interval_text(const diagnosis::Fitted& one, bool planned);
[[nodiscard]] inline double half_width(const diagnosis::Fitted& one) { return 0.5 * (one.high - one.low); }

/// How many parameters the data determine, the first values with their intervals, and how the channels fit.
[[nodiscard]] std::vector<std::string> identification_headline(const IdentificationRecord& record);

}  // namespace tiretherm::post
