// SPDX-License-Identifier: BSD-3-Clause
// Meshes of lumps, layers, blocks and discs: volumes, areas, faces and drawn cells against geometry; defects are named.

#include "mesh/builders.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace tiretherm::mesh {

namespace {

const std::vector<Layer> two_layers{{.name = "tread", .thickness = 0.003, .cells = 4, .ratio = 2.0},
                                    {.name = "bulk", .thickness = 0.012, .cells = 6, .ratio = 3.0}};

Block small_block(bool quarter) {
    return {.x = {{.to = 0.006, .cells = 3}, {.to = 0.03, .cells = 4, .ratio = 3.0}},
            .y = {{.to = 0.02, .cells = 5}},
            .stack = two_layers,
            .quarter = quarter,
            .side_patches = true};
}

/// How many faces meet at a node.
std::size_t faces_of(const Mesh& mesh, int node) {
    std::size_t count = 0;
    for (const Face& face : mesh.faces) {
        count += face.a == node || face.b == node ? 1U : 0U;
    }
    return count;
}

}  // namespace

TEST(TwoNodeMesh, IsTwoLumpsAndOneLink) {
    const Mesh mesh =
        build(TwoNode{.area = 0.4677, .surface_volume = 8.4e-4, .bulk_volume = 4.8e-3, .bulk_depth = 0.01});
    EXPECT_TRUE(defects(mesh).empty());
    EXPECT_EQ(mesh.n_nodes, 2);
    ASSERT_EQ(mesh.faces.size(), 1U);
    EXPECT_EQ(mesh.faces[0].half_a + mesh.faces[0].half_b, 0.0);
    EXPECT_EQ(mesh.links[0].length, 0.01);
    EXPECT_EQ(mesh.links[0].region, mesh.find_region("bulk"));
    EXPECT_EQ(mesh.patches[static_cast<std::size_t>(mesh.find_patch("outside"))].faces[0].node, 0);
}

TEST(LayersMesh, VolumeAndThicknessAreThoseOfTheStack) {
    const Mesh mesh = build(Layers{.area = 0.4677, .stack = two_layers});
    EXPECT_TRUE(defects(mesh).empty());
    EXPECT_EQ(mesh.n_cells, 10);
    EXPECT_EQ(mesh.n_nodes, 12);  // a surface node outside and one inside
    EXPECT_NEAR(mesh.total_volume(), 0.4677 * 0.015, 1e-15);
    EXPECT_NEAR(mesh.patches[0].area(), 0.4677, 1e-15);
    EXPECT_EQ(mesh.drawing.shape, CellShape::line);
}

TEST(LayersMesh, LinkSitsOnTheOneFaceBelowItsLayer) {
    const Mesh mesh = build(Layers{.area = 1.0, .stack = two_layers, .link_below = 0, .link_length = 0.01});
    int linked = 0;
    for (const Face& face : mesh.faces) {
        if (face.link == 0) {
            ++linked;
            EXPECT_EQ(face.a, 3);  // last cell of the tread
            EXPECT_EQ(face.b, 4);
        }
    }
    EXPECT_EQ(linked, 1);
}

TEST(BlockMesh, QuarterAndWholeAgreeInSize) {
    const Mesh quarter = build(small_block(true));
    Block whole_description = small_block(false);
    whole_description.x = {{.to = -0.006, .cells = 4, .ratio = 1.0 / 3.0},
                           {.to = 0.006, .cells = 6},
                           {.to = 0.03, .cells = 4, .ratio = 3.0}};
    whole_description.y = {{.to = 0.02, .cells = 10}};
    const Mesh whole = build(whole_description);
    EXPECT_TRUE(defects(quarter).empty());
    EXPECT_TRUE(defects(whole).empty());
    EXPECT_NEAR(quarter.total_volume(), 0.03 * 0.02 * 0.015, 1e-18);
    EXPECT_NEAR(whole.total_volume(), 4.0 * quarter.total_volume(), 1e-17);
    EXPECT_EQ(quarter.patches.size(), 4U);  // right, back, top, bottom: the symmetry planes are adiabatic
    EXPECT_EQ(whole.patches.size(), 6U);
}

TEST(BlockMesh, InnerCellHasSixFacesAndCornerCellItsPatches) {
    const Mesh mesh = build(small_block(true));
    const Grid& grid = *mesh.grid;
    EXPECT_EQ(faces_of(mesh, grid.cell(1, 1, 1)), 6U);
    // At x = y = 0 on top: three neighbours and one surface node; at the outer corner: three and three.
    EXPECT_EQ(faces_of(mesh, grid.cell(0, 0, 0)), 4U);
    EXPECT_EQ(faces_of(mesh, grid.cell(6, 4, 0)), 6U);
}

