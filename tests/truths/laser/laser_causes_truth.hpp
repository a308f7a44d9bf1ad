// SPDX-License-Identifier: BSD-3-Clause
// Causes of the laser bench as numbers of its equations.
#pragma once

#include <array>
#include <vector>

#include "laser/laser_bench_truth.hpp"
#include "two_node/causes_truth.hpp"

namespace hidden_effects {

/// Every number with which a cause enters the laser's equations, at the value where it is absent.
struct LaserCauses {
    double absorbed = 1.0;                               ///< factor on the light
    double fall = 0.0;                                   ///< 1/h
    double spot = 1.0;                                   ///< factor on the radius
    std::array<double, 2> conductivity{1.0, 1.0};        ///< tread, bulk
    std::array<double, 2> conductivity_slope{0.0, 0.0};  ///< 1/K, over k at 20 degC
    std::array<double, 2> capacity{1.0, 1.0};
    double emissivity = 0.0;
    double natural = 0.0;
    double lamp_watts = 0.0;
    double hourly_watts = 0.0;
    std::array<Reading, laser_channels.size()> reading;
};

[[nodiscard]] LaserCauses gather_laser(const std::vector<Cause>& causes);

}  // namespace hidden_effects
