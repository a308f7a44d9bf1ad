// SPDX-License-Identifier: BSD-3-Clause
// Mixing rules for the moduli of a ply, moduli at an angle psi to the cords (shear with cos^2 and sin^2 of 2 psi), and of
// plies at +psi and -psi.

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

Sheet laminate(const Lamina& ply, double angle, int plies) {
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    const double c2 = c * c;
    const double s2 = s * s;
    // Stiffnesses of one ply along its cords, then along x and y; 16 and 26 couple pull and shear.
    const double held = 1.0 - ply.nu12 * ply.nu21();
    const double Q11 = ply.E1 / held;
    const double Q22 = ply.E2 / held;
    const double Q12 = ply.nu12 * Q22;
    const double both = Q12 + 2.0 * ply.G12;
    const double A11 = Q11 * c2 * c2 + 2.0 * both * s2 * c2 + Q22 * s2 * s2;
    const double A22 = Q11 * s2 * s2 + 2.0 * both * s2 * c2 + Q22 * c2 * c2;
    const double A12 = (Q11 + Q22 - 4.0 * ply.G12) * s2 * c2 + Q12 * (c2 * c2 + s2 * s2);
    const double A66 = (Q11 + Q22 - 2.0 * Q12) * s2 * c2 + ply.G12 * (c2 - s2) * (c2 - s2);
    // Of plies at +psi and -psi the couplings cancel but for the one that is left over.
    const double over = plies % 2 == 0 ? 0.0 : 1.0 / plies;
    const double A16 = over * ((Q11 - both) * c2 - (Q22 - both) * s2) * s * c;
    const double A26 = over * ((Q11 - both) * s2 - (Q22 - both) * c2) * s * c;
    // The inverse of the symmetric matrix, by its cofactors.
    const double C11 = A22 * A66 - A26 * A26;
    const double C22 = A11 * A66 - A16 * A16;
    const double C12 = A16 * A26 - A12 * A66;
    const double C66 = A11 * A22 - A12 * A12;
    const double determinant = A11 * C11 + A12 * C12 + A16 * (A12 * A26 - A22 * A16);
    return {.E_x = determinant / C11, .E_y = determinant / C22, .G_xy = determinant / C66, .nu_xy = -C12 / C11};
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
