// SPDX-License-Identifier: BSD-3-Clause
// What an error of the model does to the intervals of a cause, and what the intervals do to the answer.

#include <cmath>

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

solver::FreeParameter free_number(const char* name) {
    return {
        .name = name, .unit = "1", .layers = {}, .knots = {}, .nodes = {}, .runs = {}, .low = -100.0, .high = 100.0};
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

// Blocks of one recording predicted each other, with a number that may be none; beside it a mesh, which has no number.
TEST(ModelError, OfASingleRecordingWhatMayBeAbsentIsNoAnswerThoughConfirmed) {
    for (const bool has_mesh : {false, true}) {
        Diagnosis found = with_one_cause(-18.0, 7.0);
        found.gain.confirmed = found.gain.within_run = true;
        if (has_mesh) {
            found.causes.push_back({.id = "mesh", .in_set = true});
            found.hypotheses.front().push_back(1);
        }
        ASSERT_TRUE(withdraw_what_may_be_absent(found));
        EXPECT_EQ(found.verdict, Verdict::cannot_tell);
        EXPECT_FALSE(found.gain.confirmed);
    }
    Diagnosis mesh_alone = with_one_cause(-18.0, 7.0);
    mesh_alone.causes.front().numbers.clear();
    EXPECT_FALSE(withdraw_what_may_be_absent(mesh_alone));
}

// Two members of a set that data cannot tell apart put the first number at 1 and at 3, each known to 0.5: it lies between
// 1 - 1.959964 x 0.5 and 3 + 1.959964 x 0.5. They agree on the second, 2: 2 +- 0.979982.
TEST(ModelError, AFreeNumberReachesToWhatEveryMemberOfTheSetMakesOfIt) {
    input::Experiment experiment;
    for (const char* name : {"film", "loss"}) {
        experiment.parameters.push_back(free_number(name));
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

// Two recordings of 100 s, a sample a second of one channel, whose mean is the number. The halves of each are at 1 and -1, so that the
// recordings agree to the last digit, and what is left without one of them says nothing. Without a half at x the mean is -x / 3, and the
// jackknife is t(3) sqrt(3/4 x 4/9) = 3.182 / sqrt(3).
TEST(ModelError, OfTwoRecordingsTheHalvesAreLeftOut) {
    input::Experiment experiment;
    experiment.parameters.push_back(free_number("level"));
    Observations observations;
    observations.channels = {0};
    observations.names = {"probe"};
    observations.stated = {10.0};
    observations.recordings = {0, 1};
    constexpr Eigen::Index n = 100;
    observations.measured.resize(2 * n);
    for (std::size_t run = 0; run < 2; ++run) {
        std::vector<double> times;
        for (std::size_t i = 0; i < n; ++i) {
            times.push_back(static_cast<double>(i));
            observations.rows.push_back({.run = run, .channel = 0, .time = i});
            observations.measured[static_cast<Eigen::Index>(run * n + i)] = i < n / 2 ? 1.0 : -1.0;
        }
        const std::vector<double> values(n, 0.0);
        observations.blocks.push_back(series_block(0, static_cast<Eigen::Index>(run) * n, times, values));
        observations.times.push_back(std::move(times));
    }
    FittedHypothesis one;
    one.model = experiment;
    one.fit.values = Eigen::VectorXd::Zero(1);
    one.fit.scale = Eigen::VectorXd::Ones(1);
    one.fit.slopes = one.fit.raw = Eigen::MatrixXd::Ones(2 * n, 1);
    one.fit.precision = one.fit.known = Eigen::VectorXd::Zero(1);
    one.fit.residual = observations.measured;
    one.fit.simulated = Eigen::VectorXd::Zero(2 * n);
    one.fit.at_bound = {false};
    DiagnosisState state;
    state.score_data.experiment = &experiment;
    state.score_data.observations = &observations;
    state.score_data.noise.channels = {{.sigma = 1.0}};
    state.set = {&one};
    state.something_left = true;
    state.of_folds = {one.fit.values, one.fit.values};
    Diagnosis found;
    found.extended = one.fit.simulated;
    describe_model_error(state, found);
    ASSERT_EQ(found.free_numbers.size(), 1u);
    EXPECT_NEAR(found.free_numbers.front().high, 3.182 / std::sqrt(3.0), 1e-3);
}

}  // namespace tiretherm::diagnosis
