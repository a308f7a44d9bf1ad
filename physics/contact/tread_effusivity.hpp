// SPDX-License-Identifier: BSD-3-Clause
// Effusivity e = sqrt(k rho c) of a tread by its own k(T) and c(T), and quantities of the contact between a few of them:
// a parabola in e/(e + e_road).
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "physics/effect.hpp"

namespace tiretherm::physics {

/// Most effusivities at which what happens in the contact is worked out.
inline constexpr std::size_t most_effusivities = 3;

/// sqrt(k rho c) through the thickness, and its derivative with the temperature.
struct TreadEffusivity {
    double value = 0.0;  ///< W s^0.5/(m2 K)
    double slope = 0.0;  ///< W s^0.5/(m2 K2)
};
/// @param T K
[[nodiscard]] TreadEffusivity effusivity(const Material& material, double T);

/// Fills ActiveEffect::effusivities and effusivity_of_road: one effusivity where the nodes' materials keep theirs, and
/// otherwise the smallest and the largest between -40 and 200 degC and one between them. @pre nodes are placed
void place_effusivities(const PlacementContext& context, double of_road, ActiveEffect& active);

/// Weights with which a quantity known at an effect's effusivities makes that of a node at its temperature. They sum to 1.
class EffusivityInterpolation {
public:
    EffusivityInterpolation(std::span<const double> effusivities, double of_road, const TreadEffusivity& at);
    /// At a node of the effect of this state.
    EffusivityInterpolation(const EvaluationState& state, int node);

    /// @param quantity at each effusivity; entries beyond those placed do not count
    [[nodiscard]] double value(const std::array<double, most_effusivities>& quantity) const {
        return weight_[0] * quantity[0] + weight_[1] * quantity[1] + weight_[2] * quantity[2];
    }
    /// Its derivative with the node's temperature, 1/K of its unit.
    [[nodiscard]] double slope(const std::array<double, most_effusivities>& quantity) const {
        return slope_[0] * quantity[0] + slope_[1] * quantity[1] + slope_[2] * quantity[2];
    }

private:
    std::array<double, most_effusivities> weight_{1.0, 0.0, 0.0};
    std::array<double, most_effusivities> slope_{};
};

}  // namespace tiretherm::physics
