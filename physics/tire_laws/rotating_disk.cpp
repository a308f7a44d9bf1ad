// SPDX-License-Identifier: BSD-3-Clause
// Integrates the local films of a rotating disk over a ring: 1/(R^2 - r^2) times the integral of h 2 r dr, split at the
// radius of the transition.

#include "physics/tire_laws/rotating_disk.hpp"

#include <algorithm>
#include <cmath>

namespace tiretherm::physics {

namespace {
constexpr double T_reference = 300.0;  // K
}

double Air::conductivity(double T) { return 0.0263 * std::pow(T / T_reference, conductivity_exponent); }

double Air::viscosity(double T) { return 1.589e-5 * std::pow(T / T_reference, viscosity_exponent); }

RotatingDisk::Film RotatingDisk::mean(double turning, double inner, double outer, double T) const {
    if (turning <= 0.0) {
        return {};
    }
    const double k = Air::conductivity(T);
    const double per_area = turning / Air::viscosity(T);  // Re_r / r^2
    const double between = std::clamp(std::sqrt(transition / per_area), inner, outer);
    const double ring = outer * outer - inner * inner;
    const double of_laminar = (between * between - inner * inner) / ring;
    const double of_turbulent = 2.0 / 2.6 * (std::pow(outer, 2.6) - std::pow(between, 2.6)) / ring;
    return {.laminar = laminar * k * std::sqrt(per_area) * of_laminar,
            .turbulent = turbulent * k * std::pow(per_area, 0.8) * of_turbulent};
}

}  // namespace tiretherm::physics
