// SPDX-License-Identifier: BSD-3-Clause
// The linear regression of a study as a text table.
#pragma once

#include <optional>
#include <string>

#include "diagnosis/study/study_drivers.hpp"

namespace tiretherm::post {

/// A table of the strongest, and what the line is worth.
/// @param critical K, a temperature whose passing is judged  @returns lines, each ended by a newline; empty without a line
[[nodiscard]] std::string regression_text(const diagnosis::StudyRegression& line, std::optional<double> critical = {});

}  // namespace tiretherm::post
