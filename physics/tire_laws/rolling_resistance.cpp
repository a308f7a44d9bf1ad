// SPDX-License-Identifier: BSD-3-Clause
// Evaluates the moment (0 at 0.1 m/s and below), the drag (0 also without contact), the drum correction and the coast-
// down regression.

#include "physics/tire_laws/rolling_resistance.hpp"

#include <cmath>

namespace tiretherm::physics {

double rolling_moment(const Tire& tire, double dissipated_power, double speed, double vertical_load) {
    if (std::abs(speed) <= standing_speed) {
        return 0.0;
    }
    return dissipated_power * tire.rolling_radius(vertical_load) / std::abs(speed);
}

double rolling_drag(const Tire& tire, double dissipated_power, double speed, double vertical_load) {
    if (!tire.touches(vertical_load)) {
        return 0.0;
    }
    return rolling_moment(tire, dissipated_power, speed, vertical_load) / tire.loaded_radius(vertical_load);
}

double to_drum(double measured, double from, double to, double tire_radius) {
    return measured * std::sqrt((1.0 + tire_radius * to) / (1.0 + tire_radius * from));
}

double CoastdownLaw::force(double pressure, double vertical_load, double speed) const {
    return std::pow(pressure, pressure_exponent) * std::pow(vertical_load, load_exponent) *
           (constant + speed * (linear + speed * quadratic));
}

}  // namespace tiretherm::physics
