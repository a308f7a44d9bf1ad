// SPDX-License-Identifier: BSD-3-Clause
// What is said of inputs and laws outside their ranges, of inputs that heat nothing, and of a road's share counted twice.
#include <cmath>

#include <gtest/gtest.h>

#include "support/written.hpp"

namespace tiretherm::input {

namespace {

Reading read_tire(const std::string& tables, const std::string& base = "tire") {
    const Written written;
    return read_case(written.add(
        "case.toml",
        "include = [\"" + (source_folder() / "tests/bad_cases/good" / (base + ".toml")).string() + "\"]\n" + tables));
}

/// The only warning, or what there is in its place.
std::string warning(const std::string& tables, const std::string& base = "tire") {
    const Reading reading = read_tire(tables, base);
    EXPECT_TRUE(reading.problem.has_value()) << render(reading);
    EXPECT_EQ(reading.warnings.size(), 1U) << render(reading);
    return reading.warnings.empty() ? "" : reading.warnings.front();
}

void expect_in(const std::string& text, const std::string& piece) {
    EXPECT_NE(text.find(piece), std::string::npos) << "lacks: " << piece << "\nin: " << text;
}

}  // namespace

TEST(TireRanges, LawsFollowThePressureOnlyWhereItIsGiven) {
    EXPECT_EQ(read_tire("").problem->tire.reference_pressure, 0.0);
    EXPECT_EQ(read_tire("[drive]\ninflation_pressure = \"230 kPa\"\n").problem->tire.reference_pressure, 220e3);
    const std::string own = "[tire]\nreference_pressure = \"2.5 bar\"\npressure_exponent_of_loss = 0.4\n";
    EXPECT_EQ(read_tire(own).problem->tire.reference_pressure, 0.0);
    const Reading both = read_tire(own + "[drive]\ninflation_pressure = \"230 kPa\"\n");
    EXPECT_EQ(both.problem->tire.reference_pressure, 250e3);
    EXPECT_EQ(both.problem->tire.pressure_exponent_of_loss, 0.4);
}

// 0.5 and 1.7 times 220 kPa are 110 and 374 kPa.
TEST(TireRanges, PressuresFarFromTheReferenceAreTold) {
    for (const char* pressure : {"112 kPa", "370 kPa"}) {
        const Reading reading = read_tire(std::string("[drive]\ninflation_pressure = \"") + pressure + "\"\n");
        EXPECT_TRUE(reading.warnings.empty()) << render(reading);
    }
    expect_in(
        warning("[drive]\ninflation_pressure = \"100 kPa\"\n"),
        "the inflation pressure is 100 kPa, and the tire's laws hold at 220 kPa: how they follow the pressure is known "
        "from 110 to 374 kPa");
    expect_in(warning("[drive]\ninflation_pressure = \"400 kPa\"\n"), "the inflation pressure is 400 kPa");
}

// 25 kN deflect by 4.2e-6 25000 = 105 mm, 93 % of 112.5 mm; 10.7 kN by 44.9 mm, 39.9 %.
TEST(TireRanges, LoadsThatFoldTheTireAreTold) {
    EXPECT_TRUE(read_tire("[drive]\nvertical_load = \"10.7 kN\"\n").warnings.empty());
    expect_in(warning("[drive]\nvertical_load = \"25 kN\"\n"),
              "2.5e+04 N at 0 s deflect the tire by 105.0 mm, 93 % of its section's height: the laws of the load know "
              "no more "
              "than 40 %");
    const std::string step =
        "unset = [\"drive.vertical_load\"]\n[[drive.schedule]]\ncolumns = [\"time [s]\", \"vertical_load "
        "[kN]\"]\nrows = [[0, 4], [30, 4], [30, 12], [60, 12]]\n";
    const Written written;
    const Reading reading = read_case(written.add(
        "case.toml", "include = [\"" + (source_folder() / "tests/bad_cases/good/tire.toml").string() + "\"]\n" + step));
    ASSERT_EQ(reading.warnings.size(), 1U) << render(reading);
    expect_in(reading.warnings.front(), "at 30 s deflect the tire by 50.4 mm, 45 %");
}

TEST(TireRanges, InputsThatOnlySensorsReadAreTold) {
    expect_in(warning("[drive]\ncamber = \"1 deg\"\n"), "no active effect and no sensor uses camber");
    const std::string sensor = "[[sensor]]\nname = \"pressure\"\nkind = \"gas_pressure\"\n";
    const std::string inner =
        "[effects.inner_gas]\n[effects.strain_energy_loss]\non = false\n[effects.air_convection]\non = "
        "false\n[effects.road_contact]\non = false\n";
    const Reading said = read_tire(inner + "[drive]\ninflation_pressure = \"230 kPa\"\n" + sensor);
    ASSERT_EQ(said.warnings.size(), 2U) << render(said);
    expect_in(render(said), "no heat effect depends on inflation_pressure; only pressure uses it");
    expect_in(render(said), "no active effect and no sensor uses road_temperature");
}

TEST(TireRanges, LawIsReadWithItsRange) {
    const Reading reading = read_tire(
        "[[material]]\nname = \"rubber\"\nconductivity = { at = \"20 degC\", value = \"0.29 W/mK\", slope = \"0.0094 "
        "W/mK/K\", "
        "range = [\"20 degC\", \"120 degC\"] }\n");
    ASSERT_TRUE(reading.problem.has_value()) << render(reading);
    EXPECT_TRUE(reading.warnings.empty()) << render(reading);
    const physics::Curve& k = reading.problem->materials.front().along(mesh::Axis::through);
    EXPECT_NEAR(k.value(233.15), 0.29, 1e-12);
    EXPECT_NEAR(k.value(473.15), 1.23, 1e-12);
    expect_in(
        warning("[[material]]\nname = \"rubber\"\nconductivity = { at = \"20 degC\", value = \"0.29 W/mK\", slope = "
                "\"0.0094 W/mK/K\" }\n"),
        "the conductivity of rubber is -0.274 W/mK at -40 degC, and a tire may be run between -40 and 200 degC");
}

TEST(TireRanges, ShareOfTheRoadThatCountsTwiceIsTold) {
    const std::string slides =
        "[effects.road_contact]\non = false\n[effects.resolved_contact]\n[drive]\nslip_angle = \"2 "
        "deg\"\nlateral_force = "
        "\"1 kN\"\n[effects.sliding_friction]\n";
    expect_in(warning(slides),
              "partition = 0.6 gives the road 0.4 of the heat of sliding, and resolved_contact lets the road");
    EXPECT_TRUE(read_tire(slides + "partition = \"charm\"\n").warnings.empty());
    EXPECT_TRUE(read_tire(slides + "partition = 1.0\n").warnings.empty()) << "heat that is made in the tread";
}

// Either of the two gives the slip along the heading; what is left to be said is that there is no property file.
TEST(TireRanges, SensorOfTheMagicFormulaTakesASlipSpeedToo) {
    const std::string sensor = "[[sensor]]\nname = \"Fx\"\nkind = \"longitudinal_force\"\n";
    expect_in(render(read_tire(sensor)), "longitudinal_force follows slip_ratio, which [drive] lacks");
    for (const char* slip : {"slip_ratio = 0.05\n", "slip_speed = \"1 m/s\"\n"}) {
        const Reading reading = read_tire(std::string("[drive]\n") + slip + sensor);
        ASSERT_EQ(reading.errors.size(), 1U) << render(reading);
        expect_in(render(reading), "the tire has no property file");
    }
}

}  // namespace tiretherm::input
