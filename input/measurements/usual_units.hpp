// SPDX-License-Identifier: BSD-3-Clause
// Units in which the usual ranges of logged signals are stated, in SI.
#pragma once

#include <limits>
#include <numbers>

namespace tiretherm::input {

constexpr double no_limit = std::numeric_limits<double>::infinity();
constexpr double degree = std::numbers::pi / 180.0;  ///< rad
constexpr double km_h = 1.0 / 3.6;                   ///< m/s
constexpr double bar = 1e5;                          ///< Pa

}  // namespace tiretherm::input
