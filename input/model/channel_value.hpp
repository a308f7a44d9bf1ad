#pragma once

#include "input/text/quantity.hpp"
#include "solver/problem.hpp"

namespace tiretherm::input {

/// What a measured value of a channel must be.
[[nodiscard]] Wanted wanted_value(solver::Quantity quantity);
/// A standard deviation of such values: positive, a difference where it is one of temperatures.
[[nodiscard]] Wanted wanted_deviation(solver::Quantity quantity);

}  // namespace tiretherm::input
