// SPDX-License-Identifier: BSD-3-Clause
// Which measurement, or which input that is not printed, would tell the best explanations apart.
#pragma once

#include <optional>

#include "diagnosis/quoted/quoted_diagnosis.hpp"

namespace tiretherm::diagnosis::quoted {

/// Simulates the best explanations and looks for the temperature at the end of a test in which they differ most, and for
/// the unknown input that hides most of their difference in the quoted numbers.
/// @returns nothing where there are no two of them
[[nodiscard]] std::optional<NextMeasurement> next_measurement(const Numbers& numbers, const Analysis& decidable,
                                                              const Analysis& all, Trials& trials);

}  // namespace tiretherm::diagnosis::quoted
