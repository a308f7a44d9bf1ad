// SPDX-License-Identifier: BSD-3-Clause
// A drum that the tire heats: watts by hand on the bench of two nodes and on a section, its transient and its steady state,
// the balance of tire and drum, derivatives beside every contact.
//
// rolling() of the bench: 4000 N, 100 km/h, air and road at 23 degC = 296.15 K. road_contact: 500 W/(m2 K) on 2.333e-6 * 4000
// = 9.332e-3 m2 is 4.666 W/K. Sliding of driven(): 2000 N * 27.7778 m/s * 0.0349208 + 500 N * 0.2777778 m/s = 2078.93 W.
#include <cmath>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

#include "mesh/index.hpp"
#include "physics/effects/effect_contract.hpp"
#include "support/problem.hpp"
#include "support/tire_section.hpp"

namespace tiretherm::physics {

namespace {

Part heated_drum(std::vector<std::pair<std::string_view, double>> numbers = {}) {
    return {.id = "drum_heating", .numbers = std::move(numbers)};
}

double sum_of_drum_flows(const Whole& whole) {
    const std::span<const double> q = whole.system().heat_flow();
    return std::accumulate(q.begin(), q.end(), 0.0);
}

/// A tire section at 100 km/h and 4000 N with these effects alone, all at 23 degC.
solver::Problem rolling_section(std::initializer_list<std::string_view> effects) {
    solver::Problem problem;
    problem.mesh = mesh::build(support::tire_section(problem.tire, 1));
    problem.materials.assign(problem.mesh.layers.size(), support::material(0.29, 1100.0, 1800.0));
    for (const std::string_view id : effects) {
        support::switch_on(problem, id);
    }
    support::hold(problem, "speed", 100.0 / 3.6);
    support::hold(problem, "vertical_load", 4000.0);
    support::hold(problem, "air_temperature", 296.15);
    support::hold(problem, "road_temperature", 296.15);
    support::start_at(problem, 296.15);
    return problem;
}

}  // namespace

TEST(DrumHeating, StandsInThePlaceOfTheRoad) {
    // Surface 35, drum 30, air 23 degC: 4.666 W/K * 5 K = 23.33 W into the drum, which loses 150 W/K * 7 K = 1050 W.
    Whole whole(two_nodes(), {{"road_contact"}, heated_drum()});
    whole.ask(rolling(), {308.15, 328.15, 303.15});
    EXPECT_NEAR(whole.flow(0), -23.33, 1e-9);
    EXPECT_NEAR(whole.flow(whole.node("drum")), 23.33 - 1050.0, 1e-9);
    EXPECT_EQ(whole.watts("road_contact"), 0.0) << "from node to node";
    EXPECT_NEAR(whole.watts("drum_heating"), -1050.0, 1e-9) << "what leaves to the air";
    EXPECT_EQ(whole.system().capacity(2, 300.0), 2e5);
    // A quarter of the road's heat: the rest meets road_temperature, 4.666 (0.25 * 5 + 0.75 * 12) = 47.8265 W.
    Whole quarter(two_nodes(), {{"road_contact"}, heated_drum({{"share", 0.25}})});
    quarter.ask(rolling(), {308.15, 328.15, 303.15});
    EXPECT_NEAR(quarter.flow(0), -47.8265, 1e-9);
    EXPECT_NEAR(quarter.flow(quarter.node("drum")), 0.25 * 23.33 - 1050.0, 1e-9);
}

TEST(DrumHeating, LosesHeatByTheSpeedOfItsSurface) {
    // 150 W/K at 100 km/h, 2^(2/3) of it at 200 km/h, either way round, and 25 W/K at rest and up to 100 (25/150)^(3/2) =
    // 6.80 km/h; 10 K above the air.
    Whole whole(two_nodes(), {heated_drum()});
    const auto loss = [&](double kmh) {
        Inputs in = rolling();
        in.speed = kmh / 3.6;
        return -whole.ask(in, {308.15, 328.15, 306.15}).watts("drum_heating");
    };
    EXPECT_NEAR(loss(100.0), 1500.0, 1e-9);
    EXPECT_NEAR(loss(-200.0), 1500.0 * std::cbrt(4.0), 1e-9);
    EXPECT_NEAR(loss(0.0), 250.0, 1e-9);
    EXPECT_NEAR(loss(6.8), 250.0, 1e-9);
    EXPECT_GT(loss(6.9), 250.5);
}

TEST(DrumHeating, TakesTheRoadsPartOfTheHeatOfSliding) {
    // 0.6 of 2078.93 W enter the tread and 0.4 the drum, 831.57 W; all of it is made by sliding.
    Whole plain(two_nodes(), {{"sliding_friction"}});
    Whole whole(two_nodes(), {{"sliding_friction"}, heated_drum()});
    const std::vector<double> T{296.15, 296.15, 296.15};
    plain.ask(driven(), {296.15, 296.15});
    whole.ask(driven(), T);
    EXPECT_NEAR(whole.flow(0), plain.flow(0), 1e-9);
    EXPECT_NEAR(whole.flow(whole.node("drum")), 831.57, 0.02);
    EXPECT_NEAR(whole.watts("sliding_friction"), 2078.93, 0.04);
    // A law that lets the tread take 1.81 of the power makes no cold drum.
    Whole beyond(two_nodes(), {{"sliding_friction"}, {"partition_speed", {{"slope", 2.0}}}, heated_drum()});
    beyond.ask(driven(), T);
    EXPECT_GE(beyond.flow(beyond.node("drum")), 0.0);
    EXPECT_NEAR(beyond.flow(0) + beyond.flow(beyond.node("drum")), beyond.watts("sliding_friction"), 1e-9);
}

TEST(DrumHeating, TakesAllThatAResolvedContactGivesTheRoad) {
    // By the partition "charm" and by a number of which the contact takes a part back: with everything at one temperature the
    // tread gets what it gets on a road that stays as it is, and the drum the rest of the friction power.
    for (const Bench& bench : {two_nodes(), section()}) {
        for (const int charm : {0, 1}) {
            const std::vector<Part> parts{{"resolved_contact"},
                                          {.id = "sliding_friction", .choices = {{"partition", charm}}}};
            Whole plain(bench, parts);
            std::vector<Part> beside = parts;
            beside.push_back(heated_drum());
            Whole whole(bench, beside);
            plain.ask(driven(), std::vector<double>(n_nodes(plain), 296.15));
            whole.ask(driven(), std::vector<double>(n_nodes(whole), 296.15));
            const double tread = sum_of_drum_flows(plain);
            EXPECT_NEAR(sum_of_drum_flows(whole), 2078.93, 0.04);
            EXPECT_NEAR(whole.flow(whole.node("drum")), 2078.93 - tread, 0.04) << bench.mesh.kind << charm;
            EXPECT_NEAR(whole.watts("sliding_friction"), 2078.93, 0.04);
            EXPECT_NEAR(whole.watts("resolved_contact"), 0.0, 1e-9);
        }
    }
}

TEST(DrumHeating, GivesTheDerivativesOfItsHeatBesideEveryContact) {
    // d(flow)/dT of every node in a random direction against a central difference over 2e-3 K, with a tread whose k(T) turns
    // the effusivity; half of the road's heat, so that both ways count.
    for (Bench bench : {two_nodes(), section()}) {
        for (Material& material : bench.materials) {
            material.conductivity.fill(Curve::quadratic_about(293.15, 0.29, 0.002, 0.0));
        }
        for (const char* contact : {"road_contact", "resolved_contact", "travelling_contact"}) {
            if (!can_act(*find_effect(contact), bench)) {
                continue;
            }
            const int around = std::string_view(contact) == "travelling_contact" ? 1 : 0;
            Whole whole(bench, {{contact},
                                {.id = "sliding_friction", .choices = {{"partition", 1}, {"around", around}}},
                                {"contact_pressure_conductance"},
                                heated_drum({{"share", 0.5}})});
            std::mt19937_64 random(31);
            const std::vector<double> T = random_field(n_nodes(whole), random, 300.0, 360.0);
            const std::vector<double> v = random_field(n_nodes(whole), random, -1.0, 1.0);
            const auto flow = [&](double step) {
                std::vector<double> moved = T;
                for (std::size_t i = 0; i < T.size(); ++i) {
                    moved[i] += step * v[i];
                }
                const std::span<const double> q = whole.ask(lively(), moved).system().heat_flow();
                return std::vector<double>(q.begin(), q.end());
            };
            const std::vector<double> up = flow(1e-3);
            const std::vector<double> down = flow(-1e-3);
            const Terms& terms = whole.ask(lively(), T).system().terms();
            const mesh::Mesh& mesh = whole.problem().mesh;
            std::vector<double> product(T.size());
            double scale = 0.0;
            for (std::size_t i = 0; i < T.size(); ++i) {
                product[i] = (terms.node_slope[i] - terms.node_G[i]) * v[i];
            }
            for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
                const std::size_t a = at(mesh.faces[f].a);
                const std::size_t b = at(mesh.faces[f].b);
                const double change =
                    terms.face_G[f] * (v[b] - v[a]) + terms.face_dq_dTa[f] * v[a] + terms.face_dq_dTb[f] * v[b];
                product[a] += change;
                product[b] -= change;
                scale = std::max(scale, std::abs(change));
            }
            for (std::size_t i = 0; i < T.size(); ++i) {
                EXPECT_NEAR(product[i], (up[i] - down[i]) / 2e-3, 2e-6 * scale + 1e-9) << contact << " node " << i;
            }
        }
    }
}

