// SPDX-License-Identifier: BSD-3-Clause
// Specification of measured values: which unit and range a value of a channel must have.
#pragma once

#include "input/text/quantity.hpp"

namespace tiretherm::input {

/// What a measured value of a channel must be.
[[nodiscard]] QuantitySpec value_spec(solver::Quantity quantity);
/// A standard deviation of such values: positive, a difference where it is one of temperatures.
[[nodiscard]] QuantitySpec deviation_spec(solver::Quantity quantity);

}  // namespace tiretherm::input
