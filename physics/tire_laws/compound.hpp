// SPDX-License-Identifier: BSD-3-Clause
// The loss tangent that `strain_energy_loss` takes for a layer, as others look at it.
#pragma once

#include "physics/effect.hpp"

namespace tiretherm::physics {

/// Loss tangent of a layer. @param active the effect strain_energy_loss  @param T K  @param frequency Hz
[[nodiscard]] double tan_delta_of(const ActiveEffect& active, int layer, double T, double frequency);

/// The largest loss tangent and where it is.                                                  thesis (49), (61), V.4.4
struct LossPeak {
    double temperature = 0.0;  ///< K, at the frequency f0 of the compound
    double value = 0.0;        ///< 1
    double frequency = 0.0;    ///< Hz, f0

    friend bool operator==(const LossPeak&, const LossPeak&) = default;
};
/// Of a Gaussian that rises on in the cold (`tan_delta_peak` = 0 K) it is a at b, which may lie far below all temperatures.
/// @param active the effect strain_energy_loss
[[nodiscard]] LossPeak loss_peak(const ActiveEffect& active, int layer);

}  // namespace tiretherm::physics
