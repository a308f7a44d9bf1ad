// SPDX-License-Identifier: BSD-3-Clause
// What follows from the cords and the rubber of a material, to be shown.
#pragma once

#include <optional>
#include <string>

#include "physics/tire_laws/cord_rubber.hpp"

namespace tiretherm::input {

/// How plies give way in their plane: x around the circumference, y along the meridian.
struct PlyModuli {
    physics::Lamina lamina;  ///< of one ply, along and across its cords
    physics::Sheet ply;      ///< of one ply alone, thesis (56)
    physics::Sheet layer;    ///< of all plies glued together
    int plies = 1;
};

/// What `check` says of a material of cords and rubber.
struct PlySummary {
    std::string material;
    double cord_share = 0.0;     ///< 1
    double temperature = 0.0;    ///< K, of the conductivities
    double meridian = 0.0;       ///< W/(m K)
    double circumference = 0.0;  ///< W/(m K)
    double through = 0.0;        ///< W/(m K)
    std::optional<PlyModuli> elastic{};
};

}  // namespace tiretherm::input
