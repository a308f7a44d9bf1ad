// SPDX-License-Identifier: BSD-3-Clause
// Pixels of a camera: footprint, blur, binning and mirrored quarters against means of analytic fields.

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "mesh/builders.hpp"
#include "mesh/probe.hpp"
#include "physics/camera.hpp"
#include "support/order.hpp"

namespace tiretherm::physics {

namespace {

constexpr Detectors detectors{.rows = 5, .columns = 7, .pitch_x = 0.5e-3, .pitch_y = 0.4e-3};

mesh::Mesh disc(int cells) {
    return mesh::build(mesh::Axisymmetric{.radius = {{.to = 20e-3, .cells = cells}},
                                          .stack = {{.name = "rubber", .thickness = 5e-3, .cells = 2}}});
}

/// 20 mm wide each way, all of it or a quarter.
mesh::Mesh block(bool quarter, int cells) {
    const std::vector<mesh::Segment> across{{.to = 10e-3, .cells = cells}};
    return mesh::build(mesh::Block{
        .x = across, .y = across, .stack = {{.name = "rubber", .thickness = 5e-3, .cells = 2}}, .quarter = quarter});
}

/// A field at the nodes of a mesh's outer surface, averaged by a pixel.
template <typename Field>
double averaged(const mesh::Mesh& mesh, const CameraPose& pose, int row, int column, const Field& field) {
    const SeenSurface surface(mesh, mesh.find_patch("top"));
    const mesh::Functional pixel = over_pixel(surface, detectors, pose, row, column);
    double sum = 0.0;
    for (std::size_t k = 0; k < pixel.nodes.size(); ++k) {
        const int node = surface.nodes()[static_cast<std::size_t>(pixel.nodes[k])];
        const mesh::Point& at = mesh.centre[static_cast<std::size_t>(node)];
        sum += pixel.weights[k] * field(at[0], at[1]);
    }
    return sum;
}

}  // namespace

// A mean over a square about its middle of a + b x + c y is its value in the middle, whatever the blur. The middle of row 1,
// column 5 of 5 x 7 lies 2 columns right of the centre and 1 row before it: (1.0, -0.4) mm, turned by 30 degrees and
// moved by (0.3, -0.2) mm.
TEST(Pixel, OfALinearFieldReadsItsMiddle) {
    const CameraPose pose{.x = 0.3e-3, .y = -0.2e-3, .rotation = std::numbers::pi / 6.0, .blur = 0.8e-3};
    const double c = std::cos(pose.rotation);
    const double s = std::sin(pose.rotation);
    const double x = 0.3e-3 + 1.0e-3 * c + 0.4e-3 * s;
    const double y = -0.2e-3 + 1.0e-3 * s - 0.4e-3 * c;
    const auto middle = middle_of(detectors, pose, 1, 5);
    EXPECT_NEAR(middle[0], x, 1e-15);
    EXPECT_NEAR(middle[1], y, 1e-15);
    const double read =
        averaged(block(false, 30), pose, 1, 5, [](double u, double v) { return 300.0 + 2e3 * u - 5e3 * v; });
    EXPECT_NEAR(read, 300.0 + 2e3 * x - 5e3 * y, 1e-9);
}

// The mean of x^2 over the square is X^2 + p^2 / 12, the blur adds its variance: 0.8 mm of full width at half maximum are
// sigma = 0.33973 mm. So x^2 + y^2 reads X^2 + Y^2 + (0.5^2 + 0.4^2) / 12 + 2 * 0.33973^2 mm2. Between nodes h apart a
// parabola is drawn h^2 / 6 too high in the mean, each way: the error falls fourfold with every halving.
TEST(Pixel, OfAQuadraticFieldAddsItsOwnExtentAndTheBlur) {
    const CameraPose pose{.x = 0.3e-3, .y = -0.2e-3, .blur = 0.8e-3};
    const double x = 0.3e-3 + 1.0e-3;
    const double y = -0.2e-3 - 0.4e-3;
    const double exact = x * x + y * y + (0.25e-6 + 0.16e-6) / 12.0 + 2.0 * std::pow(0.8e-3 / 2.354820045, 2);
    const auto error = [&](int cells) {
        return averaged(block(false, cells), pose, 1, 5, [](double u, double v) { return u * u + v * v; }) - exact;
    };
    EXPECT_LT(std::abs(error(50)), 2.0 * 0.25 * std::pow(0.4e-3, 2));
    EXPECT_LT(std::abs(error(400)), std::abs(error(50)) / 30.0);
}

// exp(-r^2 / 2 s^2), smeared by a Gaussian of variance q, is s^2 / (s^2 + q) exp(-r^2 / 2 (s^2 + q)); over the rectangle
// that is a product of differences of error functions. Second order in the rings' width.
TEST(Pixel, OfARoundHotSpotConvergesToTheSmearedMeanAtSecondOrder) {
    const CameraPose pose{.x = 2.1e-3, .y = 1.3e-3, .blur = 0.8e-3};
    const double s2 = std::pow(3e-3, 2);
    const double wide = s2 + std::pow(0.8e-3 / 2.354820045, 2);
    const auto [x, y] = middle_of(detectors, pose, 3, 2);
    const auto mean = [&](double middle, double pitch) {
        const double scale = std::sqrt(2.0 * wide);
        return std::sqrt(std::numbers::pi * wide / 2.0) / pitch *
               (std::erf((middle + pitch / 2.0) / scale) - std::erf((middle - pitch / 2.0) / scale));
    };
    const double exact = 300.0 + 100.0 * s2 / wide * mean(x, detectors.pitch_x) * mean(y, detectors.pitch_y);
    const auto error = [&](int cells) {
        const double read = averaged(disc(cells), pose, 3, 2,
                                     [&](double r, double) { return 300.0 + 100.0 * std::exp(-r * r / (2.0 * s2)); });
        return std::abs(read - exact);
    };
    EXPECT_LT(error(80), 0.02);
    const double order = std::log2(error(40) / error(160)) / 2.0;
    EXPECT_GT(order, 1.8);
    EXPECT_LT(order, 2.3);
}

// A pixel without extent reads what a probe at its middle reads, also beside the axis.
TEST(Pixel, WithoutExtentReadsAsAProbe) {
    const Detectors point{.rows = 1, .columns = 1, .pitch_x = 1e-12, .pitch_y = 1e-12};
    const mesh::Mesh round = disc(40);
    const SeenSurface surface(round, round.find_patch("top"));
    for (const double r : {0.0, 0.1e-3, 0.3e-3, 7.77e-3, 19.9e-3}) {
        const mesh::Functional pixel = over_pixel(surface, point, {.x = 0.6 * r, .y = -0.8 * r}, 0, 0);
        const mesh::Functional probe = mesh::at_point(round, {r, 0.0, 0.0});
        std::vector<double> T(static_cast<std::size_t>(round.n_nodes));
        for (std::size_t n = 0; n < T.size(); ++n) {
            T[n] = 300.0 + 10.0 * std::sin(200.0 * round.centre[n][0]);
        }
        double read = 0.0;
        for (std::size_t k = 0; k < pixel.nodes.size(); ++k) {
            const auto at = static_cast<std::size_t>(pixel.nodes[k]);
            read += pixel.weights[k] * T[static_cast<std::size_t>(surface.nodes()[at])];
        }
        EXPECT_NEAR(read, probe(T), 1e-6) << r;
    }
}

// A quarter stands for the whole where the field is even about both planes.
TEST(Pixel, SeesTheMirroredQuarterAsTheWhole) {
    const CameraPose pose{.x = -0.4e-3, .y = 0.7e-3, .rotation = 0.2, .blur = 0.5e-3};
    const auto even = [](double u, double v) { return 300.0 + 20.0 * std::cos(400.0 * u) * std::cos(300.0 * v); };
    for (int column = 0; column < detectors.columns; ++column) {
        const double whole = averaged(block(false, 200), pose, 2, column, even);
        EXPECT_NEAR(averaged(block(true, 100), pose, 2, column, even), whole, 0.005) << column;
    }
}

// Binned by 2 x 2 a pixel is the mean of its four detectors.
TEST(Pixel, BinnedIsTheMeanOfItsDetectors) {
    const mesh::Mesh round = disc(40);
    const SeenSurface surface(round, round.find_patch("top"));
    const CameraPose pose{.x = 1e-3, .y = 0.5e-3, .blur = 0.3e-3};
    std::vector<double> sum(surface.nodes().size(), 0.0);
    for (const int detector : {8, 9, 15, 16}) {
        const mesh::Functional one = over_pixel(surface, detectors, pose, detector / 7, detector % 7);
        for (std::size_t k = 0; k < one.nodes.size(); ++k) {
            sum[static_cast<std::size_t>(one.nodes[k])] += 0.25 * one.weights[k];
        }
    }
    const auto binned = over_pixels(surface, detectors, pose, {{.row = 0, .column = 0, .detectors = {8, 9, 15, 16}}});
    double weight = 0.0;
    for (std::size_t k = 0; k < binned.front().nodes.size(); ++k) {
        EXPECT_NEAR(binned.front().weights[k], sum[static_cast<std::size_t>(binned.front().nodes[k])], 1e-14);
        weight += binned.front().weights[k];
    }
    EXPECT_NEAR(weight, 1.0, 1e-13);
}

// The disc ends at 20 mm. A pixel of 0.5 x 0.4 mm whose middle lies at 19.7 mm has corners at 19.95 mm and sees rubber alone;
// at 19.8 mm its corners lie beyond. A blur of 0.4 mm reaches sqrt(3) sigma = 0.29 mm further.
TEST(Pixel, OverTheEdgeOfTheSpecimenIsToldApart) {
    const mesh::Mesh round = disc(40);
    const SeenSurface surface(round, round.find_patch("top"));
    EXPECT_TRUE(sees_specimen(surface, detectors, {.x = 19.7e-3}, 2, 3));
    EXPECT_FALSE(sees_specimen(surface, detectors, {.x = 19.8e-3}, 2, 3));
    EXPECT_FALSE(sees_specimen(surface, detectors, {.x = 19.7e-3, .blur = 0.4e-3}, 2, 3));
}

TEST(Camera, LooksAtBlocksAndDiscsAlone) {
    const mesh::Mesh round = disc(4);
    EXPECT_TRUE(can_be_seen(round, round.find_patch("top")));
    EXPECT_TRUE(can_be_seen(round, round.find_patch("bottom")));
    EXPECT_FALSE(can_be_seen(round, -1));
}

}  // namespace tiretherm::physics
