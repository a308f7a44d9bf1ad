// SPDX-License-Identifier: BSD-3-Clause
// Elastic moduli of a belt ply from its cords and rubber, along and at an angle to the cords, and of plies on one another (thesis (53)-(56), errata
// E6, E10, E11).
#pragma once

namespace tiretherm::physics {

/// An elastic material that is the same in all directions.
struct Isotropic {
    double modulus = 0.0;  ///< Pa, Young's modulus, or the storage modulus of a rubber
    double poisson = 0.0;  ///< 1

    /// G = E / (2 (1 + nu))                                                        thesis after (17), erratum E6
    [[nodiscard]] double shear_modulus() const { return modulus / (2.0 * (1.0 + poisson)); }
};

/// A belt ply: parallel cords in rubber.
struct CordRubber {
    Isotropic cord;
    Isotropic rubber;
    double cord_share = 0.0;  ///< 1, V_c: cord volume over ply volume, 0 <= V_c < 1

    /// V_c = (pi D^2/4) n_c / (t l): the cords' sections over the belt's.               thesis (53), erratum E10
    /// @param diameter m, of a cord  @param cords in the width  @param thickness m  @param width m
    [[nodiscard]] static double share(double diameter, double cords, double thickness, double width);
};

/// A ply as a sheet in plane stress, direction 1 along the cords and 2 across.
struct Lamina {
    double E1 = 0.0;    ///< Pa
    double E2 = 0.0;    ///< Pa
    double nu12 = 0.0;  ///< 1, contraction across under a pull along the cords
    double G12 = 0.0;   ///< Pa

    [[nodiscard]] double nu21() const { return nu12 * E2 / E1; }
    /// Modulus of a pull at the angle psi (rad) to the cords:
    ///     1/E_x = cos^4/E1 + (1/G12 - 2 nu12/E1) sin^2 cos^2 + sin^4/E2                               thesis (56)
    [[nodiscard]] double modulus_at(double angle) const;
    /// Shear modulus in axes turned by psi (rad):
    ///     1/G_xy = cos^2(2 psi)/G12 + ((1 + nu12)/E1 + (1 + nu21)/E2) sin^2(2 psi)         thesis (56), erratum E11
    [[nodiscard]] double shear_modulus_at(double angle) const;
};

/// A sheet in plane stress, as it gives way along fixed axes.
struct Sheet {
    double E_x = 0.0;    ///< Pa, pulled along x alone
    double E_y = 0.0;    ///< Pa
    double G_xy = 0.0;   ///< Pa
    double nu_xy = 0.0;  ///< 1, contraction along y under a pull along x
};

/// Plies at +psi and -psi in turn, glued together, without bending (classical lamination: the mean of the plies' stiffnesses,
/// inverted). One ply is free to shear: E_x and G_xy are those of (56), and
///     nu_xy = E_x (nu12/E1 (cos^4 + sin^4) - (1/E1 + 1/E2 - 1/G12) sin^2 cos^2)
/// Plies in pairs hold each other: E_x of a belt's pair is several times that of one of its plies.
/// @param angle psi, rad, of the cords to x  @param plies at least one
[[nodiscard]] Sheet laminate(const Lamina& ply, double angle, int plies);

/// The ply's moduli from its parts.                                                     thesis (54)-(56), erratum E11
///     E1 = E_c V_c + E_r (1 - V_c)        E2 = E_r (1 + 2 V_c)/(1 - V_c)        nu12 = nu_c V_c + nu_r (1 - V_c)
///     G12 = G_r (G_c + G_r + (G_c - G_r) V_c) / (G_c + G_r - (G_c - G_r) V_c)
/// E2 is an estimate for cords far stiffer than the rubber: it does not know E_c, so a ply of one material is not
/// isotropic under it.
[[nodiscard]] Lamina lamina(const CordRubber& ply);

}  // namespace tiretherm::physics
