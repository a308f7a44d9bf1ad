// SPDX-License-Identifier: BSD-3-Clause
// Conversion from kelvin to degrees Celsius.
#pragma once

namespace tiretherm {

/// Absolute temperature of 0 degC. K
inline constexpr double zero_celsius = 273.15;

/// @param kelvin K  @returns degC
[[nodiscard]] constexpr double celsius(double kelvin) { return kelvin - zero_celsius; }

}  // namespace tiretherm
