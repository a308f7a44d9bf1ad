// SPDX-License-Identifier: BSD-3-Clause
// Mean temperature of a strip of the surface, weighted by area, against hand calculation.

#include <numbers>

#include <gtest/gtest.h>

#include "mesh/builders.hpp"
#include "mesh/column_probe.hpp"

namespace tiretherm::mesh {

namespace {

using std::numbers::pi;

/// A flat drum, 0.3 m radius: five columns from -50 to 50 mm, 20 mm wide.
Mesh drum() {
    Section section;
    section.meridian = Meridian(0.3, {{0.2, 0.0}});
    section.layers = {{"tread", 0.008, 4}};
    section.zones = {{"crown", 0.10, 5, 1.0, {0}}};
    return build(section);
}

/// The same bent over a circle of radius 0.1 m: columns further out lie nearer to the axis.
Mesh bent() {
    Section section;
    section.meridian = Meridian(0.3, {{0.2, 10.0}});
    section.layers = {{"tread", 0.008, 4}};
    section.zones = {{"crown", 0.10, 5, 1.0, {0}}};
    return build(section);
}

std::vector<double> along(const Mesh& mesh, double at_centre, double slope) {
    std::vector<double> T;
    for (const Point& place : mesh.centre) {
        T.push_back(at_centre + slope * place[0] + 1e4 * place[2]);  // depth must not matter
    }
    return T;
}

}  // namespace

// On a drum every place of the surface counts alike, so T = 300 + 200 s has the mean of the strip's middle. The strip
// from -17 to 36 mm begins inside the second column and ends inside the fifth: 300 + 200 * 0.0095 = 301.9.
TEST(Strip, ReadsALinearTemperatureAtItsMiddle) {
    const Mesh mesh = drum();
    const std::vector<double> T = along(mesh, 300.0, 200.0);
    EXPECT_NEAR(over_strip(mesh, -0.017, 0.036)(T), 301.9, 1e-9);
    EXPECT_NEAR(over_strip(mesh, 0.012, 0.016)(T), 302.8, 1e-9);   // within one column
    EXPECT_NEAR(over_strip(mesh, -0.05, -0.043)(T), 290.7, 1e-9);  // outside of the outermost middle
    EXPECT_NEAR(over_strip(mesh, -0.05, 0.05)(T), 300.0, 1e-9);
}

// Two whole columns weigh by their rings: 2 pi r w. With T = 1 on the inner one and 0 elsewhere the mean is r1/(r1 + r2).
TEST(Strip, WeighsByArea) {
    const Mesh mesh = bent();
    const Column& inner = mesh.columns[3];
    const Column& outer = mesh.columns[4];
    ASSERT_LT(outer.radius, inner.radius - 1e-3);
    std::vector<double> T(mesh.centre.size(), 0.0);
    T[static_cast<std::size_t>(inner.outer)] = 1.0;
    EXPECT_NEAR(over_strip(mesh, 0.01, 0.05)(T), inner.radius / (inner.radius + outer.radius), 1e-12);
    // The patch knows the same areas.
    double area = 0.0;
    for (const PatchFace& face : mesh.patches[0].faces) {
        area += face.node == inner.outer ? face.area : 0.0;
    }
    EXPECT_NEAR(area, 2.0 * pi * inner.radius * 0.02, 1e-12);
}

TEST(Strip, ReadsAConstantTemperatureAsItIs) {
    const Mesh mesh = bent();
    const std::vector<double> T(mesh.centre.size(), 321.0);
    EXPECT_NEAR(over_strip(mesh, -0.049, 0.0123)(T), 321.0, 1e-10);
}

}  // namespace tiretherm::mesh
