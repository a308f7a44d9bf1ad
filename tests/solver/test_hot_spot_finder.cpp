// SPDX-License-Identifier: BSD-3-Clause
// The hottest place of a part, between the cells too.
#include "mesh/index.hpp"
#include "solver/hot_spot_finder.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "mesh/builders.hpp"
#include "mesh/ring.hpp"

namespace tiretherm::solver {

namespace {

using std::numbers::pi;

/// A flat crown of 200 mm with 12 mm of one layer.
mesh::Mesh crown(int along, int through, bool two_layers = false) {
    mesh::Section d;
    d.meridian = mesh::Meridian(0.3, {{0.1, 0.0}});
    d.layers = {{"tread", two_layers ? 0.008 : 0.012, through}, {"belt", 0.004, through}};
    d.zones = {{"crown", 0.2, along, 1.0, two_layers ? std::vector<int>{0, 1} : std::vector<int>{0}}};
    return mesh::build(d);
}

template <typename Field>
std::vector<double> field(const mesh::Mesh& mesh, const Field& of) {
    std::vector<double> T;
    for (int n = 0; n < mesh.n_nodes; ++n) {
        T.push_back(of(mesh.centre[at(n)][0], mesh.centre[at(n)][2]));
    }
    return T;
}

}  // namespace

// A parabola in both directions is its own interpolant: peak of 400 K at s = 13 mm, z = 7.3 mm, wherever the cells are.
TEST(HotSpotFinder, FindsThePeakOfAParabolaExactly) {
    const mesh::Mesh mesh = crown(9, 7);
    const HotSpotFinder finder(mesh, all_nodes(mesh));
    const std::vector<double> T = field(mesh, [](double s, double z) {
        return 400.0 - 3e3 * (s - 0.013) * (s - 0.013) - 4e5 * (z - 0.0073) * (z - 0.0073);
    });
    const HotSpotFinder::Found found = finder.find(T);
    EXPECT_NEAR(found.temperature, 400.0, 1e-9);
    EXPECT_NEAR(found.point[0], 0.013, 1e-9);
    EXPECT_NEAR(found.point[2], 0.0073, 1e-9);
    // The node alone is too cold, by what the test would otherwise not see.
    EXPECT_LT(T[at(found.node)], 399.9);
    EXPECT_NEAR(finder.functional(T)(T), found.temperature, 1e-9);
}

// T = 100 cos(a (s - s0)) cos(b (z - z0)) peaks at 100 exactly, wherever in a cell that is. Parabolas leave out the third
// derivative, 0 at a peak, and so the error is of the order h^4: at least second, and far below that of the hottest node.
TEST(HotSpotFinder, PeakIsOfSecondOrderAtLeastAndBeatsTheHottestNode) {
    std::vector<double> errors;
    std::vector<double> of_nodes;
    for (const int n : {8, 16, 32}) {
        const mesh::Mesh mesh = crown(2 * n + 1, n);
        const HotSpotFinder finder(mesh, all_nodes(mesh));
        errors.push_back(0.0);
        of_nodes.push_back(0.0);
        for (int i = 0; i < 20; ++i) {
            const std::vector<double> T = field(mesh, [&](double s, double z) {
                return 100.0 * std::cos(pi / 0.2 * (s - 0.011 - 0.0013 * i)) *
                       std::cos(pi / 0.02 * (z - 0.0061 - 0.00013 * i));
            });
            const HotSpotFinder::Found found = finder.find(T);
            errors.back() = std::max(errors.back(), std::abs(found.temperature - 100.0));
            of_nodes.back() = std::max(of_nodes.back(), std::abs(T[at(found.node)] - 100.0));
        }
    }
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_LT(errors[i], 0.1 * of_nodes[i]) << i;
    }
    EXPECT_LT(errors[1], errors[0] / 4.0);
    EXPECT_LT(errors[2], errors[1] / 4.0);
}

