// SPDX-License-Identifier: BSD-3-Clause
// Material of a layer: density, c(T), and k(T) along the meridian, along the circumference and through the thickness.
#pragma once

#include <array>
#include <string>

#include "mesh/grid.hpp"
#include "physics/curve.hpp"

namespace tiretherm::physics {

/// What a layer is made of. Conductivities along the meridian, the circumference and through the thickness.
struct Material {
    std::string name;
    double density = 1100.0;            ///< kg/m3
    Curve heat_capacity;                ///< J/(kg K) against K
    std::array<Curve, 3> conductivity;  ///< W/(m K) against K

    [[nodiscard]] const Curve& along(mesh::Axis axis) const { return conductivity[static_cast<std::size_t>(axis)]; }
    friend bool operator==(const Material&, const Material&) = default;
};

}  // namespace tiretherm::physics
