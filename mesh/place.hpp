// SPDX-License-Identifier: BSD-3-Clause
// Where a node lies, as names and coordinates, and the same as a phrase for messages and reports.
#pragma once

#include <optional>
#include <string>

#include "mesh/mesh.hpp"

namespace tiretherm::mesh {

/// Where a node is, in words and numbers.
struct Place {
    std::string layer;
    std::string zone;                     ///< of a section
    std::string patch;                    ///< the part of the boundary it lies on; empty inside
    std::optional<mesh::Point> position;  ///< m; absent for a lump, which has a temperature but no place
};

[[nodiscard]] Place place_of(const mesh::Mesh& mesh, int node);

/// "tread, on top, radius 0.00 mm, depth 0.00 mm"
[[nodiscard]] std::string describe_place(const mesh::Mesh& mesh, int node);

}  // namespace tiretherm::mesh
