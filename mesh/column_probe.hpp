// SPDX-License-Identifier: BSD-3-Clause
// Temperatures at points and over strips of a cross-section or ring, whose cells stand in columns through the
// thickness; mesh/probe.hpp asks here for meshes that have columns.
#pragma once

#include <cstddef>

#include "mesh/mesh.hpp"

namespace tiretherm::mesh {

/// Index of the column at a place of the meridian, -1 outside. @param s m
[[nodiscard]] std::ptrdiff_t column_at(const Mesh& mesh, double s);

/// @param point arc length along the meridian, arc from angle 0 of a ring (else anything), depth below the column's outer surface; m
[[nodiscard]] bool in_columns(const Mesh& mesh, const Point& point);

/// Temperature at a point, linear in depth, between columns of the same thickness and between sectors of a ring. @pre in_columns
[[nodiscard]] Functional at_column_point(const Mesh& mesh, const Point& point);

/// Mean over the outer surface between two places of the meridian, by area; exact for a temperature that is linear along
/// the meridian, also where the strip ends inside a column. @param from, to m, from < to  @pre both within the columns
[[nodiscard]] Functional over_strip(const Mesh& mesh, double from, double to);

}  // namespace tiretherm::mesh
