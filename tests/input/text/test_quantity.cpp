#include <gtest/gtest.h>

#include "input/text/wanted.hpp"

namespace tiretherm::input {

namespace {

constexpr Wanted speed{.unit = "m s-1", .low = -150.0, .high = 150.0};
constexpr Wanted share{.unit = "1", .low = 0.0, .high = 1.0};

double value(std::string_view text, const Wanted& wanted) {
    const Judged judged = quantity(text, wanted, "x");
    EXPECT_FALSE(judged.fault) << judged.fault->what;
    return judged.value;
}

Fault fault(std::string_view text, const Wanted& wanted) {
    return quantity(text, wanted, "x").fault.value_or(Fault{"none", ""});
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

TEST(Quantity, RefusesWhatIsNone) {
    EXPECT_EQ(fault("", speed).what, R"(x is "", which does not start with a number)");
    EXPECT_EQ(fault("fast", speed).what, R"(x is "fast", which does not start with a number)");
    EXPECT_EQ(fault("+-3 km/h", speed).what, R"(x is "+-3 km/h", which does not start with a number)");
    EXPECT_EQ(fault("90", speed).what, R"(x is "90", without a unit)");
    EXPECT_EQ(fault("90", speed).remedy, R"(write a speed, such as "100 km/h")");
    EXPECT_EQ(fault("100 km", speed).what, R"(x is "100 km", a length; a speed is wanted)");
    EXPECT_EQ(fault("1 000 km/h", speed).what, R"(x is "1 000 km/h", with a number inside the unit "000 km/h")");
    EXPECT_EQ(fault("nan km/h", speed).what, R"(x is "nan km/h", not a finite number)");
    EXPECT_EQ(fault("1e999 km/h", speed).what, R"(x is "1e999 km/h", not a finite number)");
}

TEST(Quantity, CommasInNumbersGetAHint) {
    EXPECT_EQ(fault("8,5 km/h", speed).remedy, R"(write "8.5 km/h")");
    EXPECT_EQ(fault("4,000 km/h", speed).remedy, R"(write "4000 km/h" or "4.000 km/h")");
}

// Bounds are spelt in the unit that the user chose: 150 m/s are 540 km/h.
TEST(Quantity, BoundsAreSpeltInTheUnitAsWritten) {
    EXPECT_EQ(fault("600 km/h", speed).what, R"(x is "600 km/h"; it must be between -540 km/h and 540 km/h)");
    EXPECT_EQ(fault("1.5", share).what, R"(x is "1.5"; it must be between 0 and 1)");
    EXPECT_EQ(fault("0 mm", wanted::thickness).what, R"(x is "0 mm"; it must be above 0 mm and at most 1000 mm)");
    EXPECT_EQ(fault("-300 degC", wanted::temperature).what, R"(x is "-300 degC", below absolute zero)");
}

TEST(Quantity, KelvinForgottenForCelsiusIsGuessed) {
    const Wanted air{.unit = "K", .low = 200.0, .high = 400.0};
    EXPECT_EQ(fault("23 K", air).remedy, R"(did you mean "23 degC"?)");
    EXPECT_EQ(fault("900 K", air).remedy, "");
}

TEST(Quantity, UnusualIsRemarkedButAccepted) {
    const Judged judged = quantity("50 kg/m3", wanted::density, "density");
    EXPECT_FALSE(judged.fault);
    EXPECT_DOUBLE_EQ(judged.value, 50.0);
    EXPECT_EQ(judged.remark,
              R"(density is "50 kg/m3", which is unusual: it is mostly between 100 kg/m3 and 10000 kg/m3)");
    EXPECT_EQ(quantity("1100 kg/m3", wanted::density, "density").remark, "");
}

// Every input and every parameter of the catalogue must have a unit that messages can name and give an example of.
TEST(Quantity, EveryInputAndParameterHasAnExampleThatIsAccepted) {
    const auto check = [](const Wanted& wanted, std::string_view name) {
        const Dimension what = dimension(wanted.unit, wanted.scale);
        ASSERT_FALSE(what.example.empty()) << name << " in " << wanted.unit;
        Wanted unbounded = wanted;
        unbounded.low = -1e300;
        unbounded.high = 1e300;
        EXPECT_FALSE(quantity(what.example, unbounded, name).fault) << name;
    };
    for (const physics::Signal& signal : physics::signals()) {
        check(wanted::of(signal), signal.name);
    }
    for (const physics::Effect* effect : physics::catalogue()) {
        for (const physics::Parameter& parameter : effect->parameters) {
            check(wanted::of(parameter), parameter.key);
            EXPECT_GE(parameter.standard, parameter.low) << effect->id << "." << parameter.key;
            EXPECT_LE(parameter.standard, parameter.high) << effect->id << "." << parameter.key;
        }
    }
}

}  // namespace tiretherm::input
