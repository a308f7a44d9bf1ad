// SPDX-License-Identifier: BSD-3-Clause
// Units in the spelling of loggers, and letters that mean two things.

#include <cmath>
#include <variant>

#include <gtest/gtest.h>

#include "input/loggers/logger_units.hpp"
#include "input/text/units.hpp"

namespace tiretherm::input {

namespace {

/// One of a logger's unit in SI; NaN where it is no unit of the quantity.
double in_si(std::string_view written, std::string_view wanted) {
    const auto read = conversion(meant_unit(written, wanted), wanted, Scale::absolute);
    const auto* found = std::get_if<Conversion>(&read);
    return found == nullptr ? std::nan("") : found->to_si(1.0);
}

}  // namespace

// 1 degC is 274.15 K; 1 degF is (1 + 459.67) / 1.8 K; a coulomb and a farad stay what they are elsewhere.
TEST(LoggerUnits, CAndFOfATemperatureAreDegrees) {
    EXPECT_DOUBLE_EQ(in_si("C", "K"), 274.15);
    EXPECT_NEAR(in_si("F", "K"), 460.67 / 1.8, 1e-9);
    EXPECT_DOUBLE_EQ(in_si("C", "A s"), 1.0);
    // The last two: Latin-1, and UTF-8 that was taken for Latin-1.
    for (const char* celsius : {".C", "\u00B0C", "deg C", "Celsius",
                                "\xB0"
                                "C",
                                "\u00C2\u00B0"
                                "C"}) {
        EXPECT_DOUBLE_EQ(in_si(celsius, "K"), 274.15) << celsius;
    }
}

// 9.80665 m/s2 is the standard acceleration of gravity (ISO 80000-3); a gram is 0.001 kg.
TEST(LoggerUnits, GOfAnAccelerationIsGravity) {
    EXPECT_DOUBLE_EQ(in_si("g", "m s-2"), 9.80665);
    EXPECT_DOUBLE_EQ(in_si("G", "m s-2"), 9.80665);
    EXPECT_DOUBLE_EQ(in_si("g", "kg"), 1e-3);
}

TEST(LoggerUnits, HaveTheSpellingsOfLoggers) {
    for (const char* text : {"kmh", "KPH", "km/h", "Km/h", "kph", "kmph"}) {
        EXPECT_DOUBLE_EQ(in_si(text, "m s-1"), 1.0 / 3.6) << text;
    }
    EXPECT_DOUBLE_EQ(in_si("mph", "m s-1"), 0.44704);  // 1609.344 m in 3600 s
    EXPECT_DOUBLE_EQ(in_si("MPH", "m s-1"), 0.44704);
    EXPECT_NEAR(in_si("PSI", "Pa"), 6894.757293, 1e-6);
    EXPECT_DOUBLE_EQ(in_si("bar", "Pa"), 1e5);
    EXPECT_DOUBLE_EQ(in_si("kPa", "Pa"), 1e3);
    EXPECT_DOUBLE_EQ(in_si("%", "1"), 0.01);
    EXPECT_DOUBLE_EQ(in_si("#", "1"), 1.0);
    EXPECT_DOUBLE_EQ(in_si("Nm", "N m"), 1.0);
    EXPECT_NEAR(in_si("deg/s", "rad s-1"), 0.017453292519943295, 1e-15);
    EXPECT_NEAR(in_si("rpm", "rad s-1"), 0.10471975511965977, 1e-15);
}

// Where only the name tells the quantity, it decides; where it does not, somebody is asked.
TEST(LoggerUnits, AreAskedForWhereTheNameDoesNotDecide) {
    EXPECT_EQ(meant_unit_by_name("Lateral Acc", "g").unit, "gravity");
    EXPECT_EQ(meant_unit_by_name("Brake Temp FL", "C").unit, "degC");
    EXPECT_EQ(meant_unit_by_name("throttle", "%").unit, "%");
    const MeantUnit asked = meant_unit_by_name("battery", "C");
    ASSERT_TRUE(asked.error.has_value());
    EXPECT_EQ(asked.error->what, "the column battery is in C: degC or coulomb?");
    EXPECT_EQ(asked.error->remedy, "say it in the case: units = { \"battery\" = \"degC\" } or \"coulomb\"");
    EXPECT_TRUE(meant_unit_by_name("fuel", "g").error.has_value());
}

}  // namespace tiretherm::input
