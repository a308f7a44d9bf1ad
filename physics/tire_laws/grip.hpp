// SPDX-License-Identifier: BSD-3-Clause
// Friction between tread and road against the temperature of the surface: adhesion, hysteresis and wear (thesis (30)).
#pragma once

#include <functional>

#include "physics/curve.hpp"

namespace tiretherm::physics {

/// Friction of the tread as the sum of its parts, F_T = F_A + F_Hb + F_C, over the load.                   thesis (30)
///     mu(T) = mu_A(T) + mu_Hb tan delta(T)/tan delta(T_ref) + mu_C
/// Hysteresis follows the loss tangent at the frequency of the road's asperities, whose peak makes an optimum; adhesion, with
/// the real contact area in it, is a law of temperature that somebody measured; wear stays. The thesis states that friction
/// follows tan delta and that wear is at most 2 % of it, and prints no law.
struct Grip {
    Curve adhesion{};                       ///< mu_A against K, >= 0
    double hysteresis = 0.0;                ///< mu_Hb at the reference temperature
    double wear = 0.0;                      ///< mu_C
    double reference_temperature = 313.15;  ///< K, of the surface
    double frequency = 1e3;                 ///< Hz, sliding at 1 m/s over asperities 1 mm apart

    /// mu(T)/mu(T_ref). @param T_surface K  @param tan_delta of the tread at a temperature in K and `frequency`
    [[nodiscard]] double value(double T_surface, const std::function<double(double)>& tan_delta) const;
};

}  // namespace tiretherm::physics
