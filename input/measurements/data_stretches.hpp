// SPDX-License-Identifier: BSD-3-Clause
// Stretches of equal values in a recorded column: what is too long for its own signal.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "input/measurements/data_warnings.hpp"

namespace tiretherm::input {

constexpr std::size_t stuck_samples = 20;  ///< fewer equal samples are nothing
constexpr double coarse = 3.0;             ///< steps of the logger; a signal that moves no further hardly moves

/// All samples of a column in stretches of equal values.
[[nodiscard]] const std::vector<Stretch>& stretches(const RecordedColumn& column);

/// How often, a sample, a signal turns round outside a stretch. A setpoint and a ramp hardly ever do.
[[nodiscard]] double reversals(const std::vector<double>& value, const Stretch& without);

/// Whether the tire stands all along a stretch: before a run, or after it when all has cooled, nothing changes.
[[nodiscard]] bool is_soak(const Recording& recording, const RecordedColumn& column, const Stretch& stretch);

/// Whether a sensor's noise is well above what the logger resolves: most samples outside some stretches differ from their
/// neighbours, up and down. Such a signal does not repeat itself.
/// @param without whether a stretch is left out
[[nodiscard]] bool has_noise(const RecordedColumn& column, const std::function<bool(const Stretch&)>& without);

/// What stands still in a column for too long, the longest first.
[[nodiscard]] const std::vector<Stretch>& too_long(const Recording& recording, const RecordedColumn& column);

/// Stretches at the highest or the lowest value that are no stay there: a noisy signal is cut off, or one without noise goes
/// straight to a round number and stays.
[[nodiscard]] const std::vector<Stretch>& clipped_stretches(const Recording& recording, const RecordedColumn& column);

/// Stretches of a sensor in which others stand still as well, from the same sample to the same.
/// @param sensors out, if not null: the names of all that stand still in the last of them
[[nodiscard]] std::vector<Stretch> stuck_together(const Recording& recording, const RecordedColumn& column,
                                                  std::vector<std::string>* sensors);

/// Whether an input of the tire changes by a tenth of its range or more between two times: a sensor may jump with it.
[[nodiscard]] bool is_eventful(const Recording& recording, double from, double to);

/// The same of loads, slips, forces and heat alone, by which a surface may gain many kelvin within a sample. A speed or an air that
/// jumps so comes from the logger, which wakes all its channels at one time.
[[nodiscard]] bool is_heated_at_once(const Recording& recording, double from, double to);

/// The end of a finding: what becomes of samples that are surely unusable.
[[nodiscard]] std::string_view left_out(const Recording& recording);

}  // namespace tiretherm::input
