// SPDX-License-Identifier: BSD-3-Clause
// What follows from the cords and the rubber of a material, to be shown.
#pragma once

#include <optional>
#include <string>

#include "physics/tire_laws/cord_rubber.hpp"

namespace tiretherm::input {

/// What `check` says of a material of cords and rubber.
struct PlySummary {
    std::string material;
    double cord_share = 0.0;                  ///< 1
    double temperature = 0.0;                 ///< K, of the conductivities
    double meridian = 0.0;                    ///< W/(m K)
    double circumference = 0.0;               ///< W/(m K)
    double through = 0.0;                     ///< W/(m K)
    std::optional<physics::Lamina> lamina{};  ///< of one ply
    double modulus_circumference = 0.0;       ///< Pa, of one ply pulled around the circumference; 0 without a lamina
};

}  // namespace tiretherm::input
