// SPDX-License-Identifier: BSD-3-Clause
// Inputs that a quantity takes into account where they are given, beside those that it needs.
#pragma once

#include <span>
#include <string_view>

#include "solver/quantity.hpp"

namespace tiretherm::solver {

/// Names of the signals that a quantity reads beside QuantityDescription::signals, which a case may leave out.
[[nodiscard]] std::span<const std::string_view> optional_signals(Quantity quantity);

}  // namespace tiretherm::solver