TEST(DrumHeating, CoolsDownByItselfAsAnExponential) {
    // Nothing touches: C/G = 2e5/150 = 1333.3 s, from 50 to 23 degC; after 1000 s 296.15 + 27 exp(-0.75) = 308.9039 K.
    solver::Problem problem = rolling_section({"conduction", "drum_heating"});
    const int node = problem.mesh.find_lumped_node("drum");
    problem.initial[at(node)] = 323.15;
    problem.settings.end = 1000.0;
    problem.settings.tolerance = 1e-4;
    problem.channels = {{.name = "drum", .meaning = "", .where = problem.mesh.regions.back().mean}};
    const solver::MarchReport report = solver::run(problem, [](const solver::Snapshot&) { return true; });
    EXPECT_NEAR(report.channel_final.front(), 296.15 + 27.0 * std::exp(-0.75), 1e-3);
    EXPECT_LT(report.energy_closure, 1e-12);
}

TEST(DrumHeating, StandsWhereTheAirTakesWhatTheTireMakes) {
    // 2000 N and 2 degrees at 100 km/h: 2000 * 27.7778 * 0.0349208 = 1940.04 W, which leave by the drum alone: 1940.04/150 =
    // 12.9336 K above the air. 0.6 of them come from the tread, 1164.02/4.666 = 249.470 K above the drum.
    solver::Problem problem = rolling_section({"conduction", "sliding_friction", "road_contact", "drum_heating"});
    support::hold(problem, "slip_angle", 2.0 * support::deg);
    support::hold(problem, "lateral_force", 2000.0);
    problem.settings.steady = true;
    const int outside = problem.mesh.find_patch("outside");
    problem.channels = {{.name = "drum", .meaning = "", .where = problem.mesh.regions.back().mean},
                        {.name = "surface", .meaning = "", .where = mesh::over_patch(problem.mesh, outside)}};
    const solver::MarchReport report = solver::run(problem, [](const solver::Snapshot&) { return true; });
    ASSERT_TRUE(report.status.ok()) << report.status.message;
    const double power = 2000.0 * 100.0 / 3.6 * std::tan(2.0 * support::deg);
    const double above_air = power / 150.0;
    EXPECT_NEAR(report.channel_final[0], 296.15 + above_air, 1e-6);
    EXPECT_NEAR(report.channel_final[1], 296.15 + above_air + 0.6 * power / 4.666, 1e-4);
}

