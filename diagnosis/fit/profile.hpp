// SPDX-License-Identifier: BSD-3-Clause
// Confidence intervals by profile likelihood: the sum of squares, minimised over all other parameters, rises by 3.84
// (95 %).
#pragma once

#include "diagnosis/fit/identification.hpp"
#include "diagnosis/fit/least_squares.hpp"

namespace tiretherm::diagnosis {

/// Intervals by profile likelihood: to either side the value at which the sum of squares, minimised over all other
/// numbers, has risen by 3.84, the 95 % point of a chi-square with one degree of freedom. The noise is held.
/// @param least_squares starts at the fitted values  @param result gets the intervals of all numbers
void profile_intervals(const LeastSquares& least_squares, Identification& result);

}  // namespace tiretherm::diagnosis
