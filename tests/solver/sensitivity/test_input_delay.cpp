// SPDX-License-Identifier: BSD-3-Clause
// Inputs whose log is late: a run with the delay given is the run in time, and slopes are those of differences.

#include <cmath>

#include "solver/bench.hpp"
#include "solver/sensitivity/slopes.hpp"

namespace tiretherm::solver {

namespace {

/// A load that swings by 1.5 kN in a minute about 4 kN, as a logger writes it every half second, so many seconds late.
Series swinging_load(double late) {
    std::vector<double> time;
    std::vector<double> value;
    for (int i = 0; i <= 1200; ++i) {
        const double t = 0.5 * i;
        time.push_back(t);
        value.push_back(4000.0 + 1500.0 * std::sin(2.0 * 3.14159265358979 * (t - late) / 60.0));
    }
    return {.signal = physics::find_signal("vertical_load"), .time = time, .value = value, .logged = true};
}

/// The two-node tire under that load.
Problem under(Series load) {
    Problem problem = two_node_tire();
    problem.input_signals = {};
    hold(problem, "speed", 100.0 / 3.6);
    hold(problem, "air_temperature", 296.15);
    hold(problem, "road_temperature", 296.15);
    problem.input_signals.add(std::move(load));
    return problem;
}

std::vector<double> times() {
    std::vector<double> all;
    for (int i = 1; i <= 59; ++i) {
        all.push_back(10.0 * i);
    }
    return all;
}

double farthest(const Prediction& a, const Prediction& b) {
    double most = 0.0;
    for (std::size_t i = 0; i < a.value.size(); ++i) {
        most = std::max(most, std::abs(a.value[i] - b.value[i]));
    }
    return most;
}

}  // namespace

// 2 s are four samples: the log moves by whole samples, and but for the last 2 s of it nothing is left of the delay.
TEST(InputDelay, GivesTheRunInTimeBack) {
    const std::vector<double> asked = times();
    const Prediction in_time = predict(under(swinging_load(0.0)), {.times = asked});
    Problem late = under(swinging_load(2.0));
    const Prediction off = predict(late, {.times = asked, .step_ends = in_time.step_ends});
    act(late, "input_delay", {{"vertical_load", 2.0}});
    const Prediction mended = predict(late, {.times = asked, .step_ends = in_time.step_ends});
    ASSERT_TRUE(in_time.status.ok() && off.status.ok() && mended.status.ok());
    // The loss swings by half of its mean, some 400 W into 12 kJ/K, for 60 s: 2 s of it are a tenth of a kelvin or more.
    EXPECT_GT(farthest(in_time, off), 0.02);
    EXPECT_LT(farthest(in_time, mended), 1e-9);
}

// What the log does over the steps that were found serves the march over them as well; over given steps it is found anew. Both
// marches are one, to the last digit.
TEST(InputDelay, OfStepsThatWereJustFoundIsThatOfGivenSteps) {
    const std::vector<double> asked = times();
    Problem late = under(swinging_load(2.0));
    act(late, "input_delay", {{"vertical_load", 2.0}});
    const Prediction found = predict(late, {.times = asked});
    const Prediction given = predict(late, {.times = asked, .step_ends = found.step_ends});
    ASSERT_TRUE(found.status.ok() && given.status.ok());
    EXPECT_LT(found.step_ends.size(), 1200U);  // steps span samples
    EXPECT_EQ(found.value, given.value);
}

TEST(InputDelay, OfAnotherInputChangesNothing) {
    const std::vector<double> asked = times();
    Problem problem = under(swinging_load(0.0));
    const Prediction without = predict(problem, {.times = asked});
    act(problem, "input_delay", {{"slip_angle", 3.0}});
    const Prediction with = predict(problem, {.times = asked, .step_ends = without.step_ends});
    EXPECT_EQ(without.value, with.value);
}

// Between its samples a log is a straight line: within one interval the readings are smooth in the delay.
TEST(InputDelay, SlopesEqualDifferences) {
    Problem problem = under(swinging_load(0.7));
    act(problem, "input_delay", {{"vertical_load", 0.7}});
    expect_differences(problem, {number(problem, "input_delay", "vertical_load")}, 1e-5);
}

// At a sample the line bends; that is no switch of the model.
TEST(InputDelay, IsNoSwitch) {
    Problem problem = under(swinging_load(0.0));
    act(problem, "input_delay");
    const std::vector<FreeParameter> numbers{number(problem, "input_delay", "vertical_load")};
    const std::vector<double> asked = times();
    const Prediction there =
        predict(problem, {.times = asked, .parameters = numbers, .values = values_of(problem, numbers)});
    ASSERT_TRUE(there.status.ok()) << there.status.message;
    EXPECT_TRUE(there.non_smooth_parameters.empty());
    EXPECT_NE(there.slope_at(0, 30, 1), 0.0);
}

TEST(InputSignals, AScheduleMovesWithItsPoints) {
    InputSignals signals;
    const physics::Signal& speed = *physics::find_signal("speed");
    signals.add({.signal = &speed, .time = {0.0, 10.0, 30.0}, .value = {0.0, 1.0, 5.0}});
    signals.advance(speed, 4.0);
    EXPECT_DOUBLE_EQ(signals.at(6.0, JumpSide::before).speed, 1.0);
    EXPECT_DOUBLE_EQ(signals.at(16.0, JumpSide::before).speed, 3.0);  // half way from 10 s to 30 s, 4 s early
}

}  // namespace tiretherm::solver
