// SPDX-License-Identifier: BSD-3-Clause
// Builds the two-node mesh: a surface lump and a bulk lump joined by a link of length dZ (thesis (31)).

#include "mesh/builders.hpp"

namespace tiretherm::mesh {

Mesh build(const TwoNode& description) {
    Mesh mesh;
    mesh.kind = "two_node";
    mesh.layers = {"surface", "bulk"};
    const Point outside{0.0, 0.0, 0.0};
    const Point inside{0.0, 0.0, description.bulk_depth};
    const int surface = mesh.add_cell(description.surface_volume, outside, 0);
    const int bulk = mesh.add_cell(description.bulk_volume, inside, 1);

    mesh.regions = {{.name = "surface", .mean = {{surface}, {1.0}}}, {.name = "bulk", .mean = {{bulk}, {1.0}}}};
    mesh.links = {{.name = "bulk_to_surface", .length = description.bulk_depth, .region = 1}};
    mesh.faces = {{.a = surface, .b = bulk, .area = description.area, .link = 0, .axis = Axis::through}};
    mesh.add_patch_face(mesh.add_patch("outside"), surface, description.area, 0.0, outside, Axis::through);
    mesh.add_patch_face(mesh.add_patch("inside"), bulk, description.area, 0.0, inside, Axis::through);
    mesh.drawing = {
        .shape = CellShape::vertex, .points = {outside, {0.0, 0.0, -description.bulk_depth}}, .corners = {0, 1}};
    return mesh;
}

}  // namespace tiretherm::mesh
