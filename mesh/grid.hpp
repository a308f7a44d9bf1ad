// SPDX-License-Identifier: BSD-3-Clause
// Structured part of a mesh: axes, metric (Cartesian, axisymmetric, cylindrical), cell edges and surface nodes of a
// tensor product of cells.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace tiretherm::mesh {

using Point = std::array<double, 3>;

/// Directions of a tire: along the meridian (or the radius about a laser's axis), along the circumference, through the thickness.
enum class Axis : std::uint8_t { meridian = 0, circumference = 1, through = 2 };

/// Axisymmetric: the first axis is a radius. Cylindrical: the depth goes along a radius, inwards from `outer_radius`; the
/// second axis is the arc at the outer surface.
enum class Metric : std::uint8_t { cartesian, axisymmetric, cylindrical };

/// As files of results call it.
[[nodiscard]] constexpr std::string_view name_of(Metric metric) {
    switch (metric) {
        case Metric::cartesian:
            return "cartesian";
        case Metric::axisymmetric:
            return "axisymmetric";
        case Metric::cylindrical:
            return "cylindrical";
    }
    return "";
}

/// A run of cells up to the coordinate `to`; `ratio` is the last cell's width over the first's (geometric in between).
struct Segment {
    double to = 0.0;
    int cells = 1;
    double ratio = 1.0;
};

/// Edges of the cells of consecutive segments. @param from first edge, m  @returns [sum of cells + 1] m, ascending
[[nodiscard]] std::vector<double> edges(double from, const std::vector<Segment>& segments);

/// The four sides around and the two faces of a tensor-product mesh, in the order of Grid::surface.
enum class Side : std::uint8_t { x_min, x_max, y_min, y_max, z_min, z_max };

/// Cells as a tensor product, and the surface nodes on its sides: what interpolation needs.
struct Grid {
    Metric metric = Metric::cartesian;
    double outer_radius = 0.0;                  ///< m, of a cylinder
    std::array<std::vector<double>, 3> edge;    ///< [n + 1] m for each axis
    std::array<std::vector<double>, 3> centre;  ///< [n] m
    std::array<bool, 3> mirror{};               ///< the field is even about the lower end of this axis
    std::array<std::vector<int>, 6> surface;    ///< node of each boundary face of a side, empty where there is no patch

    [[nodiscard]] int size(int axis) const { return static_cast<int>(centre[static_cast<std::size_t>(axis)].size()); }
    [[nodiscard]] int cell(int i, int j, int k) const { return i + size(0) * (j + size(1) * k); }
    [[nodiscard]] int surface_node(Side side, int i, int j, int k) const;
};

}  // namespace tiretherm::mesh