// Steady heat q in two layers, k = 0.9 above and 0.1 below, insulated inside and held at 300 K outside: T is a parabola
// in each layer with a kink where they meet. Hottest is the inside, and of the tread alone the face between the layers:
// T = 300 + q (L z - z^2/2)/k_1 at z = 8 mm, with q = 1e5 W/m3 and L = 12 mm: 300 + 1e5 (96 - 32) 1e-6/0.9 = 307.11 K.
// Of the tread alone that is found from the tread's own cells; a parabola across the kink would not give it.
TEST(HotSpotFinder, PartEndsWhereItsLayerEndsAndAKinkDoesNotDisturbIt) {
    const mesh::Mesh mesh = crown(5, 6, true);
    const double at_face = 300.0 + 1e5 * (0.012 * 0.008 - 0.5 * 0.008 * 0.008) / 0.9;
    const std::vector<double> T = field(mesh, [&](double, double z) {
        const auto rise = [](double depth, double k) { return 1e5 * (0.012 * depth - 0.5 * depth * depth) / k; };
        return z <= 0.008 ? 300.0 + rise(z, 0.9) : at_face + rise(z, 0.1) - rise(0.008, 0.1);
    });
    std::vector<int> tread;
    for (int n = 0; n < mesh.n_nodes; ++n) {
        if (mesh.layer[at(n)] == 0) {
            tread.push_back(n);
        }
    }
    const HotSpotFinder::Found found = HotSpotFinder(mesh, tread).find(T);
    EXPECT_NEAR(found.temperature, at_face, 1e-9);
    EXPECT_NEAR(found.point[2], 0.008, 1e-12);
    // Of the whole the insulated inside, a surface node.
    const HotSpotFinder::Found inside = HotSpotFinder(mesh, all_nodes(mesh)).find(T);
    EXPECT_NEAR(inside.temperature, at_face + 1e5 * (0.5 * 0.012 * 0.012 - 0.012 * 0.008 + 0.5 * 0.008 * 0.008) / 0.1,
                1e-9);
    EXPECT_DOUBLE_EQ(inside.point[2], 0.012);
}

// A field that rises towards the end of the columns of one thickness is reported where its last node is, 300 + 1e3 s,
// and not half a cell further: there it turns into a neighbour that the parabola does not know. On the shipped section
// at 180 km/h and 8 kN carrying it on would give 109.6 degC, the node 109.1, a grid twice as fine 108.9.
TEST(HotSpotFinder, DoesNotCarryTheFieldOnTowardsAnEnd) {
    const mesh::Mesh mesh = crown(9, 7);
    const std::vector<double> T =
        field(mesh, [](double s, double z) { return 300.0 + 1e3 * s - 4e5 * (z - 0.0073) * (z - 0.0073); });
    std::vector<int> cells = all_nodes(mesh);
    cells.resize(at(mesh.n_cells));  // the end's own surface would be hotter
    const HotSpotFinder::Found found = HotSpotFinder(mesh, cells).find(T);
    EXPECT_NEAR(found.point[0], mesh.columns.back().middle(), 1e-12);
    EXPECT_NEAR(found.temperature, 300.0 + 1e3 * mesh.columns.back().middle(), 1e-9);
    EXPECT_NEAR(found.point[2], 0.0073, 1e-9);
}

// Both shoulders equally hot but for round-off: the first one is reported, whichever has the last digit more.
TEST(HotSpotFinder, TellsTheFirstOfTwoMirroredPlaces) {
    const mesh::Mesh mesh = crown(8, 4);
    std::vector<double> T(at(mesh.n_nodes), 300.0);
    const int left = mesh.columns[1].first_cell + 2;
    const int right = mesh.columns[6].first_cell + 2;
    T[at(left)] = 350.0;
    T[at(right)] = 350.0 + 1e-10;
    EXPECT_EQ(HotSpotFinder(mesh, all_nodes(mesh)).find(T).node, left);
}

// Through layers on a strip too: T = 350 - 1e5 (z - 6.1 mm)^2.
TEST(HotSpotFinder, LooksBetweenTheCellsOfLayers) {
    const mesh::Mesh mesh = mesh::build(mesh::Layers{.area = 1.0, .stack = {{"tread", 0.012, 5}}});
    const std::vector<double> T =
        field(mesh, [](double, double z) { return 350.0 - 1e5 * (z - 0.0061) * (z - 0.0061); });
    const HotSpotFinder::Found found = HotSpotFinder(mesh, all_nodes(mesh)).find(T);
    EXPECT_NEAR(found.temperature, 350.0, 1e-9);
    EXPECT_NEAR(found.point[2], 0.0061, 1e-9);
}

// The surface has turned cold, by 25 K, and the field behind falls to the middle as before: from 344.5 K on in a straight line, no
// place is hotter than the first centre. A parabola across the jump would have its peak 0.4 of a cell further on, 1.2 K higher.
TEST(HotSpotFinder, AJumpOnOneSideMakesNoPeakOnTheOther) {
    const mesh::Mesh mesh = mesh::build(mesh::Layers{.area = 1.0, .stack = {{"tread", 0.012, 6}}});
    const std::vector<double> T =
        field(mesh, [](double, double z) { return z < 1e-9 ? 320.0 : 344.5 - 100.0 * (z - 0.001); });
    const HotSpotFinder finder(mesh, all_nodes(mesh));
    const HotSpotFinder::Found found = finder.find(T);
    EXPECT_NEAR(found.temperature, 344.5, 1e-9);
    EXPECT_NEAR(found.point[2], 0.001, 1e-12);
    EXPECT_NEAR(finder.functional(T)(T), found.temperature, 1e-9);
    // From the other side alike.
    const std::vector<double> mirrored =
        field(mesh, [](double, double z) { return z > 0.012 - 1e-9 ? 320.0 : 344.5 - 100.0 * (0.011 - z); });
    EXPECT_NEAR(finder.find(mirrored).temperature, 344.5, 1e-9);
}

