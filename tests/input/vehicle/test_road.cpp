// SPDX-License-Identifier: BSD-3-Clause
// Roads that are not level: bank, slope and an accelerometer along the car's vertical axis load the tires.

#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "input/vehicle/known_car.hpp"

namespace tiretherm::input::known_car {

namespace {

constexpr double degrees = 180.0 / std::numbers::pi;

/// Up to 20 degrees, into each turn of the known car, whose accelerometer reads a_y.
double bank_of(double t) { return 0.35 * std::sin(0.3 * t); }

/// The turn takes what the tires and the bank give: V r = a_y + g sin(bank).
double yaw_rate(const Truth& truth, double t) { return (truth.ay + g * std::sin(bank_of(t))) / truth.V; }

/// A horizontal: a_y = A cos(bank) - g sin(bank), a_z = g cos(bank) + A sin(bank).
double pressing(const Truth& truth, double t) {
    const double A = (truth.ay + g * std::sin(bank_of(t))) / std::cos(bank_of(t));
    return g * std::cos(bank_of(t)) + A * std::sin(bank_of(t));
}

/// Of the front left wheel, 1200 kg a_z in the place of m g.
double load_of(const Truth& truth, double a_z) {
    return 0.5 * 1200.0 * (a_z * 1.1 - truth.ax * 0.5) / 2.5 - 0.6 * 1200.0 * truth.ay * 0.5 / 1.5;
}

/// @param column heading and value of one more
std::string banked_log(const std::string& heading, const std::function<double(const Truth&, double)>& value,
                       bool has_lateral = true) {
    const std::string lateral = has_lateral ? "AccY [g]," : "";
    return log_of_the_truth("V [km/h]," + lateral + "AccX [m/s2],yaw_rate [deg/s]," + heading,
                            [&](const Truth& truth, double t) {
                                const std::string ay = has_lateral ? fmt::format("{:.9f},", truth.ay / g) : "";
                                return fmt::format("{:.9f},{}{:.9f},{:.9f},{:.9f}", 3.6 * truth.V, ay, truth.ax,
                                                   yaw_rate(truth, t) * degrees, value(truth, t));
                            });
}

/// Smoothing over 0.2 s takes (0.3 0.2)^2/24 of the turns, 1.5e-4 of some kN, and as much again of the bank.
void expect_loads(const Reading& reading) {
    ASSERT_TRUE(reading.problem) << render(reading);
    for (const double t : {5.0, 12.0, 20.0, 41.0}) {
        const Truth truth(t);
        const double load = reading.problem->input_signals.at(t, solver::JumpSide::after).vertical_load;
        EXPECT_NEAR(load, load_of(truth, pressing(truth, t)), 6.0) << t;
        EXPECT_GT(std::abs(load - truth.load(true, true)), 40.0) << "not that of a level road, " << t;
    }
}

}  // namespace

TEST(Road, ABankThatTheLogHasLoadsTheTires) {
    const auto bank = [](const Truth&, double t) { return bank_of(t) * degrees; };
    const Reading reading = read(banked_log("bank [deg]", bank), "");
    expect_loads(reading);
    EXPECT_TRUE(warns(
        reading, "bank is taken as helping in left turns where it is positive: its correlation with the turns is"));
    EXPECT_TRUE(warns(reading, "the loads follow bank and slope: the wheels carry 1.00 to "));
    const auto other_way = [](const Truth&, double t) { return -bank_of(t) * degrees; };
    expect_loads(read(banked_log("bank [deg]", other_way), ""));
    // Without an accelerometer the tires get what the bank leaves of the turn.
    const std::string no_lateral = "columns = { V = \"speed\", AccX = \"longitudinal_acceleration\" }\n";
    expect_loads(read(banked_log("bank [deg]", bank, false), "", no_lateral));
}

// With gravity, without it, and pointing down: the column itself shows which.
TEST(Road, AnAccelerometerUprightTellsTheLoadsWhateverItReadsAtRest) {
    const auto with = [](const Truth& truth, double t) { return pressing(truth, t) / g; };
    const auto without = [](const Truth& truth, double t) { return pressing(truth, t) / g - 1.0; };
    const auto down = [](const Truth& truth, double t) { return -pressing(truth, t) / g; };
    const Reading upright = read(banked_log("vertical_acceleration [g]", with), "");
    expect_loads(upright);
    EXPECT_TRUE(warns(upright, "vertical_acceleration contains gravity: it is 1.0"));
    const Reading bare = read(banked_log("vertical_acceleration [g]", without), "");
    expect_loads(bare);
    EXPECT_TRUE(warns(bare, "vertical_acceleration does not contain gravity: it is 0.0"));
    EXPECT_TRUE(warns(bare, "gravity is added, and up is taken as positive (ISO 8855)"));
    const Reading turned = read(banked_log("vertical_acceleration [g]", down), "");
    expect_loads(turned);
    EXPECT_TRUE(warns(turned, "points down and is turned round"));
}

TEST(Road, AnAccelerometerOfWhichNobodyKnowsIsAnError) {
    const auto half = [](const Truth& truth, double t) { return pressing(truth, t) / g - 0.5; };
    const Reading unclear = read(banked_log("vertical_acceleration [g]", half), "");
    EXPECT_NE(render(unclear).find("g where the car goes straight, neither near 0 nor near 1 g"), std::string::npos)
        << render(unclear);
    EXPECT_TRUE(
        read(banked_log("vertical_acceleration [g]", half), "vertical_acceleration_has_gravity = true").problem);
    const auto with = [](const Truth& truth, double t) { return pressing(truth, t) / g; };
    const Reading stated =
        read(banked_log("vertical_acceleration [g]", with), "vertical_acceleration_has_gravity = false");
    EXPECT_NE(render(stated).find("and vertical_acceleration_has_gravity says otherwise"), std::string::npos)
        << render(stated);
}

// 0.1 rad uphill all the time: the wheels carry g cos(0.1), and the tires push dV/dt + g sin(0.1), where an accelerometer along the
// car reads both by itself. Front axle: 1200 (9.7577 1.1 - 1.579 0.5)/2.5 N at t = 0, where dV/dt is 0.6 and a_y = 0.
TEST(Road, ASlopeLoadsTheRearAndIsDrivenUp) {
    const std::string log = log_of_the_truth("V [km/h],AccY [g],yaw_rate [deg/s]", [](const Truth& truth, double) {
        return fmt::format("{:.9f},{:.9f},{:.9f}", 3.6 * truth.V, truth.ay / g, truth.r * degrees);
    });
    const std::string no_acceleration = "columns = { V = \"speed\", AccY = \"lateral_acceleration\" }\n";
    const Reading reading = read(log, "slope = \"0.1 rad\"", no_acceleration);
    ASSERT_TRUE(reading.problem) << render(reading);
    for (const double t : {5.0, 20.0, 41.0}) {
        const Truth truth(t);
        const double along = truth.ax + g * std::sin(0.1);
        const double load =
            0.5 * 1200.0 * (g * std::cos(0.1) * 1.1 - along * 0.5) / 2.5 - 0.6 * 1200.0 * truth.ay * 0.5 / 1.5;
        const physics::Inputs in = reading.problem->input_signals.at(t, solver::JumpSide::after);
        EXPECT_NEAR(in.vertical_load, load, 6.0) << t;
    }
}

}  // namespace tiretherm::input::known_car
