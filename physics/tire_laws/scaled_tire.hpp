// SPDX-License-Identifier: BSD-3-Clause
// Dimensions and load laws of a tire of which only the size is known: the thesis's 225/50 R17 in proportion.
#pragma once

#include "physics/tire.hpp"

namespace tiretherm::physics {

/// What a size says of a tire, and its inflation.
struct TireOutline {
    double width = 0.225;                 ///< m
    double section_height = 0.1125;       ///< m
    double rim_diameter = 17.0 * 0.0254;  ///< m
    double inflation_pressure = 220e3;    ///< Pa above the atmosphere; that of the thesis's tire
};

/// Vertical stiffness of a belted radial tire (T. B. Rhyne, Tire Science and Technology 33(3), 2005; coefficients as
/// commonly quoted, not checked in the paper):
///     K = 0.00028 p sqrt((1.03 - 0.004 A) W (W A/50 + D)) + 3.45  in kg/mm, p in kPa, width W and rim D in mm, A = 100 H/W
/// For the thesis's tire it gives 245 kN/m, 3 % more than its loaded radius; so only ratios of it are used here.
/// @returns N/m
[[nodiscard]] double vertical_stiffness(const TireOutline& outline);

/// The tire, scaled from the thesis's 225/50 R17, which it gives back for that size at 220 kPa:
///     unloaded radius    rim radius + H + 2.4 mm, the surplus of the thesis's tire; lengths and radii in proportion to it
///     deflection         over the ratio of the vertical stiffnesses; equal deflection makes an equal share of the
///                        limiting contact length
///     contact area       the thesis's mean contact pressure in proportion to the inflation
/// Thicknesses and density stay those of the thesis's tire.
[[nodiscard]] Tire scaled_tire(const TireOutline& outline);

/// The load at which a tire is as far deflected for its size as the thesis's at its 4 kN: width times the length of a chord at an
/// equal share of the section's height, W sqrt(R H), and (pressure)^0.8 as `load_capacity` has it. Within a third of the tables of
/// ETRTO from karts to trucks (recalled). @returns 1, over that of the thesis's tire
[[nodiscard]] double load_ratio(const TireOutline& outline);

}  // namespace tiretherm::physics
