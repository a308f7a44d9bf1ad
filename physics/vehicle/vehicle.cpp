// SPDX-License-Identifier: BSD-3-Clause
// Cornering stiffness of a car's tire and the understeer gradient that follows from both axles' (Gillespie 1992).

#include "physics/vehicle/vehicle.hpp"

#include <cmath>

namespace tiretherm::physics {

double cornering_stiffness_of(const VehicleTire& tire, double load, double static_load) {
    return tire.magic_formula ? std::abs(tire.magic_formula->cornering_stiffness(load, 0.0))
                              : tire.cornering_stiffness * load / static_load;
}

double Vehicle::understeer_gradient() const {
    const auto per_stiffness = [&](std::size_t axle) {
        const double load = 0.5 * static_axle_load(axle);
        return load / standard_gravity / cornering_stiffness_of(axles[axle].tire, load, load);
    };
    return per_stiffness(0) - per_stiffness(1);
}

}  // namespace tiretherm::physics
