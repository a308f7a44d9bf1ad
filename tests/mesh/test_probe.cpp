// SPDX-License-Identifier: BSD-3-Clause
// Probes and surface means: exact for linear fields, and overlaps with discs and Gaussian beams against areas.

#include "mesh/probe.hpp"

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "mesh/builders.hpp"

namespace tiretherm::mesh {

namespace {

using std::numbers::pi;
const std::vector<Layer> stack{{.name = "tread", .thickness = 0.003, .cells = 4, .ratio = 2.0},
                               {.name = "bulk", .thickness = 0.012, .cells = 6, .ratio = 3.0}};

std::vector<double> field(const Mesh& mesh, const std::function<double(const Point&)>& f) {
    std::vector<double> values;
    for (const Point& place : mesh.centre) {
        values.push_back(f(place));
    }
    return values;
}

Mesh block(bool quarter, bool sides) {
    return build(Block{.x = {{.to = 0.006, .cells = quarter ? 3 : 5}, {.to = 0.03, .cells = 6, .ratio = 3.0}},
                       .y = {{.to = 0.02, .cells = 5}},
                       .stack = stack,
                       .quarter = quarter,
                       .side_patches = sides});
}

}  // namespace

TEST(Probe, ReproducesALinearFieldEverywhere) {
    // Linear interpolation and extrapolation are exact for a linear field, on corners and edges too.
    const Mesh mesh = block(false, true);
    const auto linear = [](const Point& p) { return 300.0 + 1000.0 * p[0] - 500.0 * p[1] + 2000.0 * p[2]; };
    const std::vector<double> T = field(mesh, linear);
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    for (int i = 0; i < 200; ++i) {
        Point p{-0.03 + 0.06 * unit(random), -0.02 + 0.04 * unit(random), 0.015 * unit(random)};
        for (std::size_t axis = 0; axis < 3; ++axis) {  // half of the coordinates on a side
            if (unit(random) < 0.25) {
                p[axis] = mesh.grid->edge[axis].front();
            } else if (unit(random) < 0.25) {
                p[axis] = mesh.grid->edge[axis].back();
            }
        }
        ASSERT_TRUE(contains(mesh, p));
        EXPECT_NEAR(at_point(mesh, p)(T), linear(p), 1e-10);
    }
}

TEST(Probe, OnThePlaneOfSymmetryAnEvenParabolaIsExact) {
    const Mesh mesh = block(true, false);
    const auto even = [](const Point& p) { return 400.0 - 1e5 * p[0] * p[0] + 2e5 * p[1] * p[1] - 1000.0 * p[2]; };
    EXPECT_NEAR(at_point(mesh, {0.0, 0.0, 0.0})(field(mesh, even)), 400.0, 1e-10);
    EXPECT_NEAR(at_point(mesh, {0.0, 0.0, 0.015})(field(mesh, even)), 385.0, 1e-10);
}

TEST(Probe, UsesTheSurfaceNodeOnTheSurface) {
    const Mesh mesh = block(true, false);
    std::vector<double> T(static_cast<std::size_t>(mesh.n_nodes), 300.0);
    for (const PatchFace& face : mesh.patches[static_cast<std::size_t>(mesh.find_patch("top"))].faces) {
        T[static_cast<std::size_t>(face.node)] = 350.0;
    }
    EXPECT_NEAR(at_point(mesh, {0.004, 0.003, 0.0})(T), 350.0, 1e-12);
    EXPECT_NEAR(at_point(mesh, {0.004, 0.003, 0.015})(T), 300.0, 1e-12);
}

TEST(Probe, ContainsSaysWhatIsOutside) {
    const Mesh mesh = block(true, false);
    EXPECT_TRUE(contains(mesh, {0.03, 0.02, 0.015}));
    EXPECT_FALSE(contains(mesh, {0.031, 0.0, 0.0}));
    EXPECT_FALSE(contains(mesh, {0.0, 0.0, -0.001}));
}

TEST(DiscOverlap, AddsUpToTheDisc) {
    // A radius that cuts cells: a quarter of the disc falls on the quarter block, all of it on the whole one.
    const double a = 5.6419e-3;
    const auto total = [&](const Mesh& mesh) {
        double sum = 0.0;
        for (const double area : disc_overlap(mesh, mesh.find_patch("top"), a)) {
            sum += area;
        }
        return sum;
    };
    EXPECT_NEAR(total(block(true, false)), 0.25 * pi * a * a, 1e-16);
    EXPECT_NEAR(total(block(false, false)), pi * a * a, 1e-16);
    EXPECT_NEAR(total(build(Axisymmetric{.radius = {{.to = 0.04, .cells = 7}}, .stack = stack})), pi * a * a, 1e-16);
}

TEST(DiscOverlap, OfOneFaceIsItsShareByCounting) {
    // Midpoints of a 2000 x 2000 raster of the face inside the disc: the error of counting is below 1e-3 of the face.
    const Mesh mesh = block(false, false);
    const int top = mesh.find_patch("top");
    const double a = 0.0157;
    const std::vector<double> overlap = disc_overlap(mesh, top, a);
    int partly = 0;
    for (std::size_t f = 0; f < overlap.size(); ++f) {
        const PatchFace& face = mesh.patches[static_cast<std::size_t>(top)].faces[f];
        const double share = overlap[f] / face.area;
        EXPECT_GE(share, -1e-12);
        EXPECT_LE(share, 1.0 + 1e-12);
        if (share < 0.05 || share > 0.95 || partly == 4) {
            continue;
        }
        ++partly;
        const auto [x0, x1, y0, y1] = face.extent;
        int inside = 0;
        constexpr int raster = 2000;
        for (int i = 0; i < raster; ++i) {
            const double x = x0 + (x1 - x0) * (i + 0.5) / raster;
            for (int j = 0; j < raster; ++j) {
                const double y = y0 + (y1 - y0) * (j + 0.5) / raster;
                inside += x * x + y * y < a * a ? 1 : 0;
            }
        }
        EXPECT_NEAR(share, static_cast<double>(inside) / (raster * raster), 1e-3);
    }
    EXPECT_EQ(partly, 4);
}

TEST(GaussianOverlap, IsTheWholeBeamOnAWideFace) {
    // w = 3 mm: exp(-2 (20/3)^2) is nothing at the nearest side, 20 mm away.
    double whole = 0.0;
    const Mesh mesh = block(false, false);
    for (const double share : gaussian_overlap(mesh, mesh.find_patch("top"), 0.003)) {
        whole += share;
    }
    EXPECT_NEAR(whole, 1.0, 1e-12);
}

TEST(GaussianOverlap, InsideTheWaistIsOneMinusExpMinusTwo) {
    const Mesh mesh =
        build(Axisymmetric{.radius = {{.to = 0.003, .cells = 3}, {.to = 0.04, .cells = 7}}, .stack = stack});
    const std::vector<double> share = gaussian_overlap(mesh, mesh.find_patch("top"), 0.003);
    EXPECT_NEAR(share[0] + share[1] + share[2], 1.0 - std::exp(-2.0), 1e-14);
}

TEST(Means, OfAConstantFieldAreThatConstant) {
    const Mesh mesh = block(true, false);
    const std::vector<double> T(static_cast<std::size_t>(mesh.n_nodes), 321.0);
    const int top = mesh.find_patch("top");
    EXPECT_NEAR(over_disc(mesh, top, 0.004)(T), 321.0, 1e-10);
    EXPECT_NEAR(over_patch(mesh, top)(T), 321.0, 1e-10);
    EXPECT_NEAR(over_cells(mesh, 1)(T), 321.0, 1e-10);
}

}  // namespace tiretherm::mesh
