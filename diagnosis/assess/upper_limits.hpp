// SPDX-License-Identifier: BSD-3-Clause
// How large each candidate could be without having been seen.
#pragma once

#include <vector>

#include "diagnosis/assess/diagnosis_state.hpp"

namespace tiretherm::diagnosis {

/// 95 % intervals of every cause that is not in the best hypothesis, each alone beside it, in the linearised model. Where the model has
/// errors of its own they are those of the scatter between blocks of time. A cause that these data do not see has none.
[[nodiscard]] std::vector<UpperLimit> upper_limits(const DiagnosisState& state);

}  // namespace tiretherm::diagnosis
