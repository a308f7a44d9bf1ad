// SPDX-License-Identifier: BSD-3-Clause
// What an effect sliding_friction puts into the tread, for those who read the temperature at an edge of the contact.
#pragma once

#include <span>

#include "physics/effect.hpp"
#include "physics/tire_laws/contact.hpp"

namespace tiretherm::physics {

/// The power of sliding in the contact, whole: before road and tire share it. W
struct FrictionPower {
    double along = 0.0;   ///< of drive and brakes
    double across = 0.0;  ///< of cornering
};
/// By the law of the effect sliding_friction, its factors and switches included. @param inputs after input corrections
[[nodiscard]] FrictionPower friction_power(const ActiveEffect& sliding, const Tire& tire, const Inputs& inputs);

/// Heat of sliding that enters the tread, before the road takes anything back, and where it enters.
struct EnteredHeat {
    double watts = 0.0;
    SlidingHeat enters = SlidingHeat::in_tread;
};

/// @param coefficients of the effect sliding_friction at a moment  @param effusivity of the tread, W s^0.5/(m2 K)
[[nodiscard]] EnteredHeat heat_of_sliding(const ActiveEffect& sliding, std::span<const double> coefficients,
                                          double effusivity);

}  // namespace tiretherm::physics