// Behind the jump the field is the parabola 344.5 - 1e5 (z - 2 mm)^2, with its peak half-way between the first two centres.
// It may bend twice as much there as behind, which lifts a straight line between two equal values by (1e-3)^2 2e5 = 0.2 K
// in place of 0.1: no more than 0.1 K too much.
TEST(HotSpotFinder, APeakBesideAJumpIsLiftedByNoMoreThanTwiceItsBend) {
    const mesh::Mesh mesh = mesh::build(mesh::Layers{.area = 1.0, .stack = {{"tread", 0.012, 6}}});
    const std::vector<double> T = field(
        mesh, [](double, double z) { return z < 1e-9 ? 300.0 : 344.5 - 1e5 * (z - 0.0020001) * (z - 0.0020001); });
    const HotSpotFinder::Found found = HotSpotFinder(mesh, all_nodes(mesh)).find(T);
    EXPECT_GT(found.temperature, 344.5 - 1e-3);
    EXPECT_LT(found.temperature, 344.5 + 0.1 + 1e-3);
}

TEST(HotSpotFinder, LumpIsItself) {
    const mesh::Mesh mesh =
        mesh::build(mesh::TwoNode{.area = 0.5, .surface_volume = 1e-3, .bulk_volume = 5e-3, .bulk_depth = 0.01});
    const HotSpotFinder::Found found = HotSpotFinder(mesh, all_nodes(mesh)).find(std::vector{320.0, 350.0});
    EXPECT_EQ(found.node, 1);
    EXPECT_DOUBLE_EQ(found.temperature, 350.0);
}

// The parabola of the first test in the second sector of three, 1 K below in the others: the same peak, at the sector's angle.
TEST(HotSpotFinder, FindsThePeakInEverySectorOfARing) {
    const mesh::Mesh ring = mesh::ring(crown(9, 7), 3);
    const int per_sector = ring.n_cells / 3;
    std::vector<double> T = field(ring, [](double s, double z) {
        return 399.0 - 3e3 * (s - 0.013) * (s - 0.013) - 4e5 * (z - 0.0073) * (z - 0.0073);
    });
    for (int cell = per_sector; cell < 2 * per_sector; ++cell) {
        T[at(cell)] += 1.0;
    }
    const HotSpotFinder finder(ring, all_nodes(ring));
    const HotSpotFinder::Found found = finder.find(T);
    EXPECT_NEAR(found.temperature, 400.0, 1e-9);
    EXPECT_NEAR(found.point[0], 0.013, 1e-9);
    EXPECT_NEAR(found.point[1], ring.centre[at(per_sector + found.node % per_sector)][1], 1e-12);
    EXPECT_GT(found.point[1], 0.1);  // a third of a turn is 0.63 m
    EXPECT_NEAR(found.point[2], 0.0073, 1e-9);
    EXPECT_NEAR(finder.functional(T)(T), 400.0, 1e-9);
}

// Lines through the thickness follow each other sector by sector: the last of one and the first of the next lie on opposite
// shoulders, and no parabola runs from one to the other. Each sector rises linearly towards its end, 300 + 1e3 s; the second
// is 1 K hotter. With one layer of one thickness everywhere nothing else ends the row.
TEST(HotSpotFinder, EndsWhereASectorOfARingEnds) {
    const mesh::Mesh ring = mesh::ring(crown(9, 7), 3);
    const int per_sector = ring.n_cells / 3;
    std::vector<double> T = field(ring, [](double s, double) { return 300.0 + 1e3 * s; });
    for (int cell = per_sector; cell < 2 * per_sector; ++cell) {
        T[at(cell)] += 1.0;
    }
    std::vector<int> cells = all_nodes(ring);
    cells.resize(at(ring.n_cells));  // the end's own surface would be hotter
    // In the middle of the thickness, for the surfaces are not 1 K hotter.
    std::erase_if(cells, [&](int cell) { return cell % 7 != 3; });
    const HotSpotFinder::Found found = HotSpotFinder(ring, cells).find(T);
    const double end = ring.columns.back().middle();
    EXPECT_NEAR(found.point[0], end, 1e-12);
    EXPECT_NEAR(found.temperature, 301.0 + 1e3 * end, 1e-9);
}

}  // namespace tiretherm::solver
