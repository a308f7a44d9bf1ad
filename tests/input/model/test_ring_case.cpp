// SPDX-License-Identifier: BSD-3-Clause
// Cases with a ring or a travelling contact: mesh, sensors at an angle, wheel angle, and a closed heat budget.

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "mesh/ring.hpp"
#include "physics/contact/travelling.hpp"
#include "solver/time_integration/march.hpp"
#include "support/written.hpp"

// What a case with a ring, or with a contact that goes round, becomes. Errors are in tests/bad_cases/ring*.toml.
namespace tiretherm::input {

namespace {

Reading read_ring(const std::string& more) {
    const Written written;
    return read_case(written.add(
        "case.toml",
        "include = [\"" + (source_folder() / "tests/bad_cases/good/section.toml").string() + "\"]\n" + more));
}

const physics::ActiveEffect& ring_effect(const solver::Problem& problem, std::string_view id) {
    return *std::ranges::find_if(problem.effects, [&](const auto& active) { return active.effect->id == id; });
}

const std::string turning =
    "[effects.road_contact]\non = false\n[effects.travelling_contact]\n"
    "[effects.sliding_friction]\naround = \"in_contact\"\n";

}  // namespace

TEST(RingCase, IsTheSectionInSectorsReadAroundOrAtAnAngle) {
    const std::string sensors =
        "[[sensor]]\nname = \"mean\"\nkind = \"point\"\ndepth = \"1 mm\"\n"
        "[[sensor]]\nname = \"turned\"\nkind = \"point\"\ndepth = \"1 mm\"\nangle = \"90 deg\"\n";
    const Reading reading = read_ring("[mesh]\nsectors = 8\n" + sensors);
    ASSERT_TRUE(reading.problem) << render(reading);
    const mesh::Mesh& mesh = reading.problem->mesh;
    EXPECT_EQ(mesh.sectors, 8);
    EXPECT_EQ(mesh.kind, "ring");
    const auto find = [&](std::string_view name) {
        return *std::ranges::find(reading.problem->channels, name, &solver::Channel::name);
    };
    std::vector<double> T;
    for (int node = 0; node < mesh.n_nodes; ++node) {
        T.push_back(static_cast<double>(mesh::sector_of(mesh, node)));
    }
    EXPECT_NEAR(find("mean").where(T), 3.5, 1e-12);
    EXPECT_NEAR(find("turned").where(T), 2.0, 1e-12) << "90 of 360 deg are two of eight sectors";
    EXPECT_NE(find("turned").meaning.find("90 deg around the rubber"), std::string::npos);
    EXPECT_NE(find("mean").meaning.find("mean around the circumference"), std::string::npos);
}

// The case says 4 kN and 100 km/h: 27.78 m/s on 0.3232 m are 85.94 rad/s.
TEST(RingCase, TurnsTheWheelWhereAnEffectFollowsTheContact) {
    const Reading still = read_ring("");
    ASSERT_TRUE(still.problem) << render(still);
    const physics::Signal& angle = *physics::find_signal("wheel_angle");
    EXPECT_FALSE(still.problem->input_signals.gives(angle));
    const Reading reading = read_ring("[time]\nend = \"2 s\"\n" + turning);
    ASSERT_TRUE(reading.problem) << render(reading);
    const solver::Problem& problem = *reading.problem;
    ASSERT_TRUE(problem.input_signals.gives(angle));
    const physics::Inputs end = problem.input_signals.at(2.0, solver::JumpSide::before);
    EXPECT_NEAR(end.wheel_angle, 2.0 * end.speed / problem.tire.rolling_radius(end.vertical_load), 1e-9);
    EXPECT_EQ(ring_effect(problem, "travelling_contact").effect->n_coefficients(), 6)
        << "of one column: the road, three effusivities, skew and crown";
    // The strip is as wide as the tread, the contact is not.
    ASSERT_EQ(reading.warnings.size(), 1U) << render(reading);
    EXPECT_NE(reading.warnings[0].find("times as wide as the contact area over its length"), std::string::npos);
}

// A ring's contact takes heat in every sector once a turn, and its heat budget closes.
TEST(RingCase, WarnsWhereTheContactGoesRoundAndTheHeatOfSlidingDoesNot) {
    const std::string evenly = "[effects.road_contact]\non = false\n[effects.travelling_contact]\n";
    const auto warns = [](const Reading& reading) {
        return render(reading).find("but the heat of sliding is spread around it") != std::string::npos;
    };
    const std::string slip = "[drive]\nslip_angle = \"4 deg\"\nlateral_force = \"3 kN\"\n";
    EXPECT_TRUE(warns(read_ring(slip + evenly)));
    EXPECT_FALSE(warns(read_ring(slip + turning)));
    EXPECT_FALSE(warns(read_ring(evenly))) << "free rolling makes no such heat";
}

TEST(RingCase, RunsAndCloses) {
    const Reading reading = read_ring(
        "[mesh]\nsectors = 6\ncrown_cells = 1\nshoulder_cells = 0\nsidewall_cells = 0\n"
        "[time]\nend = \"0.16 s\"\noutput = \"10 ms\"\n[drive]\nlateral_force = \"1 kN\"\nslip_angle = \"2 deg\"\n" +
        turning);
    ASSERT_TRUE(reading.problem) << render(reading);
    const solver::MarchReport report = solver::run(*reading.problem, [](const solver::Snapshot&) { return true; });
    ASSERT_TRUE(report.status.ok()) << report.status.message;
    EXPECT_LT(report.energy_closure, 1e-10);
    double sliding = 0.0;
    for (std::size_t e = 0; e < report.joules.size(); ++e) {
        if (reading.problem->effects[e].effect->id == "sliding_friction") {
            sliding = report.joules[e];
        }
    }
    // 0.6 * 1000 N * 27.78 m/s * tan(2 deg) = 582.0 W, whatever the angle, for 0.16 s.
    EXPECT_NEAR(sliding, 582.0 * 0.16, 0.05);
}

}  // namespace tiretherm::input
