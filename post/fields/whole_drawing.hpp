// SPDX-License-Identifier: BSD-3-Clause
// The drawing of a mesh made whole: what planes of symmetry cut off is mirrored back; with the lines where layers meet.
#pragma once

#include <array>
#include <vector>

#include "mesh/mesh.hpp"

namespace tiretherm::post {

/// Points and cells of the whole specimen or tire, as a viewer shows it: the folded section or ring of a tire, a block with
/// the parts that its planes of symmetry cut off, a disc as the plane through its axis, on both sides of it.
struct WholeDrawing {
    mesh::CellShape shape = mesh::CellShape::vertex;
    std::vector<mesh::Point> points;  ///< m
    std::vector<int> point;           ///< [points] of the mesh's drawing, which has the same temperature
    std::vector<int> corners;         ///< [cells * corners_per_cell(shape)] into points, in the order of VTK
    std::vector<int> cell;            ///< [cells] of the mesh
    std::vector<double> volume;       ///< [cells] m3; their sum is the volume of the whole tire or specimen
};

[[nodiscard]] WholeDrawing whole_drawing(const mesh::Mesh& mesh);

/// Pairs of points between which a line is to be drawn: the outline of the cells, and where two layers or zones meet. Of
/// solid cells those on their outer surface, which ends at an edge of 30 degrees or more.
[[nodiscard]] std::vector<std::array<int, 2>> borders(const WholeDrawing& drawing, const mesh::Mesh& mesh);

}  // namespace tiretherm::post
