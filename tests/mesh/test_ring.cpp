// SPDX-License-Identifier: BSD-3-Clause
// Meshes of rings: volumes and areas of the section, second-order conduction around the ring, and readings at an angle.

#include "mesh/ring.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "mesh/column_probe.hpp"
#include "mesh/probe.hpp"
#include "tests/support/order.hpp"
#include "tests/support/tire_section.hpp"

namespace tiretherm::mesh {

namespace {

using std::numbers::pi;

Mesh section() { return build(support::tire_section({}, 1)); }

/// One column of 10 mm of rubber on a tire of 300 mm.
Mesh one_column(int cells) {
    Section column;
    column.meridian = Meridian(0.3, {{0.05, 1e-6}});
    column.layers = {{"tread", 0.01, cells}};
    column.zones = {{"crown", 0.1, 1, 1.0, {0}, true}};
    return build(column);
}

double volume_of(const Mesh& mesh, int corner_of) {
    // A hexahedron as VTK numbers it: the product of its three edges at the first corner is positive.
    const auto point = [&](int i) {
        return mesh.drawing
            .points[static_cast<std::size_t>(mesh.drawing.corners[static_cast<std::size_t>(8 * corner_of + i)])];
    };
    const auto edge = [&](int to) {
        return std::array{point(to)[0] - point(0)[0], point(to)[1] - point(0)[1], point(to)[2] - point(0)[2]};
    };
    const auto [a, b, c] = std::array{edge(1), edge(3), edge(4)};
    return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

}  // namespace

TEST(Ring, HasTheSectionsVolumeAreasAndRegions) {
    const Mesh flat = section();
    const Mesh round = ring(flat, 7);
    EXPECT_EQ(defects(round), std::vector<std::string>{});
    EXPECT_EQ(round.n_cells, 7 * flat.n_cells);
    EXPECT_NEAR(round.total_volume(), flat.total_volume(), 1e-15);
    for (std::size_t p = 0; p < flat.patches.size(); ++p) {
        EXPECT_NEAR(round.patches[p].area(), flat.patches[p].area(), 1e-14) << flat.patches[p].name;
    }
    // Temperatures that do not change around the tire have the section's regions.
    std::vector<double> T(static_cast<std::size_t>(round.n_nodes));
    std::vector<double> once(static_cast<std::size_t>(flat.n_nodes));
    const auto field = [](const Point& place) { return 300.0 + 40.0 * place[0] + 900.0 * place[2]; };
    std::ranges::transform(round.centre, T.begin(), field);
    std::ranges::transform(flat.centre, once.begin(), field);
    for (std::size_t r = 0; r < flat.regions.size(); ++r) {
        EXPECT_NEAR(round.regions[r].mean(T), flat.regions[r].mean(once), 1e-11);
    }
}

TEST(Ring, JoinsEveryCellToTheNextAlongItsArc) {
    const Mesh flat = section();
    const Mesh round = ring(flat, 12);
    double conductance = 0.0;
    int faces = 0;
    for (const Face& face : round.faces) {
        if (face.axis == Axis::circumference) {
            const int from = sector_of(round, face.a);
            EXPECT_EQ(sector_of(round, face.b), (from + 1) % 12);
            conductance += face.area / (face.half_a + face.half_b);
            ++faces;
        }
    }
    EXPECT_EQ(faces, 12 * flat.n_cells);
    // Each: its volume of the whole tire over 2 pi r, over an arc of 2 pi r / 12; twelve of them.
    double expected = 0.0;
    for (int cell = 0; cell < flat.n_cells; ++cell) {
        const auto c = static_cast<std::size_t>(cell);
        const Column& column = flat.columns[static_cast<std::size_t>(column_at(flat, flat.centre[c][0]))];
        expected += flat.volume[c] * std::pow(12.0 / (2.0 * pi * column.radius), 2);
    }
    EXPECT_NEAR(conductance, expected, 1e-12 * expected);
}

// cos(angle) is the slowest mode of an insulated ring: its rate is k / (rho c r^2). Cells of pitch p have
// (2 - 2 cos p)/p^2 of it, off by p^2/12: second order, and 0.09 % with 60 sectors.
TEST(Ring, HasTheRateOfACosineAroundItToSecondOrder) {
    const auto rate_over_exact = [](int sectors) {
        const Mesh round = ring(one_column(2), sectors);
        double numerator = 0.0;
        double denominator = 0.0;
        const auto T = [&](int cell) { return std::cos(2.0 * pi * sector_of(round, cell) / sectors); };
        for (const Face& face : round.faces) {
            if (face.axis == Axis::circumference) {
                numerator += face.area / (face.half_a + face.half_b) * std::pow(T(face.b) - T(face.a), 2);
            }
        }
        for (int cell = 0; cell < round.n_cells; ++cell) {
            denominator += round.volume[static_cast<std::size_t>(cell)] * T(cell) * T(cell);
        }
        return numerator / denominator * std::pow(round.columns[0].radius, 2);
    };
    std::vector<double> errors;
    for (const int sectors : {15, 30, 60}) {
        errors.push_back(std::abs(rate_over_exact(sectors) - 1.0));
    }
    EXPECT_NEAR(errors.back(), std::pow(2.0 * pi / 60.0, 2) / 12.0, 1e-5);
    EXPECT_NEAR(std::log2(errors[0] / errors[1]), 2.0, 0.05);
    EXPECT_NEAR(std::log2(errors[1] / errors[2]), 2.0, 0.05);
}

TEST(Ring, IsReadInTheMeanOrAtAnAngle) {
    const Mesh round = ring(section(), 40);
    std::vector<double> T;
    for (int node = 0; node < round.n_nodes; ++node) {
        const auto& [s, y, depth] = round.centre[static_cast<std::size_t>(node)];
        T.push_back(300.0 + 20.0 * s + 500.0 * depth + 10.0 * std::cos(2.0 * pi * sector_of(round, node) / 40.0));
    }
    const Point place{0.013, 0.0, 0.0021};
    const Functional first = at_column_point(round, place);
    const double plain = 300.0 + 20.0 * 0.013 + 500.0 * 0.0021;
    EXPECT_NEAR(first(T), plain + 10.0, 1e-9);
    EXPECT_NEAR(around(round, first)(T), plain, 1e-9);
    EXPECT_NEAR(around(round, over_cells(round, 0, -1))(T), over_cells(round, 0, -1)(T), 1e-9) << "of a mean: itself";
    // Between two middles of sectors a straight line: off by at most 10 pitch^2 / 8.
    const double pitch = 2.0 * pi / 40.0;
    for (const double angle : {0.0, 1.0, 3.0 * pitch, 3.5 * pitch, -2.2, 100.0}) {
        EXPECT_NEAR(at_angle(round, first, angle)(T), plain + 10.0 * std::cos(angle),
                    10.0 * pitch * pitch / 8.0 + 1e-9);
    }
    EXPECT_NEAR(at_angle(round, first, -3.0 * pitch)(T), plain + 10.0 * std::cos(3.0 * pitch), 1e-9);
    const double radius = round.columns[static_cast<std::size_t>(column_at(round, 0.013))].radius;
    EXPECT_NEAR(at_point(round, {0.013, 3.0 * pitch * radius, 0.0021})(T), plain + 10.0 * std::cos(3.0 * pitch), 1e-9);
}

TEST(Ring, IsDrawnAsHexahedraAboutTheAxisAndInTheMeanAsASection) {
    const Mesh flat = section();
    const Mesh round = ring(flat, 16);
    ASSERT_EQ(round.drawing.corners.size(), static_cast<std::size_t>(8 * round.n_cells));
    for (int cell = 0; cell < round.n_cells; ++cell) {
        ASSERT_GT(volume_of(round, cell), 0.0) << cell;
    }
    const Mesh drawn = drawn_section(round);
    EXPECT_EQ(drawn.drawing.corners, flat.drawing.corners);
    for (std::size_t i = 0; i < flat.drawing.points.size(); ++i) {
        EXPECT_NEAR(drawn.drawing.points[i][2], flat.drawing.points[i][2], 1e-14);
        EXPECT_EQ(drawn.drawing.points[i][0], flat.drawing.points[i][0]);
    }
    std::vector<double> T(static_cast<std::size_t>(round.n_nodes));
    for (int node = 0; node < round.n_nodes; ++node) {
        T[static_cast<std::size_t>(node)] = round.centre[static_cast<std::size_t>(node)][2] + sector_of(round, node);
    }
    const std::vector<double> mean = around(round, T);
    ASSERT_EQ(std::ssize(mean), flat.n_nodes);
    for (int node = 0; node < flat.n_nodes; ++node) {
        EXPECT_NEAR(mean[static_cast<std::size_t>(node)], flat.centre[static_cast<std::size_t>(node)][2] + 7.5, 1e-12);
    }
}

}  // namespace tiretherm::mesh
