// SPDX-License-Identifier: BSD-3-Clause
// Cases on a tire cross-section: zones, sensors, gas and rim, forces, cornering stiffness and gas pressure against hand
// calculation.

#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "physics/tire_laws/rolling_resistance.hpp"
#include "solver/system.hpp"
#include "solver/time_integration/march.hpp"
#include "support/written.hpp"

// What a case on a cross-section becomes, and readings that are no temperatures.
namespace tiretherm::input {

namespace {

constexpr double zero_celsius = 273.15;

solver::Problem read_section(const std::string& text) {
    const Written written;
    Reading reading = read_case(written.add("case.toml", text));
    if (!reading.problem) {
        ADD_FAILURE() << render(reading);
        return {};
    }
    return *reading.problem;
}

std::string included(const std::string& more) {
    return "include = [\"" + (source_folder() / "tests/bad_cases/good/section.toml").string() + "\"]\n" + more;
}

solver::MarchReport run(const solver::Problem& problem) {
    return solver::run(problem, [](const solver::Snapshot&) { return true; });
}

std::size_t channel(const solver::Problem& problem, std::string_view name) {
    for (std::size_t c = 0; c < problem.channels.size(); ++c) {
        if (problem.channels[c].name == name) {
            return c;
        }
    }
    ADD_FAILURE() << name;
    return 0;
}

}  // namespace

// 225 mm of tread, a fifth each shoulder; the profile ends where the rim begins, R0 - H = 218.3 mm.
TEST(SectionCase, HasTheThesisTiresZones) {
    const solver::Problem problem = read_section(included(""));
    const mesh::Mesh& mesh = problem.mesh;
    EXPECT_EQ(mesh.zones, (std::vector<std::string>{"outside_sidewall", "outside_shoulder", "crown", "inside_shoulder",
                                                    "inside_sidewall"}));
    ASSERT_EQ(mesh.columns.size(), 12U);
    EXPECT_EQ(mesh.n_cells, 8 * 4 + 4 * 2);
    EXPECT_NEAR(mesh.columns[2].from, -0.1125, 1e-12);
    EXPECT_NEAR(mesh.columns[4].from, -0.0675, 1e-12);
    double lowest = 1.0;
    for (std::size_t i = 0; i < mesh.drawing.points.size(); ++i) {
        if (std::abs(mesh.drawing.places[i][2]) < 1e-12) {  // the outer surface
            lowest = std::min(lowest, mesh.drawing.points[i][2]);
        }
    }
    // Sidewalls are 4 mm thick and begin 8 mm below the profile, which at the bead has turned by 120 degrees.
    EXPECT_NEAR(lowest, 0.3308 - 0.1125 - 0.008 * std::cos(120.0 / 180.0 * std::numbers::pi), 1e-9);
}

// A probe at the middles of both shoulders reads the mean of its two places.
TEST(SectionCase, SensorsStandInZones) {
    const solver::Problem problem = read_section(included(R"(
[[sensor]]
name = "both"
kind = "point"
zones = ["outside_shoulder", "inside_shoulder"]
depth = "10 mm"
[[sensor]]
name = "along"
kind = "point"
along = "-30 mm"
depth = "0 mm"
[[sensor]]
name = "wall"
kind = "zone"
zone = "inside_sidewall"
)"));
    std::vector<double> T;
    for (std::size_t n = 0; n < problem.mesh.centre.size(); ++n) {
        T.push_back(300.0 + 100.0 * problem.mesh.centre[n][0] + 1000.0 * problem.mesh.centre[n][2]);
    }
    EXPECT_NEAR(problem.channels[channel(problem, "both")].where(T), 310.0, 1e-9);
    EXPECT_NEAR(problem.channels[channel(problem, "along")].where(T), 297.0, 1e-9);
    EXPECT_GT(problem.channels[channel(problem, "wall")].where(T), 310.0);
}

// Gas and rim start with the air, not with the rubber, unless the case says otherwise.
TEST(SectionCase, GasAndRimStartWithTheAir) {
    const std::string effects =
        "[effects.inner_gas]\n[effects.rim_conduction]\n[drive]\nair_temperature = \"10 degC\"\n";
    const solver::Problem problem = read_section(included(effects));
    const auto at = [&](std::string_view name) {
        return problem.initial[static_cast<std::size_t>(problem.mesh.find_lumped_node(name))];
    };
    EXPECT_NEAR(at("gas"), zero_celsius + 10.0, 1e-12);
    EXPECT_NEAR(at("rim"), zero_celsius + 10.0, 1e-12);
    const solver::Problem stated = read_section(included(effects + "[initial]\nrim = \"60 degC\"\n"));
    EXPECT_NEAR(stated.initial[static_cast<std::size_t>(stated.mesh.find_lumped_node("rim"))], zero_celsius + 60.0,
                1e-12);
}

// (51) F_R = SEL R_R/(V R_L); (52) with the bulk's temperature; (60) lambda_Tb = CP / K; and the lateral force that (59)
// makes of it, beside the one without temperature.
TEST(SectionCase, ReadsForcesAndStiffness) {
    const solver::Problem problem = read_section(
        included("[tire]\nproperty_file = \"" + (source_folder() / "tests/input/data/made_up.tir").string() + R"("
[tire.modulus]
lambda_CP = 0.5
tuned = true
[drive]
slip_angle = "0.01 deg"
[[sensor]]
name = "drag"
kind = "drag_force"
[[sensor]]
name = "radius"
kind = "loaded_radius"
[[sensor]]
name = "stiffness"
kind = "cornering_stiffness"
temperature_of = "bulk_temperature"
[[sensor]]
name = "factor"
kind = "bulk_temperature_factor"
[[sensor]]
name = "force"
kind = "lateral_force"
[[sensor]]
name = "reference"
kind = "reference_lateral_force"
)"));
    ASSERT_TRUE(problem.handling.magic_formula.has_value());
    const solver::MarchReport report = run(problem);
    ASSERT_TRUE(report.status.ok()) << report.status.message;
    const auto final = [&](std::string_view name) { return report.channel_final[channel(problem, name)]; };
    EXPECT_NEAR(final("radius"), 0.3308 - 4.2e-6 * 4000.0, 1e-12);
    const double loss = report.watts[1];
    EXPECT_NEAR(final("drag"),
                loss * problem.tire.rolling_radius(4000.0) / (100.0 / 3.6 * problem.tire.loaded_radius(4000.0)), 1e-9);
    const double CP = 0.5 * physics::cornering_stiffness({}, problem.tire, 4000.0, final("bulk_temperature")).value;
    EXPECT_NEAR(final("stiffness"), CP, 1e-9 * CP);
    const double K = std::abs(problem.handling.magic_formula->cornering_stiffness(4000.0, 0.0));
    EXPECT_NEAR(final("factor"), CP / K, 1e-12);
    const physics::PureSlipState state{
        .load = 4000.0, .slip = 0.01 / 180.0 * std::numbers::pi, .camber = 0.0, .speed = 100.0 / 3.6};
    EXPECT_NEAR(final("force"), problem.handling.magic_formula->lateral(state, CP / K).force, 1e-9);
    EXPECT_NEAR(final("reference"), problem.handling.magic_formula->lateral(state).force, 1e-9);
}

// Another tire's file keeps its own stiffness, -20 4000 sin(2 atan(1/2)) 1.05 = -67200 N/rad at 4 kN, and the moduli tell how it
// changes from the reference temperature on: by 1 where the bulk has it, and by CP(T)/CP(T_ref) elsewhere. The moduli alone, 30
// times the load, would make 1.8 times the file's stiffness of it.
TEST(SectionCase, AForeignPropertyFileKeepsItsStiffness) {
    const std::string file =
        "[tire]\nproperty_file = \"" + (source_folder() / "tests/input/data/made_up.tir").string() + "\"\n";
    const auto read_at = [&](const std::string& modulus) {
        const Written written;
        return read_case(written.add("case.toml", included(file + modulus + R"(
[drive]
slip_angle = "0.01 deg"
[[sensor]]
name = "stiffness"
kind = "cornering_stiffness"
[[sensor]]
name = "factor"
kind = "bulk_temperature_factor"
)")));
    };
    const Reading reading = read_at("");
    ASSERT_TRUE(reading.problem) << render(reading);
    ASSERT_EQ(reading.warnings.size(), 1U) << render(reading);
    EXPECT_NE(
        reading.warnings[0].find("made_up.tir is taken for that at a bulk of 70 degC, from where stiffness follows"),
        std::string::npos)
        << reading.warnings[0];
    const solver::Problem& problem = *reading.problem;
    const solver::MarchReport report = run(problem);
    const auto final = [&](std::string_view name) { return report.channel_final[channel(problem, name)]; };
    const auto CP = [&](double T) { return physics::cornering_stiffness({}, problem.tire, 4000.0, T).value; };
    const double factor = CP(final("bulk_temperature")) / CP(343.15);
    EXPECT_NEAR(final("factor"), factor, 1e-9);
    EXPECT_NEAR(final("stiffness"), 67200.0 * factor, 1e-4);
    const std::string there =
        fmt::format("[tire.modulus]\nreference_temperature = \"{} K\"\n", final("bulk_temperature"));
    const Reading same = read_at(there);
    ASSERT_TRUE(same.problem) << render(same);
    EXPECT_TRUE(same.warnings.empty()) << render(same);
    EXPECT_NEAR(run(*same.problem).channel_final[channel(*same.problem, "stiffness")], 67200.0, 1.0);
}

// The contact that rolls stands for the one that does not: both would count the road's heat twice.
TEST(SectionCase, WarnsOfTwoContacts) {
    const Written written;
    const std::string rolling = "[effects.resolved_contact]\n";
    const Reading both = read_case(written.add("case.toml", included(rolling)));
    ASSERT_EQ(both.warnings.size(), 1U) << render(both);
    EXPECT_NE(both.warnings[0].find("resolved_contact and road_contact both act"), std::string::npos);
    EXPECT_TRUE(read_case(written.add("case.toml", included(rolling + "[effects.road_contact]\non = false\n")))
                    .warnings.empty());
}

// Heated at constant volume from the start of the case: p = (p0 + 101.325 kPa) T/T0 - 101.325 kPa, also where the run is
// a steady state and never was cold.
TEST(SectionCase, GasPressureCountsFromTheStart) {
    const solver::Problem problem = read_section(included(R"(
[effects.inner_gas]
[drive]
inflation_pressure = "220 kPa"
[time]
steady = true
[[sensor]]
name = "gas"
kind = "node"
node = "gas"
[[sensor]]
name = "pressure"
kind = "gas_pressure"
)"));
    const solver::MarchReport report = run(problem);
    ASSERT_TRUE(report.status.ok()) << report.status.message;
    const double gas = report.channel_final[channel(problem, "gas")];
    EXPECT_GT(gas, zero_celsius + 30.0);
    EXPECT_NEAR(report.channel_final[channel(problem, "pressure")], 321325.0 * gas / (zero_celsius + 23.0) - 101325.0,
                1e-3);
}

// One offset for a sensor, another for a second.
TEST(SectionCase, ReadingsAreBoundToSensors) {
    const solver::Problem problem = read_section(included(R"(
[effects.sensor_offset]
channels = ["bulk_temperature", "wall"]
kelvin = "1 K"
kelvin_by_channel = { wall = "-2 degC" }
[[sensor]]
name = "wall"
kind = "zone"
zone = "inside_sidewall"
)"));
    solver::Problem bare = problem;
    bare.effects.pop_back();
    const solver::MarchReport a = run(problem);
    const solver::MarchReport b = run(bare);
    EXPECT_NEAR(
        a.channel_final[channel(problem, "bulk_temperature")] - b.channel_final[channel(bare, "bulk_temperature")], 1.0,
        1e-9);
    EXPECT_NEAR(a.channel_final[channel(problem, "wall")] - b.channel_final[channel(bare, "wall")], -2.0, 1e-9);
}

}  // namespace tiretherm::input
