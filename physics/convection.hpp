// SPDX-License-Identifier: BSD-3-Clause
// Forced convection of a rolling tire: Nu = 0.318 Re^0.571 on the length 1/L = 1/D + 1/W (thesis (32)).
#pragma once

#include <cmath>

#include "physics/effect.hpp"
#include "physics/tire.hpp"

namespace tiretherm::physics {

/// A law of forced convection: Nu = coefficient Re^exponent on the length 1/L = 1/D + 1/W.      thesis (32)
struct ForcedConvection {
    double coefficient = 0.318;
    double exponent = 0.571;
    double air_conductivity = 0.025;  ///< W/(m K)
    double air_viscosity = 1.5e-5;    ///< m2/s

    /// @returns m, L
    [[nodiscard]] static double length(const Tire& tire) {
        return 1.0 / (1.0 / (2.0 * tire.unloaded_radius) + 1.0 / tire.width);
    }
    /// @param speed m/s
    [[nodiscard]] double reynolds(const Tire& tire, double speed) const {
        return std::abs(speed) * length(tire) / air_viscosity;
    }
    /// @param speed m/s  @returns W/(m2 K)
    [[nodiscard]] double operator()(const Tire& tire, double speed) const {
        return air_conductivity / length(tire) * coefficient * std::pow(reynolds(tire, speed), exponent);
    }
};

/// The law of air_convection, with the thesis's numbers where that is off.
[[nodiscard]] ForcedConvection forced_convection(const PlacementContext& context);

}  // namespace tiretherm::physics
