// SPDX-License-Identifier: BSD-3-Clause
// Temperature of a brake disc from the power of braking.
#pragma once

#include <span>
#include <vector>

namespace tiretherm::physics {

/// A disc with its caliper, of one temperature. 10 kg of cast iron have 5 kJ/K; a front disc that takes 15 kW on the mean of a lap
/// and is then some 400 K above the air has 40 W/K. Both are assumed.
struct Brake {
    double heat_capacity = 5000.0;  ///< J/K
    double cooling = 40.0;          ///< W/K, to the air
};

/// C dT/dt = P - G (T - T_air), exactly for a power and an air that hold their mean from one moment to the next. The tire takes so
/// little that it does not count here.
/// @param time [n] s, ascending  @param power [n] W, of friction at this wheel  @param air [n] K
/// @returns [n] K, from the air's at first
[[nodiscard]] std::vector<double> brake_temperature(const Brake& brake, std::span<const double> time,
                                                    std::span<const double> power, std::span<const double> air);

}  // namespace tiretherm::physics
