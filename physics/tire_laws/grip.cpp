// SPDX-License-Identifier: BSD-3-Clause
// The three parts of friction, over their sum at the reference temperature.

#include "physics/tire_laws/grip.hpp"

namespace tiretherm::physics {

double Grip::value(double T_surface, const std::function<double(double)>& tan_delta) const {
    const double there = adhesion.value(reference_temperature) + hysteresis + wear;
    const double loss = hysteresis > 0.0 ? tan_delta(T_surface) / tan_delta(reference_temperature) : 0.0;
    return (adhesion.value(T_surface) + hysteresis * loss + wear) / there;
}

}  // namespace tiretherm::physics