TEST(AxisymmetricMesh, VolumesAndAreasAreThoseOfADisc) {
    const Mesh mesh = build(Axisymmetric{.radius = {{.to = 0.006, .cells = 5}, {.to = 0.04, .cells = 7, .ratio = 4.0}},
                                         .stack = two_layers,
                                         .side_patches = true});
    constexpr double pi = std::numbers::pi;
    EXPECT_TRUE(defects(mesh).empty());
    EXPECT_NEAR(mesh.total_volume(), pi * 0.04 * 0.04 * 0.015, 1e-17);
    EXPECT_NEAR(mesh.patches[static_cast<std::size_t>(mesh.find_patch("top"))].area(), pi * 0.04 * 0.04, 1e-15);
    EXPECT_NEAR(mesh.patches[static_cast<std::size_t>(mesh.find_patch("rim"))].area(), 2.0 * pi * 0.04 * 0.015, 1e-15);
}

TEST(AxisymmetricMesh, FluxOfARegularFieldIsExactOnEqualRings) {
    // T = r^2 has the flux k dT/dr = 2 r through r: (T_b - T_a) / (half_a + half_b) must be 2 r at every inner face, the
    // first one beside the axis included. k = 1.
    const Mesh mesh = build(Axisymmetric{.radius = {{.to = 0.04, .cells = 9}},
                                         .stack = {{.name = "disc", .thickness = 0.001, .cells = 1}}});
    int inner_faces = 0;
    for (const Face& face : mesh.faces) {
        if (face.axis == Axis::meridian) {
            ++inner_faces;
            const double r_a = mesh.centre[static_cast<std::size_t>(face.a)][0];
            const double r_b = mesh.centre[static_cast<std::size_t>(face.b)][0];
            const double r = face.area / (2.0 * std::numbers::pi * 0.001);
            EXPECT_NEAR((r_b * r_b - r_a * r_a) / (face.half_a + face.half_b), 2.0 * r, 1e-15);
        }
    }
    EXPECT_EQ(inner_faces, 8);
}

TEST(Drawing, EveryCellHasItsCornersInsideThePointList) {
    for (const Mesh& mesh : {build(small_block(true)), build(Layers{.area = 1.0, .stack = two_layers}),
                             build(Axisymmetric{.radius = {{.to = 0.04, .cells = 7}}, .stack = two_layers})}) {
        ASSERT_EQ(mesh.drawing.corners.size(),
                  static_cast<std::size_t>(mesh.n_cells * corners_per_cell(mesh.drawing.shape)));
        for (const int corner : mesh.drawing.corners) {
            ASSERT_GE(corner, 0);
            ASSERT_LT(corner, static_cast<int>(mesh.drawing.points.size()));
        }
    }
}

TEST(Drawing, HexahedraHavePositiveVolumeInTheOrderOfVtk) {
    // VTK wants the first four corners anticlockwise seen from the fifth: (p1 - p0) x (p3 - p0) . (p4 - p0) > 0.
    const Mesh mesh = build(small_block(true));
    double total = 0.0;
    for (int cell = 0; cell < mesh.n_cells; ++cell) {
        const auto corner = [&](int i) {
            return mesh.drawing
                .points[static_cast<std::size_t>(mesh.drawing.corners[static_cast<std::size_t>(8 * cell + i)])];
        };
        const auto edge = [&](int i) {
            return Point{corner(i)[0] - corner(0)[0], corner(i)[1] - corner(0)[1], corner(i)[2] - corner(0)[2]};
        };
        const Point u = edge(1);
        const Point v = edge(3);
        const Point w = edge(4);
        const double volume = (u[1] * v[2] - u[2] * v[1]) * w[0] + (u[2] * v[0] - u[0] * v[2]) * w[1] +
                              (u[0] * v[1] - u[1] * v[0]) * w[2];
        ASSERT_GT(volume, 0.0);
        total += volume;
    }
    EXPECT_NEAR(total, mesh.total_volume(), 1e-12 * total);
}

TEST(Defects, NamesEveryFaultOfAMesh) {
    Mesh mesh = build(Layers{.area = 1.0, .stack = {{.name = "a", .thickness = 0.01, .cells = 2}}});
    mesh.volume[1] = -1.0;
    mesh.faces[0].area = 0.0;
    mesh.n_nodes += 1;
    mesh.volume.push_back(0.0);
    mesh.centre.push_back({});
    mesh.layer.push_back(0);
    const std::vector<std::string> found = defects(mesh);
    // The negative volume, the face without area and the lonely node.
    ASSERT_EQ(found.size(), 3U);
    EXPECT_NE(found[0].find("volume -1"), std::string::npos);
    EXPECT_NE(found[1].find("area 0"), std::string::npos);
    EXPECT_NE(found[2].find("joined to no other"), std::string::npos);
}

}  // namespace tiretherm::mesh
