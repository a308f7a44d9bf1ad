// SPDX-License-Identifier: BSD-3-Clause
// Measured places as weighted sums of node temperatures: at a point, over a disc, over a patch, over a layer or zone.
#pragma once

#include "mesh/mesh.hpp"

namespace tiretherm::mesh {

/// Temperature at a point, second order in the cell size: linear between nodes, using surface nodes where the point is
/// next to one, an even parabola about a plane of symmetry or the axis, linear beyond the outermost nodes.
/// @param point m; z is the depth. Axisymmetric: x is the radius; section: x is the arc length along the meridian.
/// @pre the mesh has a grid or columns and contains the point
[[nodiscard]] Functional at_point(const Mesh& mesh, const Point& point);

/// Whether a point lies in the mesh (its boundary included).
[[nodiscard]] bool contains(const Mesh& mesh, const Point& point);

/// Mean over a disc of a patch, each face by the share of the disc that it covers.
/// @param radius m, > 0; the disc is centred on the patch's x = y = 0
[[nodiscard]] Functional over_disc(const Mesh& mesh, int patch, double radius);

/// Area-weighted mean over a patch.
[[nodiscard]] Functional over_patch(const Mesh& mesh, int patch);

/// Volume-weighted mean over the cells of a layer, of a zone, or of a layer within a zone.
/// @param layer, zone index, -1: any
[[nodiscard]] Functional over_cells(const Mesh& mesh, int layer, int zone = -1);

/// Area of each face of a patch that a disc about x = y = 0 covers, exactly. @returns [faces of the patch] m2
[[nodiscard]] std::vector<double> disc_overlap(const Mesh& mesh, int patch, double radius);

/// Integral over each face of a patch of the normalised Gaussian 2/(pi w^2) exp(-2 r^2/w^2). @param waist w, m
[[nodiscard]] std::vector<double> gaussian_overlap(const Mesh& mesh, int patch, double waist);

}  // namespace tiretherm::mesh
