// SPDX-License-Identifier: BSD-3-Clause
// Steps of a schedule of inputs, and the surface threshold between steady states, against hand calculation.

#include "solver/hot_spot/schedule_steps.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "solver/hot_spot/hot_spot_steady.hpp"

namespace tiretherm::solver {

namespace {

Series series(const char* name, std::vector<double> time, std::vector<double> value, bool logged = false) {
    return {.signal = physics::find_signal(name), .time = std::move(time), .value = std::move(value), .logged = logged};
}

}  // namespace

// Ten minutes up to 40 m/s, then 40 and 45 m/s for ten minutes each.
TEST(ScheduleSteps, AreRampsAndStretchesThatStandStill) {
    InputSignals input_signals;
    input_signals.add(series("speed", {0, 600, 600, 1200, 1200, 1800}, {0, 40, 40, 40, 45, 45}));
    input_signals.add(*physics::find_signal("vertical_load"), 5000.0);
    const std::vector<ScheduleStep> steps = schedule_steps(input_signals, 0.0, 1800.0);
    ASSERT_EQ(steps.size(), 3U);
    EXPECT_TRUE(steps[0].ramp);
    EXPECT_EQ(steps[0].number, 1);
    EXPECT_DOUBLE_EQ(steps[0].speed, 40.0);
    EXPECT_FALSE(steps[1].ramp);
    EXPECT_EQ(steps[1].number, 1);
    EXPECT_EQ(steps[2].number, 2);
    EXPECT_DOUBLE_EQ(steps[2].from, 1200.0);
    EXPECT_DOUBLE_EQ(steps[2].duration(), 600.0);
    EXPECT_DOUBLE_EQ(steps[2].speed, 45.0);
    EXPECT_DOUBLE_EQ(steps[2].load, 5000.0);
    EXPECT_EQ(step_at(steps, 300.0)->number, 1);
    EXPECT_TRUE(step_at(steps, 300.0)->ramp);
    // At a border the step that has just been.
    EXPECT_EQ(step_at(steps, 1200.0), &steps[1]);
    EXPECT_EQ(step_at(steps, 1800.1), nullptr);
}

TEST(ScheduleSteps, StopOfAnotherInputEndsNone) {
    InputSignals input_signals;
    input_signals.add(series("speed", {0, 1000}, {30, 30}));
    input_signals.add(series("air_temperature", {0, 500, 1000}, {290, 300, 290}));
    EXPECT_EQ(schedule_steps(input_signals, 0.0, 1000.0).size(), 1U);
}

TEST(ScheduleSteps, ChangeOfLoadIsAStep) {
    InputSignals input_signals;
    input_signals.add(*physics::find_signal("speed"), 30.0);
    input_signals.add(series("vertical_load", {0, 500, 500, 1000}, {4000, 4000, 5000, 5000}));
    const std::vector<ScheduleStep> steps = schedule_steps(input_signals, 0.0, 1000.0);
    ASSERT_EQ(steps.size(), 2U);
    EXPECT_DOUBLE_EQ(steps[1].load, 5000.0);
}

TEST(ScheduleSteps, LogHasNone) {
    InputSignals input_signals;
    input_signals.add(series("speed", {0, 10, 20}, {30, 31, 30}, true));
    EXPECT_TRUE(schedule_steps(input_signals, 0.0, 20.0).empty());
}

// Steady pairs (hot spot, surface): (360, 320), a ramp, (380, 324), (400, 330). Critical 385 K lies a quarter on the way
// from the second to the third: 324 + 6/4 = 325.5 K. At 410 K or 350 K nothing lies on both sides.
TEST(SurfaceThreshold, IsThatOfTheSteadyStatesOnEitherSide) {
    const std::vector<SpotAndSurface> steady{{360.0, 320.0}, {}, {380.0, 324.0}, {400.0, 330.0}};
    EXPECT_NEAR(surface_threshold(steady, 385.0), 325.5, 1e-12);
    EXPECT_NEAR(surface_threshold(steady, 370.0), 322.0, 1e-12);
    EXPECT_TRUE(std::isnan(surface_threshold(steady, 410.0)));
    EXPECT_TRUE(std::isnan(surface_threshold(steady, 350.0)));
}

}  // namespace tiretherm::solver
