// SPDX-License-Identifier: BSD-3-Clause
// Gains of predictions by hand, and intervals that hold the truth where a gain is nothing but chance.

#include "diagnosis/assess/prediction_gain.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "diagnosis/assess/diagnosis_state.hpp"
#include "diagnosis/assess/prediction_search.hpp"

namespace tiretherm::diagnosis {
namespace {

/// Two channels over runs of 600 s, a sample a second.
Observations two_channels(std::size_t runs) {
    Observations all;
    all.channels = {0, 1};
    all.names = {"a", "b"};
    all.stated = {0.5, 0.5};
    for (std::size_t r = 0; r < runs; ++r) {
        std::vector<double> time;
        for (int i = 0; i < 600; ++i) {
            time.push_back(i);
        }
        all.times.push_back(time);
        all.recordings.push_back(r);
        for (std::size_t c = 0; c < 2; ++c) {
            all.blocks.push_back(series_block(static_cast<int>(c), static_cast<Eigen::Index>(all.rows.size()), time,
                                              std::vector<double>(time.size(), 0.0)));
            for (std::size_t i = 0; i < time.size(); ++i) {
                all.rows.push_back({.run = r, .channel = c, .time = i});
            }
        }
    }
    all.measured = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(all.rows.size()));
    return all;
}

const std::vector<Noise> white{{.sigma = 0.5}, {.sigma = 0.5}};

/// Errors of constant size: channel a, channel b.
HeldOutErrors errors(const Observations& observations, double a, double b) {
    HeldOutErrors out{.left = Eigen::VectorXd(observations.measured.size()), .ok = true};
    for (std::size_t row = 0; row < observations.rows.size(); ++row) {
        out.left[static_cast<Eigen::Index>(row)] = observations.rows[row].channel == 0 ? a : b;
    }
    return out;
}

// Channel a falls from 2 to 1 (3/4 of its square), b rises from 1.0 to 1.1 (-0.21): the mean is 0.27, whatever the samples.
// Independent samples: 600 in each of 2 runs and channel, 600 ln 4 - 600 ln 1.21.
TEST(PredictionGain, CountsChannelsAlike) {
    const Observations observations = two_channels(2);
    const PredictionGain gain = compare_predictions(errors(observations, 2.0, 1.0), errors(observations, 1.0, 1.1),
                                                    observations, white, {0.5, 0.5});
    EXPECT_NEAR(gain.removed, 0.5 * (0.75 - 0.21), 1e-12);
    EXPECT_NEAR(gain.low, gain.removed, 1e-12);  // errors of one size: every draw is the same
    EXPECT_NEAR(gain.worst, 1.1, 1e-12);
    EXPECT_NEAR(gain.log_odds, 600.0 * (std::log(4.0) - std::log(1.21)), 1e-6);
    EXPECT_NEAR(gain.removable, 0.5 * ((1.0 - 0.25 / 4.0) + (1.0 - 0.25)), 1e-12);
    EXPECT_TRUE(gain.in_every_fold);
    ASSERT_EQ(gain.channels.size(), 2u);
    EXPECT_NEAR(gain.channels[0].before, 2.0, 1e-12);
    EXPECT_NEAR(gain.channels[0].after, 1.0, 1e-12);
    EXPECT_NEAR(gain.channels[0].low, 1.0, 1e-12);
    EXPECT_NEAR(gain.channels[1].high, -0.1, 1e-12);
}

TEST(PredictionGain, SeesARunThatGetsWorse) {
    const Observations observations = two_channels(3);
    const HeldOutErrors before = errors(observations, 2.0, 2.0);
    HeldOutErrors after = errors(observations, 1.0, 1.0);
    for (std::size_t row = 0; row < observations.rows.size(); ++row) {
        if (observations.rows[row].run == 1) {
            after.left[static_cast<Eigen::Index>(row)] = 2.2;
        }
    }
    const PredictionGain gain = compare_predictions(before, after, observations, white, {0.5, 0.5});
    EXPECT_GT(gain.removed, 0.4);
    EXPECT_FALSE(gain.in_every_fold);
}

// Two predictions that are wrong in different ways and equally far on the average, over slow errors of 30 s: the 95 %
// interval excludes zero in one of twenty. Of 200 draws 10 are expected; 25 and more come by chance once in 1e5.
TEST(PredictionGain, IntervalHoldsNothingWhereThereIsNothing) {
    const Observations observations = two_channels(2);
    const std::vector<Noise> slow{{.sigma = 0.5, .correlation_time = 30.0, .white_share = 0.0},
                                  {.sigma = 0.5, .correlation_time = 30.0, .white_share = 0.0}};
    std::mt19937_64 random(3);
    std::normal_distribution<double> normal;
    const double keep = std::exp(-1.0 / 30.0);
    int excluded = 0;
    for (int draw = 0; draw < 200; ++draw) {
        HeldOutErrors one = errors(observations, 0.0, 0.0);
        HeldOutErrors other = one;
        for (HeldOutErrors* out : {&one, &other}) {
            double x = normal(random);
            for (double& left : out->left) {
                x = keep * x + std::sqrt(1.0 - keep * keep) * normal(random);
                left = x;
            }
        }
        const PredictionGain gain = compare_predictions(one, other, observations, slow, {0.0, 0.0});
        excluded += gain.low > 0.0 || gain.high < 0.0 ? 1 : 0;
    }
    EXPECT_LT(excluded, 25);
}

// 20 % removed, 5 % of it beyond doubt, in every run, and no channel worse: an improvement, until one of these is not so. A later
// addition needs 3 % beyond doubt. A channel may rise by 2 %, and by a tenth of the 20 % removed: 4 %.
TEST(PredictionGain, IsAnImprovementBeyondChanceAndAtTheCostOfNothing) {
    const PredictionGain good{.removed = 0.20, .low = 0.05, .high = 0.3, .worst = 1.0, .in_every_fold = true};
    EXPECT_TRUE(is_improvement(good));
    EXPECT_TRUE(is_improvement(good, 0.03));
    const auto changed = [&](const auto& change) {
        PredictionGain one = good;
        change(one);
        return one;
    };
    EXPECT_EQ(doubt_of(good), AdditionDoubt::none);
    EXPECT_EQ(doubt_of(changed([](PredictionGain& one) { one.removed = 0.02; })), AdditionDoubt::too_small);
    EXPECT_EQ(doubt_of(changed([](PredictionGain& one) { one.low = -0.01; })), AdditionDoubt::may_be_chance);
    EXPECT_EQ(doubt_of(changed([](PredictionGain& one) { one.worst = 1.041; })), AdditionDoubt::worsens_channel);
    EXPECT_EQ(doubt_of(changed([](PredictionGain& one) { one.in_every_fold = false; })), AdditionDoubt::worsens_part);
    EXPECT_FALSE(is_improvement(changed([](PredictionGain& one) { one.removed = 0.02; })));
    EXPECT_FALSE(is_improvement(changed([](PredictionGain& one) { one.low = -0.01; })));
    const PredictionGain small = changed([](PredictionGain& one) { one.low = 0.02; });
    EXPECT_TRUE(is_improvement(small));
    EXPECT_FALSE(is_improvement(small, 0.03));
    EXPECT_TRUE(is_improvement(changed([](PredictionGain& one) { one.worst = 1.039; })));
    EXPECT_FALSE(is_improvement(changed([](PredictionGain& one) { one.worst = 1.041; })));
    EXPECT_FALSE(is_improvement(changed([](PredictionGain& one) { one.in_every_fold = false; })));
    EXPECT_TRUE(is_improvement(changed([](PredictionGain& one) {
        one.in_every_fold = false;
        one.low = 0.11;  // too much to be one run's
    })));
}

// Noise of 0.5. Channel a shows sqrt(1.25) and is left with 1: 0.25 of the 1.00 beyond its noise, a quarter. Channel b falls from 1.5 to
// 0.5: all 2.00 beyond its noise. Were a left with sqrt(0.7), 0.55 of 1.00 would be gone. A channel that shows 0.6 has less beyond its
// noise, 0.11, than the noise itself, 0.25: nothing is asked of it.
TEST(PredictionGain, IsNotConfirmedWhereTheGreaterPartOfASensorsErrorIsLeft) {
    const Observations observations = two_channels(3);
    const auto confirmed = [&](double before, double after) {
        const PredictionGain gain = compare_predictions(
            errors(observations, before, 1.5), errors(observations, after, 0.5), observations, white, {0.5, 0.5});
        Gain taken;
        take_gain(gain, taken);
        return is_confirmed(gain, taken);
    };
    EXPECT_NEAR(*share_explained(std::sqrt(1.25), 1.0, 0.5), 0.25, 1e-12);
    EXPECT_FALSE(confirmed(std::sqrt(1.25), 1.0));
    EXPECT_TRUE(confirmed(std::sqrt(1.25), std::sqrt(0.7)));
    EXPECT_FALSE(share_explained(0.6, 0.6, 0.5));
    EXPECT_TRUE(confirmed(0.6, 0.6));
    EXPECT_FALSE(share_explained(2.0, 2.0, 0.0));  // no noise is known
}

}  // namespace
}  // namespace tiretherm::diagnosis
