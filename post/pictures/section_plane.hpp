// SPDX-License-Identifier: BSD-3-Clause
// Temperatures in the plane of width (or radius) and depth, ready to be drawn.
#pragma once

#include <span>
#include <vector>

#include "solver/problem.hpp"

namespace tiretherm::post {

enum class Shading {
    smooth,  ///< bilinear between cells, surface nodes and the interfaces of layers
    cells,   ///< one colour a cell: what the solver holds, nothing in between
};

/// The temperature in the plane of x (or the radius) and depth; of a block, its plane y = 0.
struct SectionPlane {
    Shading shading = Shading::smooth;
    std::vector<double> x;       ///< m: nodes (smooth) or edges of the cells; ascending
    std::vector<double> depth;   ///< m: as x
    std::vector<double> kelvin;  ///< x runs first
    bool mirrored = false;       ///< the part at -x is the mirror image of the part at x

    [[nodiscard]] double left() const { return mirrored ? -x.back() : x.front(); }
    [[nodiscard]] double right() const { return x.back(); }
    /// Temperatures at all pairs of x and depth, x running first. Columns beyond the mesh hold its edge's value. @returns K
    [[nodiscard]] std::vector<double> sample(std::span<const double> at_x, std::span<const double> at_depth) const;
};

/// @param temperature [n_nodes] K   @pre has_section(problem.mesh)
[[nodiscard]] SectionPlane section_plane(const solver::Problem& problem, std::span<const double> temperature,
                                         Shading shading);

/// Cuts off the outer part of a mirrored plane where, at each depth, it differs from its outer end by less than 5 % of
/// the plane's range: a specimen is made wide so that its rim does not matter. Nothing is cut for less than a third, and
/// never so much that less than the depth is left on either side.
void crop_uniform_rim(SectionPlane& plane);

/// Whether the mesh extends along x as well as through the thickness.
[[nodiscard]] bool has_section(const mesh::Mesh& mesh);

}  // namespace tiretherm::post
