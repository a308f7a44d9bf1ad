// SPDX-License-Identifier: BSD-3-Clause
// Causes of the two-node bench as numbers of its equations.
#pragma once

#include <string>
#include <vector>

#include "two_node/two_node_truth.hpp"

namespace hidden_effects {

/// What a sensor makes of the temperature it is at; in this order.
struct Reading {
    double emissivity = 1.0;  ///< of what a camera sees
    double tau = 0.0;         ///< s, lag
    double kelvin = 0.0;      ///< offset
    double excess = 0.0;      ///< gain - 1, about 25 degC
};

/// Every number with which a cause enters the bench's equations, at the value where it is absent.
struct Causes {
    double sidewall = 0.0;      ///< W/K
    double liner = 0.0;         ///< W/K, bulk to gas
    double rim = 0.0;           ///< W/K, gas to rim
    double pressure = 0.0;      ///< exponent of the gas temperature
    double cornering = 0.0;     ///< 1/N
    double convection = 0.571;  ///< exponent of the speed
    double partition = 0.0;     ///< s/m
    double loss_slope = 0.0;    ///< 1/K
    double load = 0.0;          ///< exponent
    double wave = 0.0;          ///< 1/(km/h)^2
    double critical = 140.0;    ///< km/h
    double road_rate = 0.0;     ///< K/h
    double air_rate = 0.0;      ///< K/h
    double capacity = 1.0;
    double conductivity = 1.0;
    double slip = 1.0;
    double surface_watts = 0.0;  ///< W per unit of throttle
    double bulk_watts = 0.0;
    Reading surface;
    Reading bulk;
};

[[nodiscard]] Causes gather(const std::vector<Cause>& causes);

}  // namespace hidden_effects
