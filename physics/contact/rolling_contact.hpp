// SPDX-License-Identifier: BSD-3-Clause
// A tread that rolls on a road: the parameters of interface and road that the effects share which resolve the contact.
#pragma once

#include <array>
#include <cmath>

#include "physics/effect.hpp"
#include "physics/tire_laws/contact.hpp"

namespace tiretherm::physics::rolling_contact {

enum : std::size_t { scale, interface_h, road_conductivity, road_capacity };

inline constexpr ParameterSpec road_conductivity_spec{
    "road_conductivity", "W m-1 K-1", 1.2, 1e-3, 1e3, "of the road; asphalt concrete, 0.7 to 2.5 recalled"};
inline constexpr ParameterSpec road_capacity_spec{
    "road_capacity", "J m-3 K-1", 2.07e6, 1e3, 1e8, "of the road, per volume; asphalt concrete"};
inline constexpr std::array parameters{
    ParameterSpec{"scale", "1", 1.0, 0.0, 10.0, "factor on the whole", false, 0.0},
    ParameterSpec{"interface_h", "W m-2 K-1", 2.5e4, 1.0, 1e7, "conductance between the two surfaces; 1.2e4 to 5.7e4"},
    road_conductivity_spec,
    road_capacity_spec,
};
inline constexpr std::array plausible{
    PlausibleRange{"scale", 0.0, 1.5, "contact areas are known to 20 to 30 %; recalled",
                   "the contact is larger than stated, or another loss is missing"},
    PlausibleRange{"interface_h", 1.2e4, 5.7e4,
                   "Miller, NASA TN D-8161 (1976): 1.2e4 to at least 5.7e4 W/(m2 K) under a rolling car tire",
                   "the contact area or the road's temperature is off"},
    PlausibleRange{"road_conductivity", 0.7, 2.5, "asphalt concrete 1.2 W/(m K), 0.7 to 2.5 recalled",
                   "no asphalt conducts like that; a steel drum does, and should be named"},
    PlausibleRange{"road_capacity", 1.5e6, 2.5e6,
                   "asphalt concrete 2300 kg/m3 and 900 J/(kg K), with voids and moisture; recalled",
                   "no asphalt stores like that"},
};
inline constexpr std::array<std::string_view, 3> reads{"speed", "vertical_load", "road_temperature"};

[[nodiscard]] inline double scale_of(const ActiveEffect& active) { return active[scale]; }

/// sqrt(k rho c) of the road. @returns W s^0.5/(m2 K)
[[nodiscard]] inline double effusivity_of_road(const ActiveEffect& active) {
    return std::sqrt(active[road_conductivity] * active[road_capacity]);
}

/// @param effusivity of the tread, W s^0.5/(m2 K)
[[nodiscard]] inline ContactOfHalfSpaces half_spaces(const ActiveEffect& active, double effusivity) {
    return {.interface_h = active[interface_h], .effusivity_a = effusivity, .effusivity_b = effusivity_of_road(active)};
}

}  // namespace tiretherm::physics::rolling_contact
