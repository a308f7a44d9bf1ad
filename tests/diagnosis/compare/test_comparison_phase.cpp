// SPDX-License-Identifier: BSD-3-Clause
// Driving phases from constructed speed and slip histories whose phase at each time is known.

#include <numbers>

#include <gtest/gtest.h>

#include "diagnosis/compare/phase.hpp"

namespace tiretherm::diagnosis {
namespace {

using physics::find_signal;

/// 100 s at 20 m/s, to rest at 0.2 m/s2 by 200 s (0.02 g), at rest until 300 s.
solver::Problem coasting() {
    solver::Problem problem;
    problem.settings.start = 0.0;
    problem.settings.end = 300.0;
    problem.input_signals.add({.signal = find_signal("speed"), .time = {0, 100, 200, 300}, .value = {20, 20, 0, 0}});
    return problem;
}

TEST(Phase, FollowsTheSpeed) {
    // The fall counts over two seconds to either side: at 99 s it is 0.05 m/s2, at 101 s 0.15; 0.0981 is the bound.
    const solver::Problem problem = coasting();
    EXPECT_EQ(phase_at(problem, 0.0), Phase::free_rolling);
    EXPECT_EQ(phase_at(problem, 99.0), Phase::free_rolling);
    EXPECT_EQ(phase_at(problem, 101.0), Phase::slowing);
    EXPECT_EQ(phase_at(problem, 199.0), Phase::slowing);
    EXPECT_EQ(phase_at(problem, 199.6), Phase::standing);  // 0.08 m/s
    EXPECT_EQ(phase_at(problem, 300.0), Phase::standing);
}

TEST(Phase, ADriftOfTheSpeedIsNotSlowing) {
    // 5 m/s in 100 s are 0.05 m/s2, less than 0.01 g; rising is not falling.
    solver::Problem problem;
    problem.settings.end = 200.0;
    problem.input_signals.add({.signal = find_signal("speed"), .time = {0, 100, 120}, .value = {20, 15, 30}});
    EXPECT_EQ(phase_at(problem, 50.0), Phase::free_rolling);
    EXPECT_EQ(phase_at(problem, 110.0), Phase::free_rolling);
}

TEST(Phase, SlipComesBeforeSlowing) {
    for (const double degrees : {-0.31, 0.29, 0.31}) {
        solver::Problem problem = coasting();
        problem.input_signals.add(*find_signal("slip_angle"), degrees * std::numbers::pi / 180.0);
        EXPECT_EQ(phase_at(problem, 150.0), degrees == 0.29 ? Phase::slowing : Phase::slipping) << degrees;
        EXPECT_EQ(phase_at(problem, 250.0), Phase::standing);
    }
    solver::Problem problem = coasting();
    problem.input_signals.add(*find_signal("slip_ratio"), -0.006);
    EXPECT_EQ(phase_at(problem, 50.0), Phase::slipping);
}

TEST(Phase, EachHasANameAndAMeaning) {
    for (const Phase phase : phases) {
        EXPECT_FALSE(name_of(phase).empty());
        EXPECT_FALSE(meaning_of(phase).empty());
    }
}

}  // namespace
}  // namespace tiretherm::diagnosis
