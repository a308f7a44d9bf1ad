// SPDX-License-Identifier: BSD-3-Clause
// Units of what is written and read, in those of the equations.
#pragma once

#include <numbers>

namespace hidden_effects {

inline constexpr double celsius = 273.15;                   ///< K, 0 degC
inline constexpr double degree = std::numbers::pi / 180.0;  ///< radian

}  // namespace hidden_effects
