// SPDX-License-Identifier: BSD-3-Clause
// Film of the gas in the cavity of a rolling tire: natural convection in the field of the rotation, Nu = c Ra^(1/3)
// (McAdams 1954; Globe & Dropkin 1959).
#pragma once

#include "physics/signals.hpp"
#include "physics/tire.hpp"

namespace tiretherm::physics {

/// Natural convection in the gas that turns with the tire: the liner, at the largest radius, is the floor of the cavity in a
/// field of w^2 r, 200 times gravity at 100 km/h, and the rim its ceiling. A warm liner below a cool rim is the case of a
/// turbulent layer, whose film does not depend on its height:
///
///     Nu = c Ra^(1/3),   h = c k (a rho^2 c_p |T_wall - T_gas| / (T mu k))^(1/3)
///
/// with c = 0.15 of a heated plate that faces upwards (McAdams, Heat Transmission, 1954; as in Incropera & DeWitt (9.31),
/// Ra of 1e7 to 1e11). Two such films in series make 0.15 / 2^(4/3) = 0.060 of the layer between two plates, where Globe &
/// Dropkin, J. Heat Transfer 81, 1959, 24, measured 0.069 Pr^0.074 = 0.067. The Ra of a tire is up to 1e12.
/// Properties are those of air at 320 K: k^(2/3) (T mu)^(-1/3) changes by 2 % from 290 to 370 K.
struct CavityFilm {
    double nusselt = 0.15;  ///< c

    /// h at 1 K between wall and gas; h follows |T_wall - T_gas|^(1/3). @param radius m, of the wall  @returns W/(m2 K^(4/3))
    [[nodiscard]] double at_one_kelvin(const Tire& tire, const Inputs& inputs, double radius) const;
};

/// Density of the gas that fills the cavity: air of 20 degC at the inflation pressure; where that is not given at the tire's
/// reference pressure, or at 220 kPa. @returns kg/m3
[[nodiscard]] double gas_density(const Tire& tire, const Inputs& inputs);

}  // namespace tiretherm::physics
