// SPDX-License-Identifier: BSD-3-Clause
// Looks up layer, patch, zone and position of a node and writes them as a phrase.

#include "mesh/place.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace tiretherm::mesh {

Place place_of(const mesh::Mesh& mesh, int node) {
    Place place;
    if (node < 0 || node >= mesh.n_nodes) {
        return place;
    }
    const auto at = static_cast<std::size_t>(node);
    if (const auto layer = static_cast<std::size_t>(mesh.layer[at]); layer < mesh.layers.size()) {
        place.layer = mesh.layers[layer];
    }
    for (const mesh::Patch& patch : mesh.patches) {
        const auto here = [&](const mesh::PatchFace& face) { return face.node == node; };
        if (node >= mesh.n_cells && std::any_of(patch.faces.begin(), patch.faces.end(), here)) {
            place.patch = patch.name;
        }
    }
    if (const int zone = mesh.zone[at]; zone >= 0) {
        place.zone = mesh.zones[static_cast<std::size_t>(zone)];
    }
    for (const mesh::LumpedNode& lumped_node : mesh.lumped_nodes) {
        if (lumped_node.node == node) {
            place.layer = "the " + lumped_node.name;
            return place;
        }
    }
    if (mesh.grid || !mesh.columns.empty()) {
        place.position = mesh.centre[at];
    }
    return place;
}

std::string describe_place(const mesh::Mesh& mesh, int node) {
    const Place place = place_of(mesh, node);
    std::string text = place.layer;
    if (!place.patch.empty()) {
        text += fmt::format("{}on {}", text.empty() ? "" : ", ", place.patch);
    }
    if (place.position) {
        const auto [x, y, depth] = *place.position;
        if (!mesh.grid) {
            return text + fmt::format(", {}, {:.1f} mm along the meridian{}, depth {:.2f} mm", place.zone, 1e3 * x,
                                      mesh.sectors > 1 ? fmt::format(", {:.1f} mm around", 1e3 * y) : "", 1e3 * depth);
        }
        const mesh::Grid& grid = *mesh.grid;
        if (grid.metric == mesh::Metric::axisymmetric) {
            text += fmt::format(", radius {:.2f} mm", 1e3 * x);
        } else if (grid.size(0) > 1) {
            text += fmt::format(", x {:.2f} mm", 1e3 * x);
        }
        if (grid.size(1) > 1) {
            text += fmt::format(", y {:.2f} mm", 1e3 * y);
        }
        text += fmt::format(", depth {:.2f} mm", 1e3 * depth);
    }
    return text;
}

}  // namespace tiretherm::mesh
