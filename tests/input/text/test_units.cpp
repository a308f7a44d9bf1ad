// SPDX-License-Identifier: BSD-3-Clause
// Unit conversion against factors by hand: aliases, products, temperatures and differences, wrong dimensions.

#include <cmath>

#include <gtest/gtest.h>

#include "input/text/unit_text.hpp"
#include "input/text/units.hpp"

namespace tiretherm::input {

namespace {

/// SI value of a number in a unit; NaN when the conversion is refused.
double si(double number, std::string_view unit, std::string_view wanted, Scale scale = Scale::absolute) {
    const auto result = conversion(unit, wanted, scale);
    const auto* found = std::get_if<Conversion>(&result);
    return found != nullptr ? found->to_si(number) : std::nan("");
}

UnitError unit_error(std::string_view unit, std::string_view wanted, Scale scale = Scale::absolute) {
    return std::get<UnitError>(conversion(unit, wanted, scale));
}

}  // namespace

// Factors by hand; one ulp or two may be lost between UDUNITS' factor and the decimal fraction.
TEST(Units, AliasesOfWholeUnits) {
    EXPECT_NEAR(si(180.0, "deg", "radian"), 3.14159265358979, 1e-14);
    EXPECT_NEAR(si(180.0, "\u00B0", "radian"), 3.14159265358979, 1e-14);
    EXPECT_DOUBLE_EQ(si(7.0, "-", "1"), 7.0);
    EXPECT_DOUBLE_EQ(si(7.0, "", "1"), 7.0);
    EXPECT_DOUBLE_EQ(si(60.0, "%", "1"), 0.6);
    EXPECT_DOUBLE_EQ(si(90.0, "kph", "m s-1"), 25.0);
    EXPECT_DOUBLE_EQ(si(90.0, "km/h", "m s-1"), 25.0);
    EXPECT_DOUBLE_EQ(si(1.0, "mph", "m s-1"), 0.44704);  // 1609.344 m / 3600 s
    EXPECT_DOUBLE_EQ(si(1.0, "Nm", "J"), 1.0);
    EXPECT_DOUBLE_EQ(si(1.0, "kWh", "J"), 3.6e6);
}

TEST(Units, ProductsBehindASlashOfAPowerOrAnEnergy) {
    for (const std::string_view unit : {"W/mK", "W/(mK)", "W/(m K)", "W/m/K", "W m-1 K-1", "W/m.K", " W / mK "}) {
        EXPECT_DOUBLE_EQ(si(0.29, unit, "W m-1 K-1"), 0.29) << unit;
    }
    EXPECT_DOUBLE_EQ(si(2.0, "mW/mK", "W m-1 K-1"), 0.002);
    for (const std::string_view unit : {"W/m2K", "W/(m2K)", "W/m^2K", "W/m\u00B2K", "W/(m2 K)", "W m-2 K-1"}) {
        EXPECT_DOUBLE_EQ(si(10.0, unit, "W m-2 K-1"), 10.0) << unit;
    }
    EXPECT_DOUBLE_EQ(si(1.8, "kJ/kgK", "J kg-1 K-1"), 1800.0);
    EXPECT_DOUBLE_EQ(si(1.8, "J/gK", "J kg-1 K-1"), 1800.0);
    EXPECT_DOUBLE_EQ(si(0.5, "W/mK/K", "W m-1 K-2"), 0.5);
    EXPECT_DOUBLE_EQ(si(0.5, "W/mK2", "W m-1 K-2"), 0.5);
    EXPECT_DOUBLE_EQ(si(0.5, "W/mK/K2", "W m-1 K-3"), 0.5);
}

// Only behind a power or an energy: elsewhere mK is what UDUNITS takes it for.
TEST(Units, MillikelvinStaysMillikelvin) {
    EXPECT_DOUBLE_EQ(si(5.0, "mK", "K"), 0.005);
    EXPECT_DOUBLE_EQ(si(5.0, "1/mK", "K-1"), 5000.0);
    EXPECT_DOUBLE_EQ(si(5.0, "K/mK", "1"), 5000.0);
    EXPECT_EQ(spelt_out("m/mK"), "m/mK");
    EXPECT_EQ(spelt_out("W/mK"), "W/(m K)");
}

TEST(Units, TemperaturesHaveAnOffsetAndDifferencesHaveNone) {
    EXPECT_DOUBLE_EQ(si(25.0, "degC", "K"), 298.15);
    EXPECT_DOUBLE_EQ(si(25.0,
                        "\u00B0"
                        "C",
                        "K"),
                     298.15);
    EXPECT_DOUBLE_EQ(si(25.0,
                        "\xB0"
                        "C",
                        "K"),
                     298.15);  // Latin-1
    EXPECT_NEAR(si(77.0, "degF", "K"), 298.15, 1e-12);
    EXPECT_DOUBLE_EQ(si(0.5, "degC", "K", Scale::difference), 0.5);
    EXPECT_DOUBLE_EQ(si(0.9, "degF", "K", Scale::difference), 0.5);
    EXPECT_DOUBLE_EQ(si(0.5, "K", "K", Scale::difference), 0.5);
    EXPECT_DOUBLE_EQ(si(3600.0, "degC/h", "K s-1"), 1.0);  // in a product there is no offset
}

TEST(Units, ConversionsComeBack) {
    for (const auto& [unit, wanted] :
         {std::pair("degC", "K"), {"km/h", "m s-1"}, {"deg", "radian"}, {"psi", "Pa"}, {"1/kN", "N-1"}}) {
        const auto to = std::get<Conversion>(conversion(unit, wanted, Scale::absolute));
        for (const double number : {-40.0, 0.0, 0.1, 23.0, 1e6}) {
            EXPECT_NEAR(to.from_si(to.to_si(number)), number, 1e-12 * (1.0 + std::abs(number) + std::abs(to.offset)))
                << unit;
        }
    }
}

// UDUNITS would convert the first two: it inverts, and it takes a radian for a pure number.
TEST(Units, OtherDimensionsAreRefused) {
    EXPECT_EQ(unit_error("s", "Hz"), UnitError::other_dimension);
    EXPECT_EQ(unit_error("deg", "1"), UnitError::other_dimension);
    EXPECT_EQ(unit_error("1", "radian"), UnitError::other_dimension);
    EXPECT_EQ(unit_error("km", "m s-1"), UnitError::other_dimension);
    EXPECT_EQ(unit_error("C", "K"), UnitError::other_dimension);
    EXPECT_EQ(unit_error("W/m K", "W m-1 K-1"), UnitError::other_dimension);  // UDUNITS: (W/m) K
}

TEST(Units, WhatIsNoUnitIsRefused) {
    EXPECT_EQ(unit_error("parsnips", "m s-1"), UnitError::unknown);
    EXPECT_EQ(unit_error("mm mm(", "m"), UnitError::unknown);
    EXPECT_EQ(unit_error("mm 3", "m"), UnitError::number_inside);
    EXPECT_EQ(unit_error("3 mm", "m"), UnitError::number_inside);
    EXPECT_EQ(unit_error("K @ 273.15", "K"), UnitError::number_inside);
    EXPECT_EQ(unit_error("seconds since 2020-01-01", "s"), UnitError::number_inside);
    EXPECT_EQ(unit_error("10", "1"), UnitError::number_inside);
    for (const std::string_view unit : {"m2", "m^2", "m**2", "m-2", "1/kN", "1", "1/(km/h)^2", "kg m-3", "m+2"}) {
        EXPECT_FALSE(has_number(unit)) << unit;
    }
}

TEST(Units, DimensionsHaveNames) {
    EXPECT_EQ(dimension("furlong", Scale::absolute).name, "a length");
    EXPECT_EQ(dimension("degF", Scale::absolute).name, "a temperature");
    EXPECT_EQ(dimension("degF", Scale::difference).name, "a difference of temperatures");
    EXPECT_EQ(dimension("BTU/h", Scale::absolute).name, "a power");
    EXPECT_EQ(dimension("kg/m", Scale::absolute).name, "a quantity in m-1.kg");
}

}  // namespace tiretherm::input
