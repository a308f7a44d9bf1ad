// SPDX-License-Identifier: BSD-3-Clause
// Material laws as constant, quadratic, line, parabola and table, against values computed by hand.

#include <gtest/gtest.h>

#include "support/written.hpp"

namespace tiretherm::input {

namespace {

/// The conductivity that a slab gets from this text after `conductivity =`.
physics::Curve conductivity(std::string_view law) {
    const Written written;
    std::string text(slab);
    const std::string key = "conductivity = \"0.25 W/mK\"";
    text.replace(text.find(key), key.size(), "conductivity = " + std::string(law));
    const Reading reading = read_case(written.add("case.toml", text));
    EXPECT_TRUE(reading.problem.has_value()) << error_report(reading);
    return reading.problem ? reading.problem->materials.front().conductivity[2] : physics::Curve();
}

constexpr double zero = 273.15;

}  // namespace

TEST(Law, AConstant) {
    const physics::Curve law = conductivity(R"("250 mW/mK")");
    EXPECT_TRUE(law.is_constant());
    EXPECT_DOUBLE_EQ(law.value(300.0), 0.25);
    EXPECT_TRUE(conductivity(R"({ value = "0.25 W/mK" })").is_constant());
}

// 0.29 + 0.00943 (90 - 20) + 1e-5 (90 - 20)^2 = 0.9991; the law's own variable is kelvin, which costs some digits.
TEST(Law, AQuadraticAboutATemperature) {
    const physics::Curve law = conductivity(
        R"({ at = "20 degC", value = "0.29 W/mK", slope = "0.00943 W/mK/K", curvature = "1e-5 W/mK/K2" })");
    EXPECT_NEAR(law.value(zero + 20.0), 0.29, 1e-13);
    EXPECT_NEAR(law.value(zero + 90.0), 0.9991, 1e-13);
    EXPECT_NEAR(law.slope(zero + 20.0), 0.00943, 1e-15);
}

// A degree Celsius in a slope is a difference: no offset. 1 degF is 5/9 K.
TEST(Law, SlopesPerDegree) {
    EXPECT_NEAR(conductivity(R"({ at = "20 degC", value = "1 W/mK", slope = "0.01 W/m/K/degC" })").slope(300.0), 0.01,
                1e-15);
    EXPECT_NEAR(conductivity(R"({ at = "20 degC", value = "1 W/mK", slope = "0.01 W/m/K/degF" })").slope(300.0), 0.018,
                1e-15);
}

// Slope (0.95 - 0.29)/70 = 0.0094286 W/mK/K.
TEST(Law, ALineThroughTwoPoints) {
    const physics::Curve law = conductivity(R"({ through = [["20 degC", "0.29 W/mK"], ["90 degC", "0.95 W/mK"]] })");
    EXPECT_NEAR(law.value(zero + 20.0), 0.29, 1e-13);
    EXPECT_NEAR(law.value(zero + 90.0), 0.95, 1e-13);
    EXPECT_NEAR(law.slope(350.0), 0.66 / 70.0, 1e-15);
}

// y = 1 + 0.01 x + 0.001 x^2 at x = 0, 10, 30 K above 20 degC, given out of order.
TEST(Law, AParabolaThroughThreePoints) {
    const physics::Curve law =
        conductivity(R"({ through = [["50 degC", "2.2 W/mK"], ["20 degC", "1 W/mK"], ["30 degC", "1.2 W/mK"]] })");
    for (const double x : {-5.0, 0.0, 10.0, 30.0, 60.0}) {
        EXPECT_NEAR(law.value(zero + 20.0 + x), 1.0 + 0.01 * x + 0.001 * x * x, 1e-11) << x;
    }
}

TEST(Law, ATableIsStraightBetweenItsRowsAndHeldBeyond) {
    const physics::Curve law = conductivity(
        R"({ columns = ["temperature [degC]", "k [mW/mK]"], rows = [[20, 290], [60, 500], [90, 950.0]] })");
    EXPECT_TRUE(law.is_table());
    EXPECT_NEAR(law.value(zero + 40.0), 0.395, 1e-14);
    EXPECT_NEAR(law.value(zero + 75.0), 0.725, 1e-14);
    EXPECT_DOUBLE_EQ(law.value(zero - 20.0), 0.29);
    EXPECT_DOUBLE_EQ(law.value(zero + 200.0), 0.95);
}

TEST(Law, DirectionsFollowTheThicknessUnlessGiven) {
    const Written written;
    const Reading reading = read_case(written.add("case.toml", std::string(slab) + R"(
[[material]]
name = "cord"
density = "1800 kg/m3"
heat_capacity = "1100 J/kgK"
conductivity = "0.4 W/mK"
conductivity_circumference = "5 W/mK"
[[mesh.layer]]
name = "belt"
thickness = "2 mm"
cells = 1
material = "cord"
)"));
    ASSERT_TRUE(reading.problem.has_value()) << error_report(reading);
    const physics::Material& cord = reading.problem->materials[1];
    EXPECT_EQ(cord.name, "cord");
    EXPECT_DOUBLE_EQ(cord.along(mesh::Axis::through).value(300.0), 0.4);
    EXPECT_DOUBLE_EQ(cord.along(mesh::Axis::meridian).value(300.0), 0.4);
    EXPECT_DOUBLE_EQ(cord.along(mesh::Axis::circumference).value(300.0), 5.0);
}

// 0.29 - 60 0.00943 = -0.276 W/mK at -40 degC, where a run from 23 degC does not come, but a tire may; held from 20 degC on it is
// positive everywhere. The falling line has 0.99 - 177 0.01 = -0.78 at 200 degC.
TEST(Law, WarnsWhereATireCouldMeetANegativeConductivity) {
    const auto warnings = [](std::string_view law) {
        const Written written;
        std::string text(slab);
        text.replace(text.find("\"0.25 W/mK\""), 11, law);
        return read_case(written.add("case.toml", text)).warnings;
    };
    const auto cold = warnings(R"({ at = "20 degC", value = "0.29 W/mK", slope = "0.00943 W/mK/K" })");
    ASSERT_EQ(cold.size(), 1U);
    EXPECT_NE(cold[0].find("the conductivity of rubber is -0.276 W/mK at -40 degC"), std::string::npos) << cold[0];
    EXPECT_TRUE(
        warnings(
            R"({ at = "20 degC", value = "0.29 W/mK", slope = "0.00943 W/mK/K", range = ["20 degC", "120 degC"] })")
            .empty());
    const auto found = warnings(R"({ at = "23 degC", value = "0.99 W/mK", slope = "-0.01 W/mK/K" })");
    ASSERT_EQ(found.size(), 1U);
    EXPECT_NE(found[0].find("the conductivity of rubber is -0.78 W/mK at 200 degC"), std::string::npos) << found[0];
}

}  // namespace tiretherm::input
