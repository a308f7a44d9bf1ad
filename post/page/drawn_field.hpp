// SPDX-License-Identifier: BSD-3-Clause
// Temperatures at the corner points of the drawn cells, interpolated from the nodes of the mesh.
#pragma once

#include <span>
#include <vector>

#include "mesh/mesh.hpp"

namespace tiretherm::post {

/// The temperature at the corners of the cells as they are drawn, interpolated as the channels are, so that a surface
/// shows the temperature of the surface and not that of the outermost cells.
class DrawnField {
public:
    explicit DrawnField(const mesh::Mesh& mesh);

    /// Whether the mesh has places to interpolate between; lumps have none.
    [[nodiscard]] bool exists() const { return !first_.empty(); }
    /// @param temperature [n_nodes] K  @returns [points of the drawing] K
    [[nodiscard]] std::vector<double> at_points(std::span<const double> temperature) const;

private:
    std::vector<std::size_t> first_;  ///< [points + 1] into nodes and weights
    std::vector<int> nodes_;
    std::vector<double> weights_;
};

}  // namespace tiretherm::post
