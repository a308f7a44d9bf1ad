// SPDX-License-Identifier: BSD-3-Clause
// Mixing rules for the moduli of a ply, and moduli at an angle psi to the cords (shear with cos^2 and sin^2 of 2 psi).

#include "physics/tire_laws/cord_rubber.hpp"

#include <cmath>
#include <numbers>

namespace tiretherm::physics {

double CordRubber::share(double diameter, double cords, double thickness, double width) {
    return std::numbers::pi * diameter * diameter / 4.0 * cords / (thickness * width);
}

double Lamina::modulus_at(double angle) const {
    const double c2 = std::cos(angle) * std::cos(angle);
    const double s2 = std::sin(angle) * std::sin(angle);
    return 1.0 / (c2 * c2 / E1 + (1.0 / G12 - 2.0 * nu12 / E1) * s2 * c2 + s2 * s2 / E2);
}

double Lamina::shear_modulus_at(double angle) const {
    const double c = std::cos(2.0 * angle);
    const double s = std::sin(2.0 * angle);
    return 1.0 / (c * c / G12 + ((1.0 + nu12) / E1 + (1.0 + nu21()) / E2) * s * s);
}

Lamina lamina(const CordRubber& ply) {
    const double V = ply.cord_share;
    const double G_c = ply.cord.shear_modulus();
    const double G_r = ply.rubber.shear_modulus();
    return {.E1 = ply.cord.modulus * V + ply.rubber.modulus * (1.0 - V),
            .E2 = ply.rubber.modulus * (1.0 + 2.0 * V) / (1.0 - V),
            .nu12 = ply.cord.poisson * V + ply.rubber.poisson * (1.0 - V),
            .G12 = G_r * (G_c + G_r + (G_c - G_r) * V) / (G_c + G_r - (G_c - G_r) * V)};
}

}  // namespace tiretherm::physics
