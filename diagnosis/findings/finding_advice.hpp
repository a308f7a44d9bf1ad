// SPDX-License-Identifier: BSD-3-Clause
// What an unexpected value of a fitted parameter means, and what to do about it.
#pragma once

#include "diagnosis/remarks/remark.hpp"
#include "input/measurements/experiment.hpp"
#include "physics/plausible_ranges.hpp"

namespace tiretherm::diagnosis {

/// Specific where the usual reason is known, otherwise what the plausible range says, otherwise the next step.
/// @param is_above above what was expected, or below  @param range of the parameter, or null
[[nodiscard]] Remark advice(const input::Experiment& experiment, const solver::FreeParameter& parameter, bool is_above,
                            const physics::PlausibleRange* range);

}  // namespace tiretherm::diagnosis
