// SPDX-License-Identifier: BSD-3-Clause
// What an error of the model does to the intervals of a cause, and what the intervals do to the answer.

#include <gtest/gtest.h>

#include "diagnosis/assess/diagnosis_state.hpp"

namespace tiretherm::diagnosis {

// The error leaves 0.5 of the number 2 on either side. Its companion is three times as large, and so is what is left of it:
// 6 +- 1.5. The number that was held on trial, also 2, follows another fitted number, of which 0.1 is left.
TEST(ModelError, WidensEachNumberByThatWhichItFollows) {
    Cause cause{
        .id = "inner_gas",
        .numbers = {{.key = "liner", .unit = {}, .value = 2.0, .low = 1.9, .high = 2.1, .fitted = 1},
                    {.key = "rim", .unit = {}, .value = 6.0, .low = 5.7, .high = 6.3, .fitted = 1, .factor = 3.0},
                    {.key = "held", .unit = {}, .value = 2.0, .low = 1.8, .high = 2.2, .fitted = 2}}};
    cause.widen({7.0, 0.5, 0.1});
    EXPECT_DOUBLE_EQ(cause.numbers[0].low, 1.5);
    EXPECT_DOUBLE_EQ(cause.numbers[0].high, 2.5);
    EXPECT_DOUBLE_EQ(cause.numbers[1].low, 4.5);
    EXPECT_DOUBLE_EQ(cause.numbers[1].high, 7.5);
    EXPECT_DOUBLE_EQ(cause.numbers[2].low, 1.8);
    EXPECT_DOUBLE_EQ(cause.numbers[2].high, 2.2);
}

namespace {

/// A verdict with one cause, which removes 5 % of the mean square of data that were left out.
Diagnosis with_one_cause(double low, double high) {
    Diagnosis found;
    found.verdict = Verdict::partial;
    found.causes = {
        {.id = "loss_frequency_shift",
         .numbers = {{.key = "per_decade", .unit = "K", .value = -5.0, .low = low, .high = high, .absent = 0.0}},
         .in_set = true}};
    found.hypotheses = {{0}};
    found.gain = {.measured = true, .removed = 0.05};
    found.extended_model.emplace();
    return found;
}

/// Two numbers, each known to 0.5 by one reading.
FittedHypothesis hypothesis_at(const input::Experiment& experiment, double first, double second) {
    FittedHypothesis one;
    one.model = experiment;
    one.fit.values = Eigen::Vector2d(first, second);
    one.fit.scale = Eigen::Vector2d::Constant(0.5);
    one.fit.slopes = Eigen::Matrix2d::Identity();
    one.fit.precision = Eigen::Vector2d::Zero();
    one.fit.at_bound = {false, false};
    return one;
}

}  // namespace

// -5 K in an interval from -18 to 7 K may be none, and nothing confirms it: it is no answer.
TEST(ModelError, WhatMayBeAbsentAndIsNotConfirmedIsNoAnswer) {
    Diagnosis found = with_one_cause(-18.0, 7.0);
    ASSERT_TRUE(withdraw_what_may_be_absent(found));
    EXPECT_EQ(found.verdict, Verdict::cannot_tell);
    EXPECT_EQ(found.reason, remark::may_be_absent("loss_frequency_shift", 5.0));
    EXPECT_TRUE(found.hypotheses.empty());
    EXPECT_FALSE(found.causes.front().in_set);
    EXPECT_FALSE(found.extended_model.has_value());
}

TEST(ModelError, WhatIsPresentOrConfirmedStands) {
    Diagnosis present = with_one_cause(-9.0, -1.0);
    EXPECT_FALSE(withdraw_what_may_be_absent(present));
    Diagnosis confirmed = with_one_cause(-18.0, 7.0);
    confirmed.gain.confirmed = true;
    EXPECT_FALSE(withdraw_what_may_be_absent(confirmed));
    EXPECT_EQ(confirmed.verdict, Verdict::partial);
}

// Two members of a set that data cannot tell apart put the first number at 1 and at 3, each known to 0.5: it lies between
// 1 - 1.959964 x 0.5 and 3 + 1.959964 x 0.5. They agree on the second, 2: 2 +- 0.979982.
TEST(ModelError, AFreeNumberReachesToWhatEveryMemberOfTheSetMakesOfIt) {
    input::Experiment experiment;
    for (const char* name : {"film", "loss"}) {
        experiment.parameters.push_back({.name = name,
                                         .unit = "1",
                                         .layers = {},
                                         .knots = {},
                                         .nodes = {},
                                         .runs = {},
                                         .low = -100.0,
                                         .high = 100.0});
    }
    const Observations none;
    const FittedHypothesis one = hypothesis_at(experiment, 1.0, 2.0);
    const FittedHypothesis other = hypothesis_at(experiment, 3.0, 2.0);
    DiagnosisState state;
    state.score_data.experiment = &experiment;
    state.score_data.observations = &none;
    state.verdict = Verdict::confounded;
    state.set = {&one, &other};
    Diagnosis found;
    describe_model_error(state, found);
    ASSERT_EQ(found.free_numbers.size(), 2u);
    constexpr double half = 0.5 * 1.959964;
    EXPECT_NEAR(found.free_numbers[0].low, 1.0 - half, 1e-6);
    EXPECT_NEAR(found.free_numbers[0].high, 3.0 + half, 1e-6);
    EXPECT_NEAR(found.free_numbers[1].low, 2.0 - half, 1e-6);
    EXPECT_NEAR(found.free_numbers[1].high, 2.0 + half, 1e-6);
}

}  // namespace tiretherm::diagnosis
