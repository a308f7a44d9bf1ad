// SPDX-License-Identifier: BSD-3-Clause
// Tire resolved around its circumference: a cross-section repeated in equal sectors, in the frame of the turning
// rubber; means around it and values at an angle.
#pragma once

#include <span>
#include <vector>

#include "mesh/mesh.hpp"

namespace tiretherm::mesh {

/// A ring of equal sectors, the first with its middle at angle 0 and the others in the order of growing angle. A sector
/// has the section's cells, with their share of volume and area, and its surface nodes; a cell conducts to the cells
/// before and after it along the arc of its column's mean radius. Patches, regions, layers and zones are the section's,
/// all around; y of a node is its angle times its column's radius. @pre section has columns and no lumped nodes
[[nodiscard]] Mesh ring(const Mesh& section, int sectors);

/// Which sector a node belongs to, -1 for a lumped node. @pre node in the mesh
[[nodiscard]] int sector_of(const Mesh& ring, int node);

/// The same reading as a mean around the circumference: every node's weight is shared among its copies.
[[nodiscard]] Functional around(const Mesh& ring, const Functional& reading);

/// A column of the first sector, which are those that a ring lists, with the nodes of another sector. A section has one sector.
[[nodiscard]] Column in_sector(const Mesh& ring, Column column, int sector);

/// The same reading at an angle in the rubber's frame, straight between the middles of two sectors.
/// @param in_first_sector a reading whose nodes belong to the first sector  @param angle rad
[[nodiscard]] Functional at_angle(const Mesh& ring, const Functional& in_first_sector, double angle);

/// The section that a ring was made of, to be drawn and read: it has nodes, columns and a drawing, but no faces.
[[nodiscard]] Mesh drawn_section(const Mesh& ring);
/// A temperature on a ring, averaged around the circumference. @param temperature [ring.n_nodes]
/// @returns [drawn_section(ring).n_nodes]
[[nodiscard]] std::vector<double> around(const Mesh& ring, std::span<const double> temperature);

}  // namespace tiretherm::mesh
