// SPDX-License-Identifier: BSD-3-Clause
// Smoothing without a delay: what it keeps and what it takes away.

#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "physics/vehicle/local_mean.hpp"

namespace tiretherm::physics {

namespace {

std::vector<double> clock_of(std::size_t n, double step) {
    std::vector<double> time(n);
    for (std::size_t i = 0; i < n; ++i) {
        time[i] = step * static_cast<double>(i);
    }
    return time;
}

}  // namespace

TEST(LocalMean, KeepsAStraightLineToItsEnds) {
    // A mean over a window that lies evenly about a sample is the value of the line there. Uneven samples.
    std::vector<double> time{0.0, 0.01, 0.05, 0.06, 0.2, 0.21, 0.5, 0.55};
    std::vector<double> value;
    for (const double t : time) {
        value.push_back(3.0 - 2.0 * t);
    }
    const std::vector<double> mean = local_mean(time, value, 0.2);
    for (std::size_t i = 0; i < time.size(); ++i) {
        EXPECT_NEAR(mean[i], value[i], 1e-12);
    }
}

TEST(LocalMean, AttenuatesASineAsTheTriangleSays) {
    // Two means over w/2 take sin(x)/x each, x = pi f w/2: at f = 1 Hz and w = 0.2 s 0.98363^2 = 0.96753, at 5 Hz
    // (2/pi)^2 = 0.40528, at 10 Hz nothing. Samples every 2 ms: lines between them cost (2 pi f dt)^2/8 < 2e-3 of it.
    const std::vector<double> time = clock_of(2001, 0.002);
    for (const auto& [f, kept] : {std::pair{1.0, 0.96753}, std::pair{5.0, 0.40528}, std::pair{10.0, 0.0}}) {
        std::vector<double> value;
        for (const double t : time) {
            value.push_back(std::sin(2.0 * std::numbers::pi * f * t));
        }
        const std::vector<double> mean = local_mean(time, value, 0.2);
        for (std::size_t i = 500; i < 1500; ++i) {
            EXPECT_NEAR(mean[i], kept * value[i], 3e-3);  // in phase
        }
    }
}

TEST(LocalMean, LeavesTwoThirdsOverNOfTheNoise) {
    // White noise under a triangle of n samples on each side: the sum of its squared weights is 2/(3 n); here w = 0.2 s at
    // 100 Hz, n = 10: 0.0667, rms 0.258. Each of the two means is the integral of straight lines, which smooths a little
    // more; 20000 samples with some 13 alike leave 0.258 within 0.258/sqrt(2 x 1500) x 4 = 0.02.
    std::mt19937 random(5);
    std::normal_distribution<double> noise(0.0, 1.0);
    const std::vector<double> time = clock_of(20000, 0.01);
    std::vector<double> value(time.size());
    for (double& one : value) {
        one = noise(random);
    }
    double square = 0.0;
    for (const double one : local_mean(time, value, 0.2)) {
        square += one * one;
    }
    EXPECT_NEAR(std::sqrt(square / 20000.0), 0.25, 0.02);
}

TEST(LocalMean, NeverOvershootsAStep) {
    // Weights are positive: a step from 0 to 1 stays between them, and is 1/2 in its middle.
    const std::vector<double> time = clock_of(101, 0.01);
    std::vector<double> value(time.size(), 0.0);
    std::fill(value.begin() + 51, value.end(), 1.0);
    value[50] = 0.5;
    const std::vector<double> mean = local_mean(time, value, 0.2);
    for (const double one : mean) {
        EXPECT_GE(one, -1e-12);
        EXPECT_LE(one, 1.0 + 1e-12);
    }
    EXPECT_NEAR(mean[50], 0.5, 1e-12);
    EXPECT_NEAR(mean[39], 0.0, 1e-12);
    EXPECT_NEAR(mean[61], 1.0, 1e-12);
}

TEST(LocalSlope, IsExactOfAParabolaInTheMiddle) {
    // (f(t + h) - f(t - h))/(2 h) = 2 t of t^2 at samples that the window's ends meet.
    const std::vector<double> time = clock_of(101, 0.01);
    std::vector<double> value;
    for (const double t : time) {
        value.push_back(t * t);
    }
    const std::vector<double> slope = local_slope(time, value, 0.1);
    for (std::size_t i = 5; i < 96; ++i) {
        EXPECT_NEAR(slope[i], 2.0 * time[i], 1e-10);
    }
    EXPECT_NEAR(slope[0], 0.05, 1e-10);
}

}  // namespace tiretherm::physics
