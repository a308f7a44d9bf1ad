// SPDX-License-Identifier: BSD-3-Clause
// Input signals: jumps, break times, and steps that keep mean and first moment of a logged series, by hand calculation.

#include "solver/input_signals.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "solver/bench.hpp"
#include "solver/time_integration/step_forcing.hpp"

namespace tiretherm::solver {

namespace {

const physics::Signal& power() { return *physics::find_signal("laser_power"); }
const physics::Signal& speed() { return *physics::find_signal("speed"); }

/// A laser on a lump of everything: the coefficient is the power itself.
Problem lit_strip(Series series) {
    Problem problem = strip(4);
    physics::ActiveEffect laser = physics::activate(*physics::find_effect("laser"), problem.mesh);
    laser.patches = {0};
    problem.effects = {laser};
    problem.input_signals.add(std::move(series));
    return problem;
}

}  // namespace

TEST(Series, JumpHasAValueBeforeAndAValueAfter) {
    const Series s{.signal = &power(), .time = {0.0, 10.0, 10.0, 20.0}, .value = {1.0, 1.0, 3.0, 5.0}};
    EXPECT_EQ(s.at(10.0, JumpSide::before), 1.0);
    EXPECT_EQ(s.at(10.0, JumpSide::after), 3.0);
    EXPECT_EQ(s.at(15.0, JumpSide::before), 4.0);
    EXPECT_EQ(s.at(-5.0, JumpSide::after), 1.0);
    EXPECT_EQ(s.at(99.0, JumpSide::before), 5.0);
}

// A point is looked for from where it would be if all were even. Here they are not: i^3 s, each third one twice, with i as value before and
// i + 0.5 after the jump. A quarter of the way from one to the next the value has gone a quarter of the way as well.
TEST(Series, IsReadOffHoweverUnevenItsPointsAre) {
    std::vector<double> time;
    std::vector<double> value;
    const auto after = [](int i) { return i % 3 == 0 ? i + 0.5 : static_cast<double>(i); };
    for (int i = 0; i < 200; ++i) {
        time.push_back(std::pow(i, 3));
        value.push_back(i);
        if (i % 3 == 0) {
            time.push_back(time.back());
            value.push_back(after(i));
        }
    }
    const Series s{.signal = &power(), .time = time, .value = value};
    for (int i = 0; i < 200; ++i) {
        EXPECT_EQ(s.at(std::pow(i, 3), JumpSide::before), i);
        EXPECT_EQ(s.at(std::pow(i, 3), JumpSide::after), after(i));
        if (i < 199) {
            const double t = 0.75 * std::pow(i, 3) + 0.25 * std::pow(i + 1, 3);
            EXPECT_NEAR(s.at(t, JumpSide::before), 0.75 * after(i) + 0.25 * (i + 1), 1e-9) << i;
        }
    }
}

TEST(InputSignals, ScheduleStopsTheStepAndALoggerOnlyWhereItJumps) {
    InputSignals input_signals;
    input_signals.add({.signal = &power(), .time = {0.0, 10.0, 30.0}, .value = {0.0, 1.0, 1.0}});
    input_signals.add(
        {.signal = &speed(), .time = {0.0, 1.0, 2.0, 2.0, 3.0}, .value = {0.0, 1.0, 2.0, 5.0, 5.0}, .logged = true});
    EXPECT_EQ(input_signals.stops(), (std::vector<double>{0.0, 2.0, 10.0, 30.0}));
    EXPECT_EQ(input_signals.samples(), (std::vector<double>{0.0, 1.0, 2.0, 3.0}));
    EXPECT_TRUE(input_signals.gives(power()));
    EXPECT_FALSE(input_signals.gives(*physics::find_signal("camber")));
    EXPECT_EQ(input_signals.at(5.0, JumpSide::before).laser_power, 0.5);
}

// Columns of one log share its times and are looked up once; one with times of its own lies between them.
TEST(InputSignals, OfOneLogShareTheirTimes) {
    const SharedSamples time{0.0, 1.0, 3.0};
    InputSignals input_signals;
    input_signals.add({.signal = &speed(), .time = time, .value = {0.0, 2.0, 6.0}, .logged = true});
    input_signals.add(
        {.signal = physics::find_signal("camber"), .time = {0.0, 4.0}, .value = {0.0, 0.4}, .logged = true});
    input_signals.add({.signal = &power(), .time = time, .value = {1.0, 2.0, 4.0}, .logged = true});
    EXPECT_EQ(input_signals.series()[0].time.data(), input_signals.series()[2].time.data());
    EXPECT_EQ(input_signals.samples(), (std::vector<double>{0.0, 1.0, 3.0, 4.0}));
    const physics::Inputs at = input_signals.at(2.0, JumpSide::before);
    EXPECT_DOUBLE_EQ(at.speed, 4.0);
    EXPECT_DOUBLE_EQ(at.camber, 0.2);
    EXPECT_DOUBLE_EQ(at.laser_power, 3.0);
    const InputSignals copy = input_signals;
    input_signals.move(power(), 2.0, 0.0);
    EXPECT_EQ(copy.at(2.0, JumpSide::before).laser_power, 3.0);
    EXPECT_EQ(input_signals.at(2.0, JumpSide::before).laser_power, 6.0);
}

TEST(InputSignals, ConstantsHoldForEver) {
    InputSignals input_signals;
    input_signals.add(speed(), 30.0);
    EXPECT_EQ(input_signals.at(1e6, JumpSide::after).speed, 30.0);
    EXPECT_TRUE(input_signals.stops().empty());
}

TEST(InputSignals, LearnTimesWithoutAnInput) {
    InputSignals input_signals;
    input_signals.add(Series{.signal = &power(), .time = {0.0, 10.0}, .value = {1.0, 3.0}});
    input_signals.add_break_times({5.0, 2.0, 5.0, 10.0});
    input_signals.add_sample_times({4.0, 1.0, 1.0});
    EXPECT_EQ(input_signals.stops(), (std::vector<double>{0.0, 2.0, 5.0, 10.0}));
    EXPECT_EQ(input_signals.samples(), (std::vector<double>{1.0, 4.0}));
    EXPECT_EQ(input_signals.series().size(), 1U);
    EXPECT_DOUBLE_EQ(input_signals.at(5.0, JumpSide::before).laser_power, 2.0);
}

TEST(StepForcing, TakesASmoothDriveAtTheTimesOfItsStages) {
    const Problem problem = lit_strip({.signal = &power(), .time = {0.0, 10.0}, .value = {0.0, 5.0}});
    const System system(problem);
    StepForcing forcing(system, problem.input_signals, tr_bdf2);
    forcing.open(2.0, 4.0);
    EXPECT_FALSE(forcing.averaged());
    EXPECT_NEAR(forcing.stage(0)[0], 1.0, 1e-14);
    EXPECT_NEAR(forcing.stage(1)[0], 0.5 * (2.0 + 2.0 * (2.0 - std::sqrt(2.0))), 1e-14);
    EXPECT_NEAR(forcing.stage(2)[0], 2.0, 1e-14);
}

TEST(StepForcing, KeepsMeanAndFirstMomentOfALoggedSeries) {
    // Straight between samples at 0, 1, 2, 4 s with values 1, 2, 4, 3. Over [0, 4]: trapezoids 1.5 + 3 + 7 = 11.5, mean
    // 2.875. First moment about the middle (s in [-2, 2]), exact for straight pieces: integral of s v ds =
    //   piece (m, v0 -> v1, width w, centre s_m): w s_m (v0+v1)/2 + w^2 (v1-v0)/12
    //   -1.5*1.5 + 1/12 = -2.1667;  -0.5*3 + 2/12 = -1.3333;  2*1*3.5 + 4*(-1)/12 = 6.6667;  sum 3.1667
    // The line mean + slope s / 4 has the moment slope/4 * 64/12 = 4/3 slope: slope = 2.375.
    const Problem problem = lit_strip(
        {.signal = &power(), .time = {0.0, 1.0, 2.0, 4.0, 9.0}, .value = {1.0, 2.0, 4.0, 3.0, 3.0}, .logged = true});
    const System system(problem);
    StepForcing forcing(system, problem.input_signals, tr_bdf2);
    forcing.open(0.0, 4.0);
    ASSERT_TRUE(forcing.averaged());
    const double first = forcing.stage(0)[0];
    const double last = forcing.stage(2)[0];
    EXPECT_NEAR(0.5 * (first + last), 2.875, 1e-12);
    EXPECT_NEAR(last - first, 2.25, 1e-12);  // 2.375 would reach 4.06: held at the largest sample, 4, twice 1.125
}

TEST(StepForcing, OfAnUnlimitedSlopeHasTheExactMoment) {
    // A gentle series far from its bounds at the ends is not limited: values 0, 3, 1, 4 at 0..3 s.
    // Mean: (1.5 + 2 + 2.5)/3 = 2. Moment: -1*1.5 + 3/12 + 0 - 2/12 + 1*2.5 + 3/12 = 4/3. slope * 27/12/3 = 4/3: 16/9.
    const Problem problem = lit_strip(
        {.signal = &power(), .time = {0.0, 1.0, 2.0, 3.0, 9.0}, .value = {0.0, 3.0, 1.0, 4.0, 4.0}, .logged = true});
    const System system(problem);
    StepForcing forcing(system, problem.input_signals, tr_bdf2);
    forcing.open(0.0, 3.0);
    EXPECT_NEAR(forcing.stage(2)[0] - forcing.stage(0)[0], 16.0 / 9.0, 1e-12);
    EXPECT_NEAR(0.5 * (forcing.stage(2)[0] + forcing.stage(0)[0]), 2.0, 1e-12);
}

TEST(StepForcing, SaysHowMuchALineLeavesOut) {
    // A triangle wave 0, 2, 0, 2, 0 about its mean 1: the running integral of what is left out swings by a quarter of a
    // period's area, 0.25 s * 1 / 2 * ... = 0.25 at most for a period of 2 s, divided by the step of 4 s.
    const Problem problem = lit_strip({.signal = &power(),
                                       .time = {0.0, 1.0, 2.0, 3.0, 4.0, 9.0},
                                       .value = {0.0, 2.0, 0.0, 2.0, 0.0, 0.0},
                                       .logged = true});
    const System system(problem);
    StepForcing forcing(system, problem.input_signals, tr_bdf2);
    forcing.open(0.0, 4.0);
    EXPECT_NEAR(forcing.stage(0)[0], 1.0, 1e-12);
    EXPECT_NEAR(forcing.unresolved()[0] - forcing.stage(0)[0], 0.25 / 4.0, 1e-12);
}

}  // namespace tiretherm::solver
