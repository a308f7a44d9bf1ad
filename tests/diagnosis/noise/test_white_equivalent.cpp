// SPDX-License-Identifier: BSD-3-Clause
// White noise of the same information: the variance of a long mean, by the sum over the dense covariance matrix.

#include "diagnosis/noise/white_equivalent.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace tiretherm::diagnosis {
namespace {

NoiseBlock even_block(int n, double interval) {
    std::vector<double> time;
    for (int i = 0; i < n; ++i) {
        time.push_back(interval * i);
    }
    return series_block(0, 0, time, std::vector<double>(time.size(), 1.0));
}

// The mean of n samples has the variance sum_ij V_ij / n^2. In 20 000 samples the ends, some 2 tau / interval samples, count
// 2e-3 of it at tau = 10 s and 0.5 s.
TEST(WhiteEquivalent, HasTheVarianceOfALongMean) {
    constexpr int n = 20000;
    constexpr double interval = 0.5;
    const Noise noise{.sigma = 0.4, .correlation_time = 10.0, .white_share = 0.3};
    double sum = n * 0.16;
    for (int lag = 1; lag < n; ++lag) {
        sum += 2.0 * (n - lag) * 0.16 * 0.7 * std::exp(-lag * interval / 10.0);
    }
    const std::vector<NoiseBlock> blocks{even_block(n, interval)};
    const Covariance white = white_equivalent({.channels = {noise}, .weight = {}}, blocks);
    EXPECT_NEAR(std::pow(white.channels[0].sigma, 2) / n, sum / n / n, 3e-3 * sum / n / n);
    EXPECT_EQ(white.channels[0].white_share, 1.0);
    EXPECT_EQ(white.channels[0].correlation_time, 0.0);
}

TEST(WhiteEquivalent, OfWhiteNoiseIsItself) {
    const std::vector<NoiseBlock> blocks{even_block(100, 1.0)};
    const Covariance white = white_equivalent({.channels = {{.sigma = 0.4}}, .weight = {}}, blocks);
    EXPECT_DOUBLE_EQ(white.channels[0].sigma, 0.4);
}

// (a, a, a, -a, -a, -a, ...): neighbours agree in two of three, r_1 = 1/3, and r_2 = -1/3 ends the sum. Of n samples
// 1 + 2 r_1 = 5/3 count as one. (b, -b, b, ...): r_1 = -1, every sample counts. The geometric mean is the root of 5/3: either
// channel's noise is as many times what is left of it.
TEST(WhiteNoiseOf, WhatAModelLeavesCountsChannelsAlike) {
    constexpr int n = 6000;
    std::vector<NoiseBlock> blocks{even_block(n, 2.0), even_block(n, 2.0)};
    blocks[1].channel = 1;
    blocks[1].first = n;
    Eigen::VectorXd left(2 * n);
    for (int i = 0; i < n; ++i) {
        left[i] = i / 3 % 2 == 0 ? 0.5 : -0.5;
        left[n + i] = i % 2 == 0 ? 3.0 : -3.0;
    }
    EXPECT_NEAR(time_scale(left, blocks, 0), 2.0 * (0.5 + 1.0 / 3.0), 2e-3);
    const Covariance white = white_noise_of(left, blocks, 2);
    EXPECT_NEAR(white.channels[0].sigma, 0.5 * std::pow(5.0 / 3.0, 0.25), 1e-3);
    EXPECT_NEAR(white.channels[1].sigma, 6.0 * white.channels[0].sigma, 1e-12);
    EXPECT_EQ(white.channels[0].correlation_time, 0.0);
}

}  // namespace
}  // namespace tiretherm::diagnosis
