// SPDX-License-Identifier: BSD-3-Clause
// Wheel angle from speed and load: the times at which the contact meets and leaves a column, by closed forms.

#include "solver/wheel_angle.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "mesh/ring.hpp"
#include "physics/contact/travelling.hpp"
#include "tests/support/tire_section.hpp"

namespace tiretherm::solver {

namespace {

using std::numbers::pi;

Problem rolling_column() {
    Problem problem = support::tire_problem(1);
    problem.settings.end = 10.0;
    return problem;
}

}  // namespace

// 27.78 m/s on R_R(4 kN): the contact of length phi reaches a column at (2 k + 1) pi - phi/2 and leaves it at + phi/2.
TEST(WheelAngle, StopsWhereTheContactMeetsAndLeavesAColumn) {
    const Problem problem = rolling_column();
    const double rate = 100.0 / 3.6 / problem.tire.rolling_radius(4000.0);
    const double phi = problem.tire.contact_length(4000.0) / problem.tire.rolling_radius(4000.0);
    const Series angle = wheel_angle(problem, 100000).value();
    // Start, two points at each of the edges, end: 10 s are 136.7 turns, so 137 contacts begin and end.
    const double turns = 10.0 * rate / (2.0 * pi);
    ASSERT_NEAR(turns, 136.8, 0.1);
    ASSERT_EQ(angle.time.size(), 2U + 4U * 137U);
    for (int k = 0; k < 137; ++k) {
        const auto at = static_cast<std::size_t>(1 + 4 * k);
        EXPECT_NEAR(angle.time[at], ((2 * k + 1) * pi - 0.5 * phi) / rate, 1e-10);
        EXPECT_EQ(angle.time[at], angle.time[at + 1]);
        EXPECT_NEAR(angle.time[at + 2], ((2 * k + 1) * pi + 0.5 * phi) / rate, 1e-10);
        EXPECT_LT(angle.value[at], angle.value[at + 1]);
    }
    EXPECT_NEAR(angle.value.back(), rate * 10.0, 1e-6);
    // A step sees the column outside before the first edge and inside after it.
    InputSignals input_signals = problem.input_signals;
    input_signals.add(angle);
    const double edge = angle.time[1];
    const auto inside = [&](JumpSide side) {
        return physics::TravellingContact(problem.tire, input_signals.at(edge, side)).part(0, 1).inside;
    };
    EXPECT_FALSE(inside(JumpSide::before));
    EXPECT_TRUE(inside(JumpSide::after));
}

// From rest at 2 m/s2 for 10 s, R_R and phi constant: angle = t^2 / R_R, so the first contact begins at
// sqrt((pi - phi/2) R_R); then 20 m/s. The load then changes, and with it the length of the contact.
TEST(WheelAngle, FollowsSpeedAndLoad) {
    Problem problem = rolling_column();
    support::schedule(problem, "speed", {0.0, 10.0, 10.0, 20.0}, {0.0, 20.0, 20.0, 20.0});
    support::schedule(problem, "vertical_load", {0.0, 15.0, 15.0, 20.0}, {4000.0, 4000.0, 6000.0, 6000.0});
    problem.settings.end = 20.0;
    const double radius = problem.tire.rolling_radius(4000.0);
    const double phi = problem.tire.contact_length(4000.0) / radius;
    const Series angle = wheel_angle(problem, 100000).value();
    EXPECT_NEAR(angle.time[1], std::sqrt((pi - 0.5 * phi) * radius), 1e-7);
    EXPECT_NEAR(angle.at(10.0, JumpSide::before), 100.0 / radius, 1e-9);
    EXPECT_NEAR(angle.at(15.0, JumpSide::before), 200.0 / radius, 1e-9);
    EXPECT_NEAR(angle.value.back(), 200.0 / radius + 100.0 / problem.tire.rolling_radius(6000.0), 1e-7);
    // The last whole contact lasts as long as the longer contact takes.
    const std::size_t n = angle.time.size();
    const double first = angle.time[n - 3] - angle.time[n - 5];
    const double second = angle.time[n - 5] - angle.time[n - 7];
    EXPECT_NEAR(std::min(first, second), problem.tire.contact_length(6000.0) / 20.0, 1e-9);
}

TEST(WheelAngle, OfARingHasAPointWhereverAnEdgePassesASector) {
    Problem problem = rolling_column();
    problem.effects.clear();
    problem.mesh = mesh::ring(mesh::build(support::tire_section(problem.tire, 1)), 20);
    problem.settings.end = 1.0;
    const double turns = 100.0 / 3.6 / problem.tire.rolling_radius(4000.0) / (2.0 * pi);
    const Series angle = wheel_angle(problem, 100000).value();
    EXPECT_NEAR(static_cast<double>(angle.time.size()), 2.0 * 20.0 * turns, 3.0);
    for (std::size_t i = 1; i < angle.time.size(); ++i) {
        EXPECT_LT(angle.time[i - 1], angle.time[i]);
    }
    EXPECT_FALSE(wheel_angle(problem, 300).has_value()) << "more than the caller wants";
}

// An encoder's angle counts, not the speed.
TEST(WheelAngle, IsTheDrivesWhereItGivesOne) {
    Problem problem = rolling_column();
    support::log(problem, "wheel_angle", {0.0, 5.0, 10.0}, {0.0, 20.0 * pi, 20.0 * pi});
    const Series angle = wheel_angle(problem, 100000).value();
    EXPECT_EQ(angle.time.size(), 2U + 4U * 10U + 1U) << "ten contacts, then the wheel stands";
    EXPECT_NEAR(angle.value.back(), 20.0 * pi, 1e-12);
}

}  // namespace tiretherm::solver
