// SPDX-License-Identifier: BSD-3-Clause
// Fields of structural codes on meshes: what the points give the nodes get, to the last digit.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

#include "physics/effects/bench.hpp"
#include "physics/field_transfer/field_transfer.hpp"

namespace tiretherm::physics {

namespace {

double sum_of_field(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

std::vector<int> outside(const mesh::Mesh& mesh) { return {mesh.find_patch("outside")}; }

std::vector<double> uniform(const std::vector<double>& watts) {
    std::vector<double> shares = watts;
    for (double& share : shares) {
        share /= sum_of_field(watts);
    }
    return shares;
}

/// Points in rows of equal distance from low to high, at the middles of n pieces.
std::vector<double> middles(double low, double high, int n) {
    std::vector<double> at;
    for (int i = 0; i < n; ++i) {
        at.push_back(low + (high - low) * (i + 0.5) / n);
    }
    return at;
}

/// m, of the bench's section
constexpr double half_tread = 0.1125;

}  // namespace

// Whatever the points and their areas: sum of density times area before, sum over the nodes after. 100 clouds of up to
// 60 points; a part lost at an edge would be of the order of 1/60, round-off is 1e-15 of the sum.
TEST(FieldTransfer, KeepsTheTotalOfAnyCloudOfPoints) {
    const Bench bench = section();
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> part(0.0, 1.0);
    for (int cloud = 0; cloud < 100; ++cloud) {
        const int n = 1 + cloud % 60;
        FieldPoints contact;
        FieldPoints volume;
        std::vector<double> density;
        for (int i = 0; i < n; ++i) {
            contact.along.push_back(0.1 * (part(random) - 0.5));
            contact.across.push_back(half_tread * (2.0 * part(random) - 1.0));
            contact.measure.push_back(1e-6 + 1e-4 * part(random));
            volume.across.push_back(bench.mesh.columns.back().to * (2.0 * part(random) - 1.0));
            volume.depth.push_back(0.004 * part(random));
            volume.measure.push_back(1e-8 + 1e-6 * part(random));
            density.push_back(1e5 * part(random));
        }
        if (cloud % 2 == 0) {
            volume.measure.clear();  // derived
        }
        ASSERT_TRUE(strays(bench.mesh, outside(bench.mesh), contact).empty());
        ASSERT_TRUE(strays(bench.mesh, {}, volume).empty());
        const FieldTransfer faces = onto_faces(bench.mesh, outside(bench.mesh), contact);
        const FieldTransfer cells = onto_cells(bench.mesh, volume);
        for (const FieldTransfer& transfer : {faces, cells}) {
            const std::vector<double> watts = transfer.watts(density);
            ASSERT_GT(sum_of_field(watts), 0.0);
            EXPECT_NEAR(sum_of_field(watts), transfer.total(density), 1e-12 * sum_of_field(watts)) << cloud;
            EXPECT_GE(*std::ranges::min_element(watts), 0.0);
        }
        EXPECT_EQ(faces.measure, contact.measure);
    }
}

// The derived measures of points that cover the mesh are its area and its volume: nothing is lost at the edges, whether
// the points stand at the middles of equal pieces or on the borders themselves.
TEST(FieldTransfer, DerivedMeasuresAddUpToTheMesh) {
    const Bench bench = section();
    const double end = bench.mesh.columns.back().to;
    const std::vector<double> ones(41, 1.0);
    for (const bool borders : {false, true}) {
        FieldPoints across;
        FieldPoints contact;
        for (int i = 0; i <= 40; ++i) {
            const double place = borders ? i / 20.0 - 1.0 : (i + 0.5) / 20.5 - 1.0;
            across.across.push_back(end * place);
            contact.across.push_back(half_tread * place);
        }
        const FieldTransfer cells = onto_cells(bench.mesh, across);
        EXPECT_NEAR(cells.total(ones), bench.mesh.total_volume(), 1e-12 * bench.mesh.total_volume());
        const FieldTransfer faces = onto_faces(bench.mesh, outside(bench.mesh), contact);
        const double area = bench.mesh.patches[static_cast<std::size_t>(outside(bench.mesh)[0])].area();
        EXPECT_NEAR(faces.total(ones), area, 1e-12 * area);
    }
}

// A uniform field of the contact is what the effect does without a field; one of the loss gives every cell its volume.
TEST(FieldTransfer, UniformFieldsGiveTheBuiltInWeights) {
    const Bench bench = section();
    FieldPoints contact{.across = middles(-half_tread, half_tread, 17)};
    const FieldTransfer faces = onto_faces(bench.mesh, outside(bench.mesh), contact);
    const std::vector<double> weights = uniform(faces.watts(std::vector<double>(17, 3e5)));
    const ActiveEffect friction = bench.active("sliding_friction");
    ASSERT_EQ(faces.nodes, friction.nodes);
    for (std::size_t i = 0; i < weights.size(); ++i) {
        EXPECT_NEAR(weights[i], friction.weights[i], 1e-15);
    }
    // Every 2 mm of depth, through the 15 mm of the tread and the 4 mm of a sidewall. Only where rows of both kinds meet do
    // deep cells miss what the shallow row cannot say.
    FieldPoints volume;
    for (const double y : middles(-bench.mesh.columns.back().to, bench.mesh.columns.back().to, 13)) {
        for (int k = 0; k < (std::abs(y) < half_tread ? 8 : 2); ++k) {
            volume.across.push_back(y);
            volume.depth.push_back(0.001 + 0.002 * k);
        }
    }
    const FieldTransfer cells = onto_cells(bench.mesh, volume);
    const std::vector<double> watts = cells.watts(std::vector<double>(volume.size(), 1.0));
    const ActiveEffect loss = bench.active("strain_energy_loss");
    int compared = 0;
    for (int cell = 0; cell < bench.mesh.n_cells; ++cell) {
        const double s = bench.mesh.centre[static_cast<std::size_t>(cell)][0];
        if (std::abs(s) < 0.06) {
            EXPECT_NEAR(watts[static_cast<std::size_t>(cell)] / bench.mesh.total_volume(),
                        loss.weights[static_cast<std::size_t>(cell)], 1e-15);
            ++compared;
        }
    }
    EXPECT_GT(compared, 10);
}

// Points of the contact, x by y: a uniform pressure falls on faces of one radius by their widths.
TEST(FieldTransfer, ContactOfRowsHasItsOwnArea) {
    const Bench bench = section();
    FieldPoints contact;
    for (const double y : middles(-0.09, 0.09, 9)) {
        for (const double x : middles(-0.06, 0.06, 12)) {
            contact.across.push_back(y);
            contact.along.push_back(x);
        }
    }
    const FieldTransfer faces = onto_faces(bench.mesh, outside(bench.mesh), contact);
    const std::vector<double> watts = faces.watts(std::vector<double>(contact.size(), 1e4));
    // 1e4 W/m2 on 120 mm by 180 mm.
    EXPECT_NEAR(sum_of_field(watts), 1e4 * 0.12 * 0.18, 1e-10);
    for (const mesh::PatchFace& face : bench.mesh.patches[static_cast<std::size_t>(outside(bench.mesh)[0])].faces) {
        const auto i = static_cast<std::size_t>(std::ranges::find(faces.nodes, face.node) - faces.nodes.begin());
        const double width = std::max(0.0, std::min(face.extent[1], 0.09) - std::max(face.extent[0], -0.09));
        EXPECT_NEAR(watts[i], 1e4 * 0.12 * width, 1e-9);
    }
}

// f(y) = 1 + sin(20 y) on the tread, all of whose faces have the same radius in the crown: integrated over each face
// by hand. Twice as many points, a quarter of the error.
TEST(FieldTransfer, ConvergesAtSecondOrderWithThePoints) {
    const Bench bench = section();
    const mesh::Patch& tread = bench.mesh.patches[static_cast<std::size_t>(outside(bench.mesh)[0])];
    std::vector<double> errors;
    for (const int n : {20, 40, 80, 160}) {
        const FieldPoints contact{.across = middles(-half_tread, half_tread, n)};
        const FieldTransfer faces = onto_faces(bench.mesh, outside(bench.mesh), contact);
        std::vector<double> density;
        for (const double y : contact.across) {
            density.push_back(1.0 + std::sin(20.0 * y));
        }
        const std::vector<double> watts = faces.watts(density);
        double worst = 0.0;
        for (std::size_t i = 0; i < watts.size(); ++i) {
            const auto& [from, to, a, b] = tread.faces[i].extent;
            const double mean = 1.0 + (std::cos(20.0 * from) - std::cos(20.0 * to)) / 20.0 / (to - from);
            worst = std::max(worst, std::abs(watts[i] / tread.faces[i].area - mean));
        }
        errors.push_back(worst);
    }
    for (std::size_t i = 0; i + 1 < errors.size(); ++i) {
        EXPECT_GT(errors[i] / errors[i + 1], 3.5) << errors[i + 1];
    }
}

// A linear field is exact but in the half spacing before the edges, where it is held: that error falls as h^2.
TEST(FieldTransfer, LinearFieldsAreExactInsideAndSecondOrderAtTheEdges) {
    const Bench bench = section();
    const mesh::Patch& tread = bench.mesh.patches[static_cast<std::size_t>(outside(bench.mesh)[0])];
    std::vector<double> at_edge;
    for (const int n : {20, 40, 80}) {
        const FieldPoints contact{.across = middles(-half_tread, half_tread, n)};
        std::vector<double> density;
        for (const double y : contact.across) {
            density.push_back(2.0 + 10.0 * y);
        }
        const std::vector<double> watts = onto_faces(bench.mesh, outside(bench.mesh), contact).watts(density);
        for (std::size_t i = 1; i + 1 < watts.size(); ++i) {
            const double middle = 0.5 * (tread.faces[i].extent[0] + tread.faces[i].extent[1]);
            EXPECT_NEAR(watts[i] / tread.faces[i].area, 2.0 + 10.0 * middle, 1e-12);
        }
        const double middle = 0.5 * (tread.faces[0].extent[0] + tread.faces[0].extent[1]);
        at_edge.push_back(std::abs(watts[0] / tread.faces[0].area - 2.0 - 10.0 * middle));
    }
    // Held over h/2: an error of 10 h^2/8 over the face's width of 22.5 mm.
    EXPECT_NEAR(at_edge[0], 10.0 * std::pow(0.225 / 20, 2) / 8.0 / 0.0225, 1e-9);
    EXPECT_NEAR(at_edge[0] / at_edge[1], 4.0, 1e-6);
    EXPECT_NEAR(at_edge[1] / at_edge[2], 4.0, 1e-6);
}

// On a mesh of one face all points have it: 2e4 W/m2 on rows that stand for 120 by 180 mm.
TEST(FieldTransfer, OneFaceTakesTheWholeContact) {
    const Bench bench = two_nodes();
    FieldPoints contact;
    for (const double y : middles(-0.09, 0.09, 3)) {
        for (const double x : middles(-0.06, 0.06, 4)) {
            contact.across.push_back(y);
            contact.along.push_back(x);
        }
    }
    const std::vector<double> density(contact.size(), 2e4);
    const std::vector<double> watts = onto_faces(bench.mesh, outside(bench.mesh), contact).watts(density);
    ASSERT_EQ(watts.size(), 1U);
    EXPECT_NEAR(watts[0], 2e4 * 0.12 * 0.18, 1e-9);
}

TEST(FieldTransfer, CellsTakeWhatIsTheirs) {
    const Bench bench = section();
    FieldPoints points{.cell = {3, 5, 5}};
    const std::vector<double> watts = onto_cells(bench.mesh, points).watts(std::vector{1e4, 1e4, 3e4});
    EXPECT_NEAR(watts[3], 1e4 * bench.mesh.volume[3], 1e-12);
    EXPECT_NEAR(watts[5], 2e4 * bench.mesh.volume[5], 1e-12);
    EXPECT_NEAR(sum_of_field(watts), watts[3] + watts[5], 1e-15);
}

// Beyond the tread (112.5 mm), too deep for a sidewall of 4 mm, and a cell that there is not.
TEST(FieldTransfer, FindsPointsBesideTheTire) {
    const Bench bench = section();
    const std::vector<Stray> beyond = strays(bench.mesh, outside(bench.mesh), {.across = {0.0, 0.113, -0.2}});
    ASSERT_EQ(beyond.size(), 2U);
    EXPECT_EQ(beyond[0].point, 1U);
    EXPECT_EQ(beyond[0].what, "y is 113 mm, beyond the tread, which reaches from -112.5 to 112.5 mm");
    const std::vector<Stray> deep = strays(bench.mesh, {}, {.across = {0.0, 0.15}, .depth = {0.014, 0.014}});
    ASSERT_EQ(deep.size(), 1U);
    EXPECT_EQ(deep[0].what, "depth is 14 mm at y = 150 mm, where the tire is 4 mm thick");
    const FieldPoints cells{.cell = {0, bench.mesh.n_cells}};
    ASSERT_EQ(strays(bench.mesh, {}, cells).size(), 1U);
    EXPECT_EQ(strays(bench.mesh, outside(bench.mesh), cells).size(), 2U);  // cell 0 is in a sidewall
}

}  // namespace tiretherm::physics
