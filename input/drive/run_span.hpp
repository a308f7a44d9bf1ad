// SPDX-License-Identifier: BSD-3-Clause
// Where a measured run starts, and what of the case's schedules and of the run's file it leaves out.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "input/drive/drive.hpp"

namespace tiretherm::input {

/// "480 s", "20 min".
[[nodiscard]] std::string in_minutes(double seconds);

/// The start of a run with a file, s. A file that gives inputs starts where they do, and so does a part of a file that was
/// chosen, or a run that starts at what a sensor reads first. Readings alone belong to the case's own times, by which the tire was
/// driven before the first of them: such a run starts where the case does, unless the readings have a clock of their own.
/// @param start of the case, s  @param end of the case, s, where it says one
/// @pre the run's file has samples
[[nodiscard]] double start_of_run(const RunInputs& run, const DrivenSpan& span, double start,
                                  std::optional<double> end);

/// What of the schedules and logs of the case, and of the run's file, is not simulated; a sentence each.
[[nodiscard]] std::vector<std::string> not_driven(const RunInputs& run, const DrivenSpan& span,
                                                  const solver::Settings& settings);

}  // namespace tiretherm::input