TEST(DrumHeating, ClosesTheBalanceOfTireAndDrumWithEveryContact) {
    // What is made less what leaves to the air is what tire, gas, rim and drum hold more; and the heat of a drum is not
    // lost: a tire on it is warmer than on a road that stays cold.
    for (const std::string_view contact : {"road_contact", "resolved_contact"}) {
        double peak_on_cold_road = 0.0;
        for (const bool heated : {false, true}) {
            solver::Problem problem = support::tire_problem(1);
            std::erase_if(problem.effects, [](const ActiveEffect& a) { return a.effect->id == "road_contact"; });
            support::switch_on(problem, contact);
            if (heated) {
                support::switch_on(problem, "drum_heating", {{"capacity", 9e4}});
            }
            support::hold(problem, "slip_angle", 1.0 * support::deg);
            support::hold(problem, "lateral_force", 1500.0);
            support::start_at(problem, 296.15);
            const solver::MarchReport report = solver::run(problem, [](const solver::Snapshot&) { return true; });
            ASSERT_TRUE(report.status.ok()) << report.status.message;
            EXPECT_LT(report.energy_closure, 1e-12) << contact;
            peak_on_cold_road = heated ? peak_on_cold_road : report.hottest.temperature;
            EXPECT_TRUE(!heated || report.hottest.temperature > peak_on_cold_road + 0.01) << contact;
        }
    }
}

}  // namespace tiretherm::physics
