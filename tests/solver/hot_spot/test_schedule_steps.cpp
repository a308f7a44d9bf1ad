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

/// A log at 1 Hz: 40 m/s for 600 s and 45 m/s for 600 s with 20 s from one to the other, after a minute up to speed. Speed scatters by
/// 0.3 m/s from sample to sample, the load by 100 N about 5000 N.
InputSignals logged_test() {
    std::vector<double> time;
    std::vector<double> speed;
    std::vector<double> load;
    for (int i = 0; i <= 1280; ++i) {
        const double scatter = i % 2 == 0 ? 1.0 : -1.0;
        time.push_back(i);
        speed.push_back((i < 60     ? 40.0 * i / 60.0
                         : i <= 660 ? 40.0
                         : i < 680  ? 40.0 + 5.0 * (i - 660) / 20.0
                                    : 45.0) +
                        0.3 * scatter);
        load.push_back(5000.0 + 100.0 * scatter);
    }
    InputSignals input_signals;
    input_signals.add(series("speed", time, speed, true));
    input_signals.add(series("vertical_load", time, load, true));
    return input_signals;
}

// The scatter that is allowed is 1.5 % of 45.3 m/s, 0.68 m/s, and twice that at first: a step may begin where the ramp has come as
// near as 1.36 m/s. On the ramp of 40 m/s in 60 s that is 2 s before its end, on that of 5 m/s in 20 s 5.4 s. It ends one or two
// samples into the next ramp. The seconds of the ramp take 0.0062 m/s from the mean of ten minutes.
TEST(ScheduleSteps, AreRecognisedInALoggedTest) {
    const std::vector<ScheduleStep> steps = schedule_steps(logged_test(), 0.0, 1280.0);
    ASSERT_EQ(steps.size(), 4U);
    EXPECT_TRUE(steps[0].ramp);
    EXPECT_FALSE(steps[1].ramp);
    EXPECT_TRUE(steps[1].recognised);
    EXPECT_EQ(steps[1].number, 1);
    EXPECT_NEAR(steps[1].from, 60.0, 3.0);
    EXPECT_NEAR(steps[1].to, 660.0, 4.0);
    EXPECT_NEAR(steps[1].speed, 40.0, 0.01);
    EXPECT_NEAR(steps[1].load, 5000.0, 1.0);
    EXPECT_TRUE(steps[2].ramp);
    EXPECT_EQ(steps[2].number, 2);
    EXPECT_EQ(steps[3].number, 2);
    EXPECT_NEAR(steps[3].from, 680.0, 5.5);
    EXPECT_EQ(steps[3].to, 1280.0);
    EXPECT_NEAR(steps[3].speed, 45.0, 0.01);
    const physics::Inputs held = held_at_means(logged_test(), steps[3]).at(0.0, JumpSide::after);
    EXPECT_NEAR(held.speed, 45.0, 0.02);
    EXPECT_NEAR(held.vertical_load, 5000.0, 5.0);
}

// From 30 to 60 m/s over 20 min: the speed leaves 0.9 m/s about its mean within 72 s or drifts, so that nothing stands still.
TEST(ScheduleSteps, ASlowRiseIsNoTestInSteps) {
    std::vector<double> time;
    std::vector<double> speed;
    for (int i = 0; i <= 1200; ++i) {
        time.push_back(i);
        speed.push_back(30.0 + 30.0 * i / 1200.0);
    }
    InputSignals input_signals;
    input_signals.add(series("speed", time, speed, true));
    EXPECT_TRUE(schedule_steps(input_signals, 0.0, 1200.0).empty());
}

// At 10 Hz over two hours and twice as long: the speed goes up and down while the load stands, and it rises slowly, so that a stretch
// about a mean lasts for long and then drifts. Each sample is compared with a mean at most a few times: a stretch that is no step is
// left by a sixteenth of it, so that it is looked at 16 times, and once more for the step itself.
TEST(ScheduleSteps, LookingForThemTakesAsLongAsTheLogIs) {
    for (const std::size_t n : {std::size_t{72'000}, std::size_t{144'000}}) {
        for (const bool rises : {true, false}) {
            std::vector<double> time;
            std::vector<double> speed;
            for (std::size_t i = 0; i < n; ++i) {
                time.push_back(0.1 * static_cast<double>(i));
                speed.push_back(rises ? 30.0 + 30.0 * static_cast<double>(i) / static_cast<double>(n)
                                      : 30.0 + 10.0 * std::sin(time.back()));
            }
            InputSignals input_signals;
            input_signals.add(series("speed", time, speed, true));
            input_signals.add(series("vertical_load", {0.0, time.back()}, {4000.0, 4000.0}, true));
            std::size_t looked_at = 0;
            EXPECT_TRUE(recognised_steps(input_signals, 0.0, time.back(), &looked_at).empty());
            EXPECT_LE(looked_at, 18U * n);
        }
    }
}

// 10 min at 40 m/s and 10 min at 45 m/s, at 50 Hz, with 60 s from one to the other: the second begins where the ramp has come within
// 2 x 1.5 % of 45 m/s, 1.35 m/s, which is 16.2 s before its end, or later: the mean of the first samples is not yet that of the step.
// On the ramp 0.675 m/s are 8.1 s: what begins 8.1 s or more before its end leaves its mean.
TEST(ScheduleSteps, ADenseLogHasThemWhereTheyAre) {
    std::vector<double> time;
    std::vector<double> speed;
    for (int i = 0; i <= 63'000; ++i) {
        const double t = 0.02 * i;
        time.push_back(t);
        speed.push_back(t <= 600.0 ? 40.0 : t < 660.0 ? 40.0 + 5.0 * (t - 600.0) / 60.0 : 45.0);
    }
    InputSignals input_signals;
    input_signals.add(series("speed", time, speed, true));
    const std::vector<ScheduleStep> steps = schedule_steps(input_signals, 0.0, 1260.0);
    ASSERT_EQ(steps.size(), 3U);
    EXPECT_NEAR(steps[0].to, 608.1, 0.1);
    EXPECT_NEAR(steps[2].from, 660.0 - 8.1, 8.1);
    EXPECT_NEAR(steps[2].speed, 45.0, 0.03);
}

TEST(ScheduleSteps, ADriveHasNone) {
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
