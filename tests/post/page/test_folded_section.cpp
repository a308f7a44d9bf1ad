// SPDX-License-Identifier: BSD-3-Clause
// The shape of a drawn cross-section: arcs that are coarse in cells are round, and places lie where the meridian has them.
#include "post/page/folded_section.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "mesh/builders.hpp"

namespace tiretherm::post {
namespace {

constexpr double crown_radius = 0.3;
constexpr double arc_radius = 0.06;
constexpr double thickness = 0.01;

/// A profile that is one half circle of 60 mm about (0, 240 mm), from bead to bead, in 9 columns of 20 degrees.
mesh::Mesh half_circle() {
    const double half = 0.5 * std::numbers::pi * arc_radius;
    mesh::Section d;
    d.meridian = mesh::Meridian(crown_radius, {{half, 1.0 / arc_radius}});
    d.layers = {{"rubber", thickness, 4}};
    d.zones = {{"wall", 2.0 * half, 9, 1.0, {0}}};
    return mesh::build(d);
}

double from_centre(const FoldedSection::Place& place) {
    return std::hypot(place[0], place[1] - (crown_radius - arc_radius));
}

// The chord of 20 degrees, L = 20.84 mm, lies 60 mm (1 - cos 10 deg) = 0.91153 mm inside of its circle. A parabola through the
// same three points leaves the circle by 1.2 um at a quarter: sqrt(60^2 - (L/4)^2) - 60 cos 10 deg = 0.68486 mm against
// 0.75 x 0.91153 mm = 0.68365 mm.
TEST(FoldedSection, CoarseCellsOfAnArcAreRound) {
    const mesh::Mesh mesh = half_circle();
    const FoldedSection section(mesh);
    for (const mesh::Column& column : mesh.columns) {
        for (int k = 0; k < column.cells(); ++k) {
            const double outer = arc_radius - column.edge[static_cast<std::size_t>(k)];
            const double inner = arc_radius - column.edge[static_cast<std::size_t>(k) + 1];
            for (const double u : {0.0, 0.5, 1.0}) {
                EXPECT_NEAR(from_centre(section.in_cell(column.first_cell + k, u, 1.0)), outer, 1e-9);
                EXPECT_NEAR(from_centre(section.in_cell(column.first_cell + k, u, 0.0)), inner, 1e-9);
            }
            EXPECT_NEAR(from_centre(section.in_cell(column.first_cell + k, 0.25, 1.0)), outer, 1.3e-6);
        }
    }
}

// 30 mm along the meridian are half a radian of the circle, 4 mm below its outer side. Along its chord a place moves evenly, along
// the arc by its sine: 60 mm (sin a - a/10 deg sin 10 deg) is at most 20 um.
TEST(FoldedSection, PlacesLieWhereTheMeridianHasThem) {
    const mesh::Mesh mesh = half_circle();
    const auto place = FoldedSection(mesh).place(0.03, 0.004);
    ASSERT_TRUE(place);
    EXPECT_NEAR((*place)[0], 0.056 * std::sin(0.5), 2e-5);
    EXPECT_NEAR((*place)[1], crown_radius - arc_radius + 0.056 * std::cos(0.5), 2e-5);
    EXPECT_FALSE(FoldedSection(mesh).place(0.1, 0.004));
}

// Two layers in three columns of two zones: a line between the layers in each column, and one where the zones meet.
TEST(FoldedSection, LinesStandWhereLayersAndZonesMeet) {
    mesh::Section d;
    d.meridian = mesh::Meridian(crown_radius, {{0.1, 0.0}});
    d.layers = {{"tread", 0.008, 2}, {"belt", 0.004, 2}};
    d.zones = {{"crown", 0.06, 2, 1.0, {0, 1}}, {"shoulder", 0.03, 1, 1.0, {0, 1}}};
    const mesh::Mesh mesh = mesh::build(d);
    const FoldedSection section(mesh);
    EXPECT_EQ(std::ranges::count(section.borders(), true, &FoldedSection::Border::of_zones), 1);
    EXPECT_EQ(std::ranges::count(section.borders(), false, &FoldedSection::Border::of_zones), 3);
    for (const FoldedSection::Border& border : section.borders()) {
        if (!border.of_zones) {
            EXPECT_NEAR(border.line.front()[1], crown_radius - 0.008, 1e-12);
        }
    }
}

}  // namespace
}  // namespace tiretherm::post
