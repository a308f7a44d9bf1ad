// SPDX-License-Identifier: BSD-3-Clause
// Meridian and tire section: geometry against circles and Pappus's theorem, zones, grading, and exact reading of linear
// fields.

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "mesh/builders.hpp"
#include "mesh/probe.hpp"

namespace tiretherm::mesh {

namespace {

using std::numbers::pi;

/// Tread and liner in the middle, wall rubber and liner on both sides: 10 and 6 mm thick.
Section three_zones() {
    Section section;
    section.meridian = Meridian(0.3, {{0.05, 0.0}, {0.10, pi / 0.2}});
    section.layers = {{"tread", 0.008, 4}, {"wall", 0.004, 2}, {"liner", 0.002, 2}};
    section.zones = {{"outside_sidewall", 0.06, 3, 0.5, {1, 2}, false},
                     {"crown", 0.10, 5, 1.0, {0, 2}},
                     {"inside_sidewall", 0.06, 3, 2.0, {1, 2}, false}};
    return section;
}

}  // namespace

// A quarter circle of radius 0.1 m: it ends 0.1 m further out and 0.1 m deeper, facing sideways. Its mean radius is
// R - 0.1 (1 - 2/pi), and the area swept 2 pi times that times its length (Pappus).
TEST(Meridian, FollowsACircle) {
    const Meridian meridian(0.4, {{0.05 * pi, 10.0}});
    const Meridian::ProfilePoint end = meridian.at(0.05 * pi);
    EXPECT_NEAR(end.lateral, 0.1, 1e-15);
    EXPECT_NEAR(end.radius, 0.3, 1e-15);
    EXPECT_NEAR(end.turn, 0.5 * pi, 1e-15);
    EXPECT_NEAR(meridian.mean_radius(0.0, 0.05 * pi), 0.4 - 0.1 * (1.0 - 2.0 / pi), 1e-9);
    // Beyond its last arc it goes straight on, here towards the axis; the other side is its mirror image.
    EXPECT_NEAR(meridian.at(0.05 * pi + 0.02).radius, 0.28, 1e-15);
    EXPECT_NEAR(meridian.at(-0.05 * pi).lateral, -0.1, 1e-15);
    EXPECT_NEAR(meridian.inside(0.05 * pi, 0.01).lateral, 0.09, 1e-15);
    EXPECT_NEAR(meridian.mean_radius(-0.03, 0.03), meridian.mean_radius(0.0, 0.03), 1e-15);
}

TEST(TireSectionMesh, HasTheVolumeOfItsZones) {
    const Section section = three_zones();
    const Mesh mesh = build(section);
    EXPECT_TRUE(defects(mesh).empty());
    EXPECT_EQ(mesh.n_cells, 5 * 6 + 2 * 3 * 4);
    const double tread = 2.0 * pi * section.meridian.mean_radius(-0.05, 0.05) * 0.10 * 0.010;
    const double walls = 2.0 * 2.0 * pi * section.meridian.mean_radius(0.05, 0.11) * 0.06 * 0.006;
    EXPECT_NEAR(mesh.total_volume(), tread + walls, 1e-9 * tread);
    EXPECT_NEAR(mesh.patches[0].area(), tread / 0.010, 1e-9);
    EXPECT_EQ(mesh.patches[1].name, "sidewalls");
    EXPECT_NEAR(mesh.patches[1].area(), walls / 0.006, 1e-9);
    EXPECT_NEAR(mesh.patches[2].area(), tread / 0.010 + walls / 0.006, 1e-9);
}

// Zones are aligned inside: of 10 mm of crown the lower 6 mm meet the wall, over a ring of the border's radius.
TEST(TireSectionMesh, ZonesOfDifferentThicknessMeetWhereTheyOverlap) {
    const Section section = three_zones();
    const Mesh mesh = build(section);
    double border = 0.0;
    for (const Face& face : mesh.faces) {
        const auto a = static_cast<std::size_t>(face.a);
        const auto b = static_cast<std::size_t>(face.b);
        if (face.axis == Axis::meridian && face.b < mesh.n_cells && mesh.zone[a] != mesh.zone[b]) {
            border += face.area;
        }
    }
    EXPECT_NEAR(border, 2.0 * 2.0 * pi * section.meridian.at(0.05).radius * 0.006, 1e-12);
}

TEST(TireSectionMesh, IsGradedTowardsTheCrown) {
    const Mesh mesh = build(three_zones());
    const auto width = [&](std::size_t i) { return mesh.columns[i].to - mesh.columns[i].from; };
    EXPECT_NEAR(width(2) / width(0), 0.5, 1e-12);
    EXPECT_NEAR(width(0), width(10), 1e-12);
    EXPECT_NEAR(mesh.columns.front().from, -0.11, 1e-15);
    EXPECT_NEAR(mesh.columns.back().to, 0.11, 1e-15);
}

// A field that is linear in s and in depth is read exactly inside a zone, at surfaces and beyond the last column.
TEST(TireSectionMesh, ReadsALinearFieldExactly) {
    const Mesh mesh = build(three_zones());
    std::vector<double> T;
    for (const Point& p : mesh.centre) {
        T.push_back(300.0 + 200.0 * p[0] + 1000.0 * p[2]);
    }
    for (const Point& p : {Point{0.013, 0.0, 0.0}, Point{-0.021, 0.0, 0.0043}, Point{0.0, 0.0, 0.010},
                           Point{0.1095, 0.0, 0.003}, Point{-0.07, 0.0, 0.006}}) {
        ASSERT_TRUE(contains(mesh, p));
        EXPECT_NEAR(at_point(mesh, p)(T), 300.0 + 200.0 * p[0] + 1000.0 * p[2], 1e-10) << p[0] << ' ' << p[2];
    }
    EXPECT_FALSE(contains(mesh, {0.12, 0.0, 0.001}));
    EXPECT_FALSE(contains(mesh, {0.09, 0.0, 0.007}));
}

// Folded, the crown is flat at the radius of the tire and the beads stand a quarter circle further in.
TEST(TireSectionMesh, IsDrawnFolded) {
    const Section section = three_zones();
    const Mesh mesh = build(section);
    ASSERT_EQ(mesh.drawing.corners.size(), 4U * static_cast<std::size_t>(mesh.n_cells));
    ASSERT_EQ(mesh.drawing.places.size(), mesh.drawing.points.size());
    double top = 0.0;
    double widest = 0.0;
    for (const Point& p : mesh.drawing.points) {
        top = std::max(top, p[2]);
        widest = std::max(widest, p[0]);
    }
    EXPECT_NEAR(top, 0.3, 1e-12);
    EXPECT_NEAR(widest, section.meridian.inside(0.11, 0.004).lateral, 1e-12);
    for (const Point& place : mesh.drawing.places) {
        EXPECT_TRUE(contains(mesh, place)) << place[0] << ' ' << place[2];
    }
}

TEST(AppendedNodes, AreNamedOnceAndBringARegion) {
    Mesh mesh = build(TwoNode{.area = 1.0, .surface_volume = 0.001, .bulk_volume = 0.01, .bulk_depth = 0.01});
    const int gas = mesh.add_lumped_node("gas");
    EXPECT_EQ(mesh.add_lumped_node("gas"), gas);
    EXPECT_EQ(mesh.n_nodes, 3);
    EXPECT_EQ(mesh.n_cells, 2);
    EXPECT_EQ(mesh.find_lumped_node("gas"), gas);
    EXPECT_EQ(mesh.find_lumped_node("rim"), -1);
    const std::vector<double> T{300.0, 310.0, 320.0};
    EXPECT_EQ(mesh.regions[static_cast<std::size_t>(mesh.find_region("gas"))].mean(T), 320.0);
    EXPECT_FALSE(defects(mesh).empty());  // it is joined to nothing yet
    EXPECT_TRUE(mesh.faces[static_cast<std::size_t>(mesh.add_coupling_face(1, gas, 1.0))].is_coupling);
    EXPECT_TRUE(defects(mesh).empty());
}

}  // namespace tiretherm::mesh
