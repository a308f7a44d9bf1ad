// SPDX-License-Identifier: BSD-3-Clause
// sidewall_convection and rim_conduction with the film of a rotating disk: watts by hand on the bench of two nodes (bulk
// 55 C, air 23 C, 4000 N), the tangent, the place where the mesh has sidewalls, the floor at rest.
//
// Air of 296.15 K: k = 0.0263 (296.15/300)^0.85 = 0.0260128 W/(m K), nu = 1.589e-5 (296.15/300)^1.78 = 1.552884e-5 m2/s.
// The tire turns with V/R_R, R_R = 0.3483 * 4000^-0.009 = 0.323247 m. Its sidewalls reach from 0.2183 m to 0.3308 m, both
// together 2 pi (0.109429 - 0.047655) = 0.388136 m2. The film of the bulk is at (328.15 + 296.15)/2 = 312.15 K, 1.054027
// times the air.
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "physics/effects/effect_contract.hpp"

namespace tiretherm::physics {

namespace {

Part disk(std::string_view id, std::vector<std::pair<std::string_view, double>> numbers = {}) {
    return {.id = id, .numbers = std::move(numbers), .choices = {{"film", 1}}};
}

Inputs disk_at_speed(double kmh) {
    Inputs in = rolling();
    in.speed = kmh / 3.6;
    return in;
}

}  // namespace

TEST(SidewallDisk, HasNaturalConvectionAtRest) {
    // h = 1.42 (32/0.6616)^0.25 = 3.74479 W/m2K; -32 * 0.388136 * 3.74479 = -46.512 W.
    Whole whole(two_nodes(), {disk("sidewall_convection")});
    EXPECT_NEAR(whole.ask(disk_at_speed(0.0)).watts("sidewall_convection"), -46.512, 1e-3);
    EXPECT_NEAR(whole.flow(1), -46.512, 1e-3);
    EXPECT_EQ(whole.flow(0), 0.0);
}

TEST(SidewallDisk, IsLaminarAtWalkingPace) {
    // 10 km/h: w = 8.59335 rad/s, w/nu = 553 380: Re = 60 556 at R0. 0.36 * 0.0260128 * 743.895 = 6.96630 W/m2K; the film:
    // times 1.054027^-0.04 = 0.997897, 6.95165; -32 * 0.388136 * 6.95165 = -86.342 W. Either way round.
    Whole whole(two_nodes(), {disk("sidewall_convection")});
    EXPECT_NEAR(whole.ask(disk_at_speed(10.0)).watts("sidewall_convection"), -86.342, 1e-3);
    EXPECT_NEAR(whole.ask(disk_at_speed(-10.0)).watts("sidewall_convection"), -86.342, 1e-3);
}

TEST(SidewallDisk, IsTurbulentOnTheMotorway) {
    // 150 km/h: w = 128.900 rad/s, Re = 395 569 at 0.2183 m. 0.0195 * 0.0260128 * (w/nu)^0.8 = 5.07250e-4 * 342 998 =
    // 173.986; times 2/2.6 (0.3308^2.6 - 0.2183^2.6)/(0.3308^2 - 0.2183^2) = 0.463536: 80.6487 W/m2K; the film: times
    // 1.054027^-0.574 = 0.970249, 78.2493; -32 * 0.388136 * 78.2493 = -971.88 W.
    Whole whole(two_nodes(), {disk("sidewall_convection")});
    EXPECT_NEAR(whole.ask(disk_at_speed(150.0)).watts("sidewall_convection"), -971.88, 1e-2);
}

TEST(SidewallDisk, DoesNotCountTheConstants) {
    Whole plain(two_nodes(), {disk("sidewall_convection")});
    Whole numbered(two_nodes(), {disk("sidewall_convection", {{"conductance", 80.0}, {"h", 70.0}})});
    Whole half(two_nodes(), {disk("sidewall_convection", {{"disk_scale", 0.5}})});
    const double watts = plain.ask(rolling()).watts("sidewall_convection");
    EXPECT_EQ(numbered.ask(rolling()).watts("sidewall_convection"), watts);
    EXPECT_NEAR(half.ask(rolling()).watts("sidewall_convection"), 0.5 * watts, 1e-9);
}

TEST(SidewallDisk, HasNoJumpWithTheSpeed) {
    // From 0.11 m/s, where the wheel turns, to 60 m/s in steps of 0.3 %: w dh/dw is 2.674 h at most
    // (RotatingDisk.HasNoJumpAtTheTransition), which makes 0.81 % in a step. Laminar to turbulent at once would double it.
    Whole whole(two_nodes(), {disk("sidewall_convection")});
    double before = 0.0;
    for (double speed = 0.11; speed < 60.0; speed *= 1.003) {
        const double watts = whole.ask(disk_at_speed(3.6 * speed)).watts("sidewall_convection");
        if (before != 0.0) {
            ASSERT_GE(watts / before, 1.0 - 1e-12) << speed;
            ASSERT_LE(watts / before, 1.0082) << speed;
        }
        before = watts;
    }
}

TEST(SidewallDisk, CoolsThePatchWhereThereAreSidewalls) {
    // Everything 10 K above the air, 120 km/h: w = 103.120 rad/s, Re = 316 455 at 0.2183 m. 5.07250e-4 * (103.120/
    // 1.552884e-5)^0.8 = 5.07250e-4 * 286 922 = 145.541, times 0.463536 = 67.4636 W/m2K; the film, 301.15 K: times
    // 1.016883^-0.574 = 0.990436, 66.8184 on the area of the patch.
    const Bench bench = section();
    Whole whole(bench, {disk("sidewall_convection")});
    whole.ask(disk_at_speed(120.0), std::vector<double>(bench.T.size(), 306.15));
    const mesh::Patch& walls = bench.mesh.patches[static_cast<std::size_t>(bench.mesh.find_patch("sidewalls"))];
    double given = 0.0;
    for (const mesh::PatchFace& face : walls.faces) {
        given += whole.flow(face.node);
    }
    EXPECT_NEAR(given / (-10.0 * walls.area()), 66.8184, 1e-3);
    EXPECT_NEAR(given, whole.watts("sidewall_convection"), 1e-9);
}

TEST(SidewallDisk, LeavesTheFloorToNaturalConvectionOnTheSamePatch) {
    // The still air of a wheel at rest is counted once. Rolling, natural_convection is off and nothing changes.
    const Bench bench = section();
    const int walls = bench.mesh.find_patch("sidewalls");
    const auto watts = [&](const std::vector<std::string_view>& ids, int patch, double kmh) {
        solver::Problem problem = Whole::problem_of(bench, {});
        for (const std::string_view id : ids) {
            ActiveEffect active = activate(*find_effect(id), problem.mesh);
            if (id == "sidewall_convection") {
                active.choices = {1};
            } else {
                active.patches = {patch};
            }
            solver::switch_on(problem, std::move(active), 296.15);
        }
        const solver::System system(problem);
        std::vector<double> coefficients(system.n_coefficients());
        system.evaluate_coefficients(disk_at_speed(kmh), coefficients);
        solver::System evaluated(problem);
        evaluated.evaluate(bench.T, coefficients);
        return evaluated.terms().watts.front();
    };
    const int outside = bench.mesh.find_patch("outside");
    const double alone = watts({"sidewall_convection"}, walls, 0.0);
    EXPECT_LT(alone, 0.0);
    EXPECT_EQ(watts({"sidewall_convection", "natural_convection"}, walls, 0.0), 0.0);
    EXPECT_EQ(watts({"sidewall_convection", "natural_convection"}, outside, 0.0), alone);
    EXPECT_EQ(watts({"sidewall_convection", "natural_convection"}, walls, 80.0),
              watts({"sidewall_convection"}, walls, 80.0));
}

TEST(RimDisk, IsCooledAsADiskFromTheAxisOn) {
    // Rim at 30 C, 7 K above the air, 100 km/h: w = 85.9335 rad/s, transition at sqrt(2.4e5 nu/w) = 0.208254 m of 0.2183 m.
    // Laminar: 0.36 * 0.0260128 * 2352.40 * 0.910081 = 20.0485; turbulent: 5.07250e-4 * 247 981 * 2/2.6 (0.2183^2.6 -
    // 0.208254^2.6)/0.2183^2 = 125.788 * 0.0355841 = 4.47607. The film, 1.011818 times the air: 20.0485 * 0.999530 +
    // 4.47607 * 0.993279 = 24.4851 W/m2K, on 0.5 m2: -85.698 W. Bulk at the rim's temperature: nothing through the bead.
    Whole whole(two_nodes(), {disk("rim_conduction")});
    whole.ask(rolling(), {303.15, 303.15, 303.15});
    EXPECT_NEAR(whole.flow(whole.node("rim")), -85.698, 1e-3);
    EXPECT_NEAR(whole.flow(1), 0.0, 1e-12);
    // At rest 1.42 (7/0.4366)^0.25 = 2.84146 W/m2K on 0.5 m2: -9.9451 W.
    whole.ask(disk_at_speed(0.0), {303.15, 303.15, 303.15});
    EXPECT_NEAR(whole.flow(whole.node("rim")), -9.9451, 1e-4);
}

TEST(DiskFilm, GivesTheDerivativesOfItsHeat) {
    // Slope of the flow into each cooled node against a central difference over 2e-3 K: its error is a sixth of the third
    // derivative times 1e-6 K2. Natural convection has the largest, 0.5 h/dT^2, 1e-9 of h at dT = 30 K.
    for (const double kmh : {0.0, 10.0, 60.0, 90.0, 150.0}) {
        for (const Bench& bench : {two_nodes(), section()}) {
            Whole whole(bench, {disk("sidewall_convection"), disk("rim_conduction")});
            std::mt19937_64 random(21);
            const std::vector<double> T = random_field(n_nodes(whole), random, 310.0, 380.0);
            const auto flow = [&](double shift) {
                std::vector<double> moved = T;
                for (double& t : moved) {
                    t += shift;  // the same everywhere: nothing flows between nodes that did not before
                }
                const std::span<const double> q = whole.ask(disk_at_speed(kmh), moved).system().heat_flow();
                return std::vector<double>(q.begin(), q.end());
            };
            const std::vector<double> up = flow(1e-3);
            const std::vector<double> down = flow(-1e-3);
            const Terms& terms = whole.ask(disk_at_speed(kmh), T).system().terms();
            for (std::size_t i = 0; i < T.size(); ++i) {
                const double slope = terms.node_slope[i] - terms.node_G[i];
                EXPECT_NEAR((up[i] - down[i]) / 2e-3, slope, 1e-7 + 1e-7 * std::abs(slope)) << i << " at " << kmh;
            }
            EXPECT_LT(*std::ranges::min_element(terms.node_slope), *std::ranges::max_element(terms.node_slope));
        }
    }
}

TEST(DiskFilm, IsFiniteAndNeverNegativeWhateverTheInputs) {
    std::mt19937_64 random(22);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    for (const double transition : {0.0, 2.4e5, 1e8}) {
        Whole whole(section(), {disk("sidewall_convection", {{"transition", transition}}),
                                disk("rim_conduction", {{"transition", transition}})});
        for (int i = 0; i < 100; ++i) {
            Inputs in = rolling();
            in.speed = i % 9 == 0 ? 0.0 : 200.0 * (unit(random) - 0.5);
            in.vertical_load = i % 7 == 0 ? 0.0 : 12000.0 * unit(random);
            in.air_temperature = 230.0 + 100.0 * unit(random);
            whole.ask(in, random_field(n_nodes(whole), random, 250.0, 450.0));
            for (const double q : whole.system().heat_flow()) {
                ASSERT_TRUE(std::isfinite(q));
            }
            ASSERT_LT(whole.system().terms().negative_effect, 0);
        }
        whole.ask(rolling(), std::vector<double>(n_nodes(whole), 296.15));
        for (const double q : whole.system().heat_flow()) {
            EXPECT_EQ(q, 0.0) << "everything at the temperature of the air";
        }
    }
}

}  // namespace tiretherm::physics
