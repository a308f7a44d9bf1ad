// SPDX-License-Identifier: BSD-3-Clause
// The contact pressure across the tread: its shape by hand, the side it leans to, and totals that it leaves as they are.

#include "physics/contact/across_tread.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "mesh/index.hpp"
#include "tests/physics/effects/bench.hpp"

namespace tiretherm::physics {
namespace {

/// Seven columns of tread between -112.5 mm, outboard, and 112.5 mm: edges at 1, 0.8, 0.6 and 0.2 of half the width.
constexpr std::array edges{1.0, 0.8, 0.6, 0.2, -0.2, -0.6, -0.8, -1.0};
constexpr std::size_t outermost = 0;
constexpr std::size_t middle = 3;
constexpr std::size_t innermost = 6;

/// The skew and the crown of a moment, by the law's own numbers.
Part law(double by_camber, double by_lateral_force, double by_deflection) {
    return {"pressure_across_tread",
            {{"by_camber", by_camber},
             {"by_lateral_force", by_lateral_force},
             {"by_deflection", by_deflection},
             {"reference_load", 4000.0}}};
}

/// A tread that slides on a road of its own temperature, with a pressure at which its laws hold.
Bench sliding_bench() {
    Bench bench = section();
    bench.tire.reference_pressure = 2.3e5;
    std::ranges::fill(bench.T, 330.0);
    return bench;
}

/// Heat of sliding into each column over what an even contact gives it.
std::vector<double> heat_ratio(const Part& across, const Inputs& in, const Bench& bench = sliding_bench()) {
    Whole even(bench, {{"sliding_friction"}});
    Whole loaded(bench, {{"sliding_friction"}, across});
    even.ask(in);
    loaded.ask(in);
    std::vector<double> ratios;
    for (const mesh::PatchFace& face : bench.mesh.patches[at(bench.mesh.find_patch("outside"))].faces) {
        ratios.push_back(loaded.flow(face.node) / even.flow(face.node));
    }
    return ratios;
}

/// An outer tire of a left turn, on the right of the car: the road pushes it to the left, towards the middle.
Inputs in_bend(double lateral_force, double camber, double pressure = 2.3e5, double load = 4000.0) {
    Inputs in = rolling();
    in.lateral_force = lateral_force;
    in.camber = camber;
    in.inflation_pressure = pressure;
    in.vertical_load = load;
    return in;
}

}  // namespace

// a = 4 gamma + 0.8 Fy/Fz = 4 (-0.05) + 0.8 0.5 = 0.2 and c = 1 - 5000/4000 = -0.25 at 5000 N and Fy = 2500 N: in a column
// between y1 and y2 the mean of 1 + a y + c (1 - 3 y^2)/2 is 1 + a (y1 + y2)/2 + c (1 - (y1^2 + y1 y2 + y2^2))/2, outermost 1 +
// 0.18 + 0.18, in the middle 1 - 0.12, innermost 1 - 0.18 + 0.18. The columns have areas in proportion to their radii; the mean
// over them is 1 again.
TEST(AcrossTread, IsALineAndAParabolaAcrossTheTread) {
    const Bench bench = sliding_bench();
    const std::vector<double> ratios = heat_ratio(law(4.0, 0.8, 1.0), in_bend(2500.0, -0.05, 2.3e5, 5000.0));
    const auto& faces = bench.mesh.patches[at(bench.mesh.find_patch("outside"))].faces;
    ASSERT_EQ(ratios.size(), edges.size() - 1);
    std::vector<double> pressure;
    double mean = 0.0;
    double area = 0.0;
    for (std::size_t i = 0; i < ratios.size(); ++i) {
        const double y1 = edges[i];
        const double y2 = edges[i + 1];
        pressure.push_back(1.0 + 0.2 * 0.5 * (y1 + y2) - 0.25 * 0.5 * (1.0 - (y1 * y1 + y1 * y2 + y2 * y2)));
        mean += faces[i].area * pressure.back();
        area += faces[i].area;
    }
    EXPECT_NEAR(pressure[outermost], 1.36, 1e-12);
    EXPECT_NEAR(pressure[middle], 0.88, 1e-12);
    EXPECT_NEAR(mean / area, 1.0, 0.01);
    for (std::size_t i = 0; i < ratios.size(); ++i) {
        EXPECT_NEAR(ratios[i], pressure[i] * area / mean, 1e-12) << "column " << i;
    }
}

// The order of outside, middle and inside for every sign: a force towards the middle of the car (the outer tire of a bend) and
// positive camber load the outside, their opposites the inside; what is soft or overloaded presses with both shoulders, what is hard or
// unloaded with its crown; where nothing pulls, all are alike.
TEST(AcrossTread, LoadsTheShoulderThatForceAndCamberPressDown) {
    const auto sign = [](double x) { return x > 1e-9 ? 1 : x < -1e-9 ? -1 : 0; };
    const auto leans = [&](double force, double camber) {
        const std::vector<double> p = heat_ratio(law(5.0, 0.6, 0.0), in_bend(force, camber));
        return sign(p[outermost] - p[innermost]);
    };
    EXPECT_EQ(leans(3000.0, 0.0), 1);
    EXPECT_EQ(leans(-3000.0, 0.0), -1);
    EXPECT_EQ(leans(1e-3, 0.05), 1);
    EXPECT_EQ(leans(1e-3, -0.05), -1);
    EXPECT_EQ(leans(4000.0, -0.05), 1);  // 0.6 - 0.25
    EXPECT_EQ(leans(-4000.0, 0.05), -1);
    EXPECT_EQ(leans(4000.0, -0.12), 0);  // 0.6 - 0.6
    const auto bulges = [&](double pressure, double load) {
        const std::vector<double> p = heat_ratio(law(0.0, 0.0, 1.0), in_bend(1000.0, 0.0, pressure, load));
        EXPECT_NEAR(p[outermost], p[innermost], 1e-12);
        return sign(p[middle] - p[outermost]);
    };
    EXPECT_EQ(bulges(2.05e5, 4000.0), -1);
    EXPECT_EQ(bulges(2.55e5, 4000.0), 1);
    EXPECT_EQ(bulges(2.3e5, 5000.0), -1);
    EXPECT_EQ(bulges(2.3e5, 3000.0), 1);
    EXPECT_EQ(bulges(2.3e5, 4000.0), 0);
}

// Rhyne's stiffness of the 225/50 R17 is 9.80665e3 (0.00028 p sqrt(0.83 225 (225 + 436.6)) + 3.45) = 9.80665e3 (0.098422 p + 3.45)
// N/m with p in kPa, so that a quarter of a bar less, 205 for 230 kPa, deflects it by (0.098422 230 + 3.45)/(0.098422 205 + 3.45) =
// 1.104144 as much: c = -0.104144, of which the middle between -0.2 and 0.2 loses 0.48 and the edge between 0.8 and 1 gains 0.72.
TEST(AcrossTread, AQuarterOfABarLessMovesHeatFromTheMiddleToTheShoulders) {
    const std::vector<double> p = heat_ratio(law(0.0, 0.0, 1.0), in_bend(1000.0, 0.0, 2.05e5));
    EXPECT_NEAR(p[middle] / p[outermost], (1.0 - 0.48 * 0.104144) / (1.0 + 0.72 * 0.104144), 2e-6);
    Bench unknown = sliding_bench();
    unknown.tire.reference_pressure = 0.0;  // of a case without inflation_pressure
    EXPECT_EQ(heat_ratio(law(0.0, 0.0, 1.0), in_bend(1000.0, 0.0, 2.05e5), unknown)[middle], 1.0);
}

// 200 moments with skews to 3 and crowns to 3, beyond what any contact bears: on a tread of one temperature the watts of every
// effect in the contact are those of an even contact, and no place gives heat back that it was not given.
TEST(AcrossTread, KeepsEveryTotalAndIsNeverNegative) {
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    using Parts = std::vector<Part>;
    for (const Parts& contact : {Parts{{"sliding_friction"}, {"road_contact"}, {"contact_pressure_conductance"}},
                                 Parts{{"sliding_friction", {}, {{"partition", 1}}}, {"resolved_contact"}},
                                 Parts{{"sliding_friction", {}, {{"around", 1}}}, {"travelling_contact"}}}) {
        Parts parts = contact;
        parts.push_back(law(5.0, 0.6, 1.0));
        Bench bench = sliding_bench();
        Whole even(bench, contact);
        Whole loaded(bench, parts);
        for (int i = 0; i < 200; ++i) {
            Inputs in = in_bend(20000.0 * unit(random), 0.1 * unit(random), 2.3e5 + 2e5 * unit(random),
                                9000.0 + 8000.0 * unit(random));
            in.wheel_angle = std::numbers::pi;  // where a column meets the road
            in.road_temperature = 300.0;
            even.ask(in);
            loaded.ask(in);
            for (const Part& part : contact) {
                const double watts = even.watts(part.id);
                ASSERT_NE(watts, 0.0) << part.id;
                EXPECT_NEAR(loaded.watts(part.id), watts, 1e-13 * std::abs(watts)) << part.id;
            }
            ASSERT_GE(*std::ranges::min_element(loaded.system().terms().node_G), 0.0);
        }
    }
    for (const double force : {-2e4, 2e4}) {  // a skew of 3: the contact is drawn off one shoulder
        const std::vector<double> p = heat_ratio(law(0.0, 0.6, 0.0), in_bend(force, 0.0));
        EXPECT_GE(*std::ranges::min_element(p), 0.0);
        EXPECT_EQ(p[force > 0.0 ? innermost : outermost], 0.0);
    }
}

// A footprint of the user's own, twice as loaded inside as on the mean and not at all outside, keeps its total of 1 under any
// pressure, and in proportion as by the root; where the law leaves nothing of it, it stays as the user gave it.
TEST(AcrossTread, KeepsTheTotalOfAProfile) {
    const Bench bench = sliding_bench();
    ActiveEffect friction = activate(*find_effect("sliding_friction"), bench.mesh);
    friction.tables[0] = Curve::table({-0.1125, 0.1125}, {0.0, 2.0});
    bench.place(friction);
    for (const FollowsPressure follows : {FollowsPressure::in_proportion, FollowsPressure::by_root}) {
        for (const double skew : {-3.0, 0.0, 0.5, 3.0, 30.0}) {
            for (const double crown : {-3.0, 0.0, 2.0}) {
                const AcrossTread across(friction, skew, crown, follows);
                double sum = 0.0;
                for (std::size_t i = 0; i < friction.nodes.size(); ++i) {
                    EXPECT_GE(across.weight(i), 0.0);
                    sum += across.weight(i);
                }
                EXPECT_NEAR(sum, 1.0, 1e-14) << skew << ' ' << crown;
            }
        }
    }
    friction.weights.assign(friction.weights.size(), 0.0);
    friction.weights[innermost] = 1.0;
    EXPECT_EQ(AcrossTread(friction, 30.0, 0.0).weight(innermost), 1.0);
}

// Two half-spaces that meet exchange with the root of the time: where the pressure is 1.36 and 0.88 of the mean, the rolling
// contact takes as the roots of the two, 1.2431 to one.
TEST(AcrossTread, ARollingContactExchangesWithTheRootOfThePressure) {
    const Bench bench = sliding_bench();
    Whole even(bench, {{"resolved_contact"}});
    Whole loaded(bench, {{"resolved_contact"}, law(4.0, 0.8, 1.0)});
    const Inputs in = in_bend(2500.0, -0.05, 2.3e5, 5000.0);
    even.ask(in);
    loaded.ask(in);
    const auto& faces = bench.mesh.patches[at(bench.mesh.find_patch("outside"))].faces;
    const auto ratio = [&](std::size_t i) { return loaded.flow(faces[i].node) / even.flow(faces[i].node); };
    EXPECT_NEAR(ratio(outermost) / ratio(middle), std::sqrt(1.36 / 0.88), 1e-12);
}

// A tread of one column has one place, and two nodes have one surface: the same heat to the last digits whatever is asked for.
TEST(AcrossTread, ChangesNothingOnOneColumnAndOnTwoNodes) {
    Bench column = section();
    column.mesh = mesh::build(mesh::Section{
        .layers = {{.name = "tread", .thickness = 0.008, .cells = 2}, {.name = "liner", .thickness = 0.002}},
        .zones = {{.name = "crown", .length = 0.225, .cells = 1, .stack = {0, 1}}}});
    column.materials.assign(2, rubber());
    column.T.assign(at(column.mesh.n_nodes), 330.0);
    for (const Bench& bench : {column, two_nodes()}) {
        const std::vector<Part> parts{{"sliding_friction"}, {"road_contact"}};
        Whole even(bench, parts);
        Whole loaded(bench, {parts[0], parts[1], law(5.0, 0.6, 1.0)});
        const Inputs in = in_bend(3000.0, -0.05, 2e5, 5000.0);
        even.ask(in);
        loaded.ask(in);
        for (int node = 0; node < bench.mesh.n_nodes; ++node) {
            EXPECT_DOUBLE_EQ(loaded.flow(node), even.flow(node));
        }
    }
}

// Where it moves nothing (a camber, force or deflection of nothing to lean by) and where it is not switched on, the weights are
// the effect's own to the last bit.
TEST(AcrossTread, IsEvenToTheLastBitWhereNothingPulls) {
    const ActiveEffect friction = sliding_bench().active("sliding_friction");
    const AcrossTread across(friction, 0.0, 0.0);
    for (std::size_t i = 0; i < friction.weights.size(); ++i) {
        EXPECT_EQ(across.weight(i), friction.weights[i]);
    }
}

// Nothing conducts here, so that a node's heat follows its own temperature alone: with a tread whose k(T) doubles within 70 K and
// the road's share by effusivities, its slope is the central difference over +- 1 mK, which leaves 1e-6 of it.
TEST(AcrossTread, GivesTheSlopesOfItsHeat) {
    Bench bench = sliding_bench();
    for (Material& material : bench.materials) {
        material.conductivity.fill(Curve::quadratic_about(293.15, 0.29, 0.0043, 0.0).within(263.15, 393.15));
    }
    Whole whole(bench, {{"sliding_friction", {}, {{"partition", 1}}}, {"resolved_contact"}, law(5.0, 0.6, 1.0)});
    const Inputs in = in_bend(2500.0, -0.02, 2e5, 5000.0);
    for (const mesh::PatchFace& face : bench.mesh.patches[at(bench.mesh.find_patch("outside"))].faces) {
        const auto flow = [&](double shift) {
            std::vector<double> T = bench.T;
            T[at(face.node)] += shift;
            return whole.ask(in, T).flow(face.node);
        };
        const double slope = (flow(1e-3) - flow(-1e-3)) / 2e-3;
        whole.ask(in, bench.T);
        const Terms& terms = whole.system().terms();
        EXPECT_NEAR(terms.node_slope[at(face.node)] - terms.node_G[at(face.node)], slope, 1e-6 * std::abs(slope));
    }
}

// Of the shape above, a = 0.2 and c = -0.25: over the outside shoulder, 0.6 to 1, 1 + 0.2 0.8 - 0.25 (1 - 1.96)/2 = 1.28; over the
// crown, -0.6 to 0.6, 1 - 0.25 (1 - 0.36)/2 = 0.92; over the inside shoulder 1 - 0.16 + 0.12 = 0.96. Shoulders are of smaller
// radius than the crown by some per cent, and so is their area. A mesh without these zones has the mean everywhere.
TEST(AcrossTread, IsToldByZones) {
    const Bench bench = sliding_bench();
    const Whole whole(bench, {{"sliding_friction"}, law(4.0, 0.8, 1.0)});
    const Laws laws = whole.system().laws(in_bend(2500.0, -0.05, 2.3e5, 5000.0));
    const auto told = [&](std::string_view zone) {
        return relative_contact_pressure(bench.mesh, whole.system().effects(), laws, zone);
    };
    EXPECT_NEAR(told("outside_shoulder"), 1.28, 0.01);
    EXPECT_NEAR(told("crown"), 0.92, 0.01);
    EXPECT_NEAR(told("inside_shoulder"), 0.96, 0.01);
    EXPECT_EQ(told("rim"), 1.0);
    const Whole lumps(two_nodes(), {{"sliding_friction"}});
    EXPECT_EQ(relative_contact_pressure(lumps.problem().mesh, lumps.system().effects(), laws, "crown"), 1.0);
}

}  // namespace tiretherm::physics
