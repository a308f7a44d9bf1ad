// SPDX-License-Identifier: BSD-3-Clause
// A tread that rolls on a road: parameters and effusivities e = sqrt(k rho c) of both, shared by the effects that
// resolve the contact.
#pragma once

#include <array>
#include <cmath>

#include "physics/effect.hpp"
#include "physics/tire_laws/contact.hpp"

namespace tiretherm::physics::rolling_contact {

enum : std::size_t { scale, interface_h, tire_conductivity, tire_capacity, road_conductivity, road_capacity };

inline constexpr std::array parameters{
    ParameterSpec{"scale", "1", 1.0, 0.0, 10.0, "factor on the whole", false, 0.0},
    ParameterSpec{"interface_h", "W m-2 K-1", 2.5e4, 1.0, 1e7, "conductance between the two surfaces; 1.2e4 to 5.7e4"},
    ParameterSpec{"tire_conductivity", "W m-1 K-1", 0.29, 1e-3, 1e3, "of the tread's rubber"},
    ParameterSpec{"tire_capacity", "J m-3 K-1", 1.98e6, 1e3, 1e8, "of the tread's rubber, per volume"},
    ParameterSpec{"road_conductivity", "W m-1 K-1", 1.2, 1e-3, 1e3,
                  "of the road; asphalt concrete, 0.7 to 2.5 recalled"},
    ParameterSpec{"road_capacity", "J m-3 K-1", 2.07e6, 1e3, 1e8, "of the road, per volume; asphalt concrete"},
};
inline constexpr std::array<std::string_view, 3> reads{"speed", "vertical_load", "road_temperature"};

[[nodiscard]] inline double scale_of(const ActiveEffect& active) { return active[scale]; }

[[nodiscard]] inline ContactOfHalfSpaces half_spaces(const ActiveEffect& active) {
    return {.interface_h = active[interface_h],
            .effusivity_a = std::sqrt(active[tire_conductivity] * active[tire_capacity]),
            .effusivity_b = std::sqrt(active[road_conductivity] * active[road_capacity])};
}

}  // namespace tiretherm::physics::rolling_contact
