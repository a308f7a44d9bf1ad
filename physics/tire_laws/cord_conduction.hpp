// SPDX-License-Identifier: BSD-3-Clause
// Heat conduction of a ply of cords in rubber: mixing rules along and across the cords, turned by the cords' angle.
#pragma once

#include <array>

#include "physics/curve.hpp"

namespace tiretherm::physics {

/// The cords of a ply, as far as they conduct heat.
struct ConductingCords {
    double share = 0.0;               ///< 1, V: cord volume over ply volume, 0 <= V <= pi/4    thesis (53), erratum E10
    double conductivity_along = 0.0;  ///< W/(m K), k_c1, along the cord, > 0
    double conductivity_across = 0.0;  ///< W/(m K), k_c2, across it, > 0
};

/// Conductivity of a ply along its cords, where cords and rubber lie side by side: k_1 = V k_c1 + (1 - V) k_r.
/// As E_1 of thesis (54); exact for straight cords.
/// @param k_rubber W/(m K), k_r  @returns W/(m K)
[[nodiscard]] double conductivity_along(const ConductingCords& cords, double k_rubber);

/// Conductivity of a ply across its cords, in its plane and through it (Halpin and Tsai with the shape factor 1):
///     k_2 = k_r (k_c2 + k_r + (k_c2 - k_r) V) / (k_c2 + k_r - (k_c2 - k_r) V)
/// The rule of G_12 in thesis (56) with conductivities for shear moduli: shear along the cords and heat across them
/// obey the same equation. The first term of Rayleigh's series for a square array (1892): up to V = 0.4 within 1 % of
/// its second, whatever the cords conduct. A ply is one row of cords, whose spacing and thickness may differ: with
/// steel cords up to 0.6 of both the rule is within 5 % of the resolved row; of cords of 0.8 of the thickness, two
/// thicknesses apart, it gives 20 % too little through the ply and 11 % too much in its plane.
/// @param k_rubber W/(m K), k_r > 0  @returns W/(m K)
[[nodiscard]] double conductivity_across(const ConductingCords& cords, double k_rubber);

/// Conductivities of a layer of plies with cords at +-psi to the circumference, in the order of mesh::Axis:
///     k_meridian = k_1 sin^2 psi + k_2 cos^2 psi    k_circumference = k_1 cos^2 psi + k_2 sin^2 psi    k_through = k_2
/// The tensor's remaining term, (k_1 - k_2) sin psi cos psi between meridian and circumference, has the sign of psi:
/// in a pair of plies at +psi and -psi the two cancel, a single oblique ply keeps it.
/// A law that is no constant becomes a table every 2 K from 150 to 900 K, where the rubber's is positive, and is held
/// beyond; k_1 alone keeps the rubber's form.
/// @param rubber k_r(T), W/(m K) against K  @param angle rad  @returns [3] W/(m K) against K
[[nodiscard]] std::array<Curve, 3> ply_conductivity(const ConductingCords& cords, const Curve& rubber, double angle);

/// rho = V rho_c + (1 - V) rho_r. @param share 1, V  @param cord kg/m3  @param rubber kg/m3  @returns kg/m3
[[nodiscard]] double ply_density(double share, double cord, double rubber);

/// c = (V rho_c c_c + (1 - V) rho_r c_r(T)) / rho: the heat that both store. It keeps the form of the rubber's law.
struct StoringPart {
    double density = 0.0;  ///< kg/m3
    Curve heat_capacity;   ///< J/(kg K) against K; of the cords a constant
};
/// @param share 1, V  @pre the cords' heat capacity is a constant  @returns J/(kg K) against K
[[nodiscard]] Curve ply_heat_capacity(double share, const StoringPart& cords, const StoringPart& rubber);

}  // namespace tiretherm::physics
