// SPDX-License-Identifier: BSD-3-Clause
// Quantities with units: accepted and refused texts, bounds in the user's unit, hints, and unusual values.

#include <cmath>
#include <cstdlib>
#include <random>

#include <gtest/gtest.h>

#include "input/text/quantity_specs.hpp"

namespace tiretherm::input {

namespace {

constexpr QuantitySpec speed{.unit = "m s-1", .low = -150.0, .high = 150.0};
constexpr QuantitySpec share{.unit = "1", .low = 0.0, .high = 1.0};

double value(std::string_view text, const QuantitySpec& spec) {
    const ParsedQuantity parsed = parse_quantity(text, spec, "x");
    EXPECT_FALSE(parsed.error) << parsed.error->what;
    return parsed.value;
}

ErrorText error(std::string_view text, const QuantitySpec& spec) {
    return parse_quantity(text, spec, "x").error.value_or(ErrorText{"none", ""});
}

}  // namespace

TEST(Quantity, AcceptsWhatPeopleWrite) {
    EXPECT_DOUBLE_EQ(value("90 km/h", speed), 25.0);
    EXPECT_DOUBLE_EQ(value("90km/h", speed), 25.0);
    EXPECT_DOUBLE_EQ(value("  +9e1  km/h ", speed), 25.0);
    EXPECT_DOUBLE_EQ(value("-.25e2 m/s", speed), -25.0);
    EXPECT_DOUBLE_EQ(value("0.6", share), 0.6);
    EXPECT_DOUBLE_EQ(value("60 %", share), 0.6);
    EXPECT_DOUBLE_EQ(value("0.6 -", share), 0.6);
}

// Of a decimal number the nearest double is read, as strtod finds it; up to 15 digits without an exponent, and beyond.
TEST(Quantity, NumbersOfLogsAreReadToTheLastDigit) {
    std::mt19937_64 random(4);
    for (int i = 0; i < 20000; ++i) {
        std::string digits = std::to_string(random());
        digits.resize(1 + random() % digits.size());
        digits.insert(random() % (digits.size() + 1), ".");
        const std::string text = (i % 2 == 0 ? "-" : "") + digits + " km/h";
        const std::optional<Number> number = leading_number(text);
        ASSERT_TRUE(number.has_value()) << text;
        EXPECT_EQ(number->value, std::strtod(text.c_str(), nullptr)) << text;
        EXPECT_EQ(number->rest, "km/h") << text;
    }
    EXPECT_TRUE(std::signbit(leading_number("-0.0")->value));
    EXPECT_EQ(leading_number("1.5e2")->value, 150.0);
    EXPECT_EQ(leading_number("1.2.3")->rest, ".3");
    EXPECT_FALSE(leading_number("-").has_value());
    EXPECT_FALSE(leading_number(".").has_value());
}

// The smallest double is 5e-324: what is nearer to zero is zero. What is larger than 1.8e308 is refused, however written.
TEST(Quantity, KnowsTheTinyFromTheHuge) {
    const std::string zeros(400, '0');
    for (const std::string& tiny : {std::string("1e-400"), std::string("-1e-400"), "0." + zeros + "1",
                                    "1" + zeros + "e-900", std::string("1e-99999999999"), std::string("0.001E-330")}) {
        EXPECT_EQ(value(tiny + " m/s", speed), 0.0) << tiny;
    }
    for (const std::string& huge :
         {std::string("1e400"), "1" + zeros, "0." + zeros + "1e900", std::string("1e99999999999")}) {
        EXPECT_EQ(error(huge + " m/s", speed).what,
                  "x is \"" + huge + " m/s\", larger than any number that is computed with (1.8e308)");
    }
    EXPECT_EQ(error("nan m/s", speed).what, R"(x is "nan m/s", not a finite number)");
}

TEST(Quantity, RefusesWhatIsNone) {
    EXPECT_EQ(error("", speed).what, R"(x is "", which does not start with a number)");
    EXPECT_EQ(error("fast", speed).what, R"(x is "fast", which does not start with a number)");
    EXPECT_EQ(error("+-3 km/h", speed).what, R"(x is "+-3 km/h", which does not start with a number)");
    EXPECT_EQ(error("90", speed).what, R"(x is "90", without a unit)");
    EXPECT_EQ(error("90", speed).remedy, R"(write a speed, such as "100 km/h")");
    EXPECT_EQ(error("100 km", speed).what, R"(x is "100 km", a length; a speed is wanted)");
    EXPECT_EQ(error("1 000 km/h", speed).what, R"(x is "1 000 km/h", with a number inside the unit "000 km/h")");
    EXPECT_EQ(error("nan km/h", speed).what, R"(x is "nan km/h", not a finite number)");
    EXPECT_EQ(error("1e999 km/h", speed).what,
              R"(x is "1e999 km/h", larger than any number that is computed with (1.8e308))");
}

TEST(Quantity, CommasInNumbersGetAHint) {
    EXPECT_EQ(error("8,5 km/h", speed).remedy, R"(write "8.5 km/h")");
    EXPECT_EQ(error("4,000 km/h", speed).remedy, R"(write "4000 km/h" or "4.000 km/h")");
}

// Bounds are spelt in the unit that the user chose: 150 m/s are 540 km/h.
TEST(Quantity, BoundsAreSpeltInTheUnitAsWritten) {
    EXPECT_EQ(error("600 km/h", speed).what, R"(x is "600 km/h"; it must be between -540 km/h and 540 km/h)");
    EXPECT_EQ(error("1.5", share).what, R"(x is "1.5"; it must be between 0 and 1)");
    EXPECT_EQ(error("0 mm", quantity_specs::thickness).what,
              R"(x is "0 mm"; it must be above 0 mm and at most 1000 mm)");
    EXPECT_EQ(error("-300 degC", quantity_specs::temperature).what, R"(x is "-300 degC", below absolute zero)");
}

TEST(Quantity, KelvinForgottenForCelsiusIsGuessed) {
    const QuantitySpec air{.unit = "K", .low = 200.0, .high = 400.0};
    EXPECT_EQ(error("23 K", air).remedy, R"(did you mean "23 degC"?)");
    EXPECT_EQ(error("900 K", air).remedy, "");
}

TEST(Quantity, UnusualIsRemarkedButAccepted) {
    const ParsedQuantity parsed = parse_quantity("50 kg/m3", quantity_specs::density, "density");
    EXPECT_FALSE(parsed.error);
    EXPECT_DOUBLE_EQ(parsed.value, 50.0);
    EXPECT_EQ(parsed.remark,
              R"(density is "50 kg/m3", which is unusual: it is mostly between 100 kg/m3 and 10000 kg/m3)");
    EXPECT_EQ(parse_quantity("1100 kg/m3", quantity_specs::density, "density").remark, "");
}

// Every input and every parameter of the catalogue must have a unit that messages can name and give an example of.
TEST(Quantity, EveryInputAndParameterHasAnExampleThatIsAccepted) {
    const auto check = [](const QuantitySpec& spec, std::string_view name) {
        const Dimension what = dimension(spec.unit, spec.scale);
        ASSERT_FALSE(what.example.empty()) << name << " in " << spec.unit;
        QuantitySpec unbounded = spec;
        unbounded.low = -1e300;
        unbounded.high = 1e300;
        EXPECT_FALSE(parse_quantity(what.example, unbounded, name).error) << name;
    };
    for (const physics::Signal& signal : physics::signals()) {
        check(quantity_specs::of(signal), signal.name);
    }
    for (const physics::Effect* effect : physics::catalogue()) {
        for (const physics::ParameterSpec& parameter : effect->parameters) {
            check(quantity_specs::of(parameter), parameter.key);
            EXPECT_GE(parameter.standard, parameter.low) << effect->id << "." << parameter.key;
            EXPECT_LE(parameter.standard, parameter.high) << effect->id << "." << parameter.key;
        }
    }
}

// A logarithmic unit has no dimension that could be named; what UDUNITS writes of it has brackets.
TEST(Quantity, KnowsNoLogarithmicUnits) {
    EXPECT_EQ(error("3 lg(re mW)", speed).what, "x is \"3 lg(re mW)\": \"lg(re mW)\" is not a unit");
}

}  // namespace tiretherm::input
