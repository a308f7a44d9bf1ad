// SPDX-License-Identifier: BSD-3-Clause
// Forced convection of a rolling tire: Nu = 0.318 Re^0.571 on the length 1/L = 1/D + 1/W (thesis (32)).
#pragma once

#include <cmath>

#include "physics/tire.hpp"

namespace tiretherm::physics {

/// A law of forced convection: Nu = coefficient Re^exponent on the length 1/L = 1/D + 1/W.      thesis (32)
struct ForcedConvection {
    double coefficient = 0.318;
    double exponent = 0.571;
    double air_conductivity = 0.025;  ///< W/(m K)
    double air_viscosity = 1.5e-5;    ///< m2/s

    /// @param speed m/s  @returns W/(m2 K)
    [[nodiscard]] double operator()(const Tire& tire, double speed) const {
        const double length = 1.0 / (1.0 / (2.0 * tire.unloaded_radius) + 1.0 / tire.width);
        const double reynolds = std::abs(speed) * length / air_viscosity;
        return air_conductivity / length * coefficient * std::pow(reynolds, exponent);
    }
};

}  // namespace tiretherm::physics
