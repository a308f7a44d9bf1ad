// SPDX-License-Identifier: BSD-3-Clause
// What heat in a window of one run may be: rain, blankets in the pits.
#pragma once

#include "diagnosis/assess/diagnosis.hpp"

namespace tiretherm::diagnosis {

/// Where the answer is heat in a window of one run, a remark says what would do that, by its sign, its place and whether the tire turns.
/// The window is that of all windows of missing heat beside each other that have its sign beyond two standard deviations.
void name_window(const input::Experiment& experiment, Diagnosis& into);

}  // namespace tiretherm::diagnosis
