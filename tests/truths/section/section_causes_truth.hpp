// SPDX-License-Identifier: BSD-3-Clause
// Causes of the section bench as numbers of its equations.
#pragma once

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "section/section_truth.hpp"
#include "two_node/causes_truth.hpp"

namespace hidden_effects {

/// Every number with which a cause enters the section's equations, at the value where it is absent.
struct SectionCauses {
    double camber = 0.0;           ///< 1/rad
    double sidewall = 0.0;         ///< W/K, both together
    double inside_sidewall = 0.0;  ///< W/K
    double liner = 9.0;            ///< W/K
    double rim = 4.0;              ///< W/K
    double pressure = 0.0;         ///< exponent of the gas temperature
    double cornering = 0.0;        ///< 1/N
    double convection = 0.571;     ///< exponent of the speed
    double partition = 0.0;        ///< s/m
    double loss_slope = 0.0;       ///< 1/K
    double load = 0.0;             ///< exponent
    double road_rate = 0.0;        ///< K/h
    double air_rate = 0.0;         ///< K/h
    double slip = 1.0;
    double emissivity = 0.0;                       ///< of the tread's radiation
    std::array<double, 2> conductivity{1.0, 1.0};  ///< tread, carcass
    std::array<double, 2> capacity{1.0, 1.0};
    double shoulder_watts = 0.0;  ///< W per unit of throttle
    double surface_watts = 0.0;
    double crown_watts = 0.0;
    std::vector<Reading> reading{};
};

/// @param before what the bench has without a cause  @param channels of its sensors
[[nodiscard]] SectionCauses gather_section(SectionCauses before, std::span<const std::string_view> channels,
                                           const std::vector<Cause>& causes);

}  // namespace hidden_effects
