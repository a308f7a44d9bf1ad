// SPDX-License-Identifier: BSD-3-Clause
// Statistics of correlated samples against values by hand and against their scatter and coverage over many simulated
// series.

#include "diagnosis/compare/comparison_statistics.hpp"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace tiretherm::diagnosis {
namespace {

/// Noise that keeps `rho` of itself from sample to sample, of unit variance.
std::vector<double> persistent(std::size_t n, double rho, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    std::vector<double> values{normal(random)};
    while (values.size() < n) {
        values.push_back(rho * values.back() + std::sqrt(1.0 - rho * rho) * normal(random));
    }
    return values;
}

TEST(ComparisonFigures, OfFiveDifferencesInTwoRuns) {
    // 1, 2, 3 and -1, 5: mean 10/5 = 2; squares 1 + 4 + 9 + 1 + 25 = 40, rms sqrt(8); about the mean 1 + 0 + 1 + 9 + 9 = 20,
    // scatter sqrt(20/4).
    const Figures f = figures({{1.0, 2.0, 3.0}, {-1.0, 5.0}});
    EXPECT_EQ(f.samples, 5u);
    EXPECT_DOUBLE_EQ(f.bias, 2.0);
    EXPECT_DOUBLE_EQ(f.rmse, std::sqrt(8.0));
    EXPECT_DOUBLE_EQ(f.scatter, std::sqrt(5.0));
    // Lag 1 within the runs: (-1)(0) + (0)(1) + (-3)(3) = -9, of 20: the first pair of lags is 1 - 0.45, the second (lag 2:
    // (-1)(1) = -1) is negative. 1 + 2 * (1 - 0.45 - 1) = 0.1 is less than one sample for one: 5 independent.
    EXPECT_DOUBLE_EQ(f.independent, 5.0);
    EXPECT_DOUBLE_EQ(f.bias_deviation, 1.0);
}

TEST(ComparisonFigures, OfOneSampleAndOfNone) {
    const Figures one = figures({{-3.0}});
    EXPECT_EQ(one.bias, -3.0);
    EXPECT_EQ(one.rmse, 3.0);
    EXPECT_EQ(one.scatter, 0.0);
    EXPECT_TRUE(std::isinf(one.bias_deviation));
    EXPECT_EQ(figures({}).samples, 0u);
    EXPECT_EQ(figures({{}, {}}).samples, 0u);
}

TEST(ComparisonFigures, ABiasIsAsUncertainAsItsIndependentSamplesLeaveIt) {
    // rho = 0.9: (1 + 0.9) / (1 - 0.9) = 19 samples for one, hence sqrt(19 / 2000) = 0.0975 for 2 000 of unit variance.
    // Over 200 seeds the bias itself scatters by that, to 1 / sqrt(400) = 5 % (three times 15 %), and lies within 1.96 of
    // the deviation found in 95 %, to three times 1.5 %; white noise taken for granted would hold it in 35 %.
    double squares = 0.0;
    double samples = 0.0;
    int within = 0;
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        const Figures f = figures({persistent(1000, 0.9, seed), persistent(1000, 0.9, seed + 1000)});
        squares += f.bias * f.bias / 200.0;
        samples += 2000.0 / f.independent / 200.0;
        within += std::abs(f.bias) < 1.96 * f.bias_deviation ? 1 : 0;
    }
    EXPECT_NEAR(std::sqrt(squares), 0.0975, 0.15 * 0.0975);
    EXPECT_NEAR(samples, 19.0, 2.0);  // a finite series, less its own mean, shows a little less
    EXPECT_NEAR(within / 200.0, 0.95, 0.045);
}

TEST(ComparisonFigures, LoggingTenTimesAsOftenAddsNothing) {
    // The same slow differences, every sample held ten times: rho per sample 0.9, groups of ten or not.
    const std::vector<double> slow = persistent(3000, 0.9, 5);
    std::vector<double> held;
    for (const double value : slow) {
        held.insert(held.end(), 10, value);
    }
    const Figures f = figures({slow});
    const Figures g = figures({held});
    EXPECT_EQ(g.samples, 30000u);
    EXPECT_NEAR(g.bias, f.bias, 1e-12);
    EXPECT_NEAR(g.bias_deviation, f.bias_deviation, 0.1 * f.bias_deviation);  // groups of 3 and of 30
}

TEST(ComparisonFigures, DifferencesThatKeepTheirSignForAWholeRunAreFewSamples) {
    // Four runs, each off by its own constant: the mean of four numbers, whatever the number of samples. Autocorrelations
    // of a constant piece of 500 fall as 1 - k/500: 2 * 250 = 500 samples for one.
    Pieces pieces;
    for (const double off : {1.0, -2.0, 3.0, -2.0}) {
        pieces.emplace_back(500, off);
    }
    EXPECT_NEAR(figures(pieces).independent, 4.0, 0.05);
}

TEST(ComparisonNoise, IsWhatLeavesTheLineBetweenNeighbours) {
    // 0, 0, 3, 0 at 0, 1, 2, 4 s. Middle at 1 s: line 1.5, off -1.5, weights 1 + 1/4 + 1/4 = 1.5: 2.25 / 1.5 = 1.5. Middle at
    // 2 s: neighbours 0 and 0, off 3, shares 2/3 and 1/3: 1 + 5/9, 9 / (14/9) = 5.786. Mean 3.643.
    EXPECT_NEAR(sample_to_sample_noise({{0, 1, 2, 4}}, {{0, 0, 3, 0}}), std::sqrt(0.5 * (1.5 + 81.0 / 14.0)), 1e-14);
    // A ramp of uneven steps has none.
    EXPECT_NEAR(sample_to_sample_noise({{0, 1, 5, 6}}, {{0, 2, 10, 12}}), 0.0, 1e-14);
    EXPECT_TRUE(std::isnan(sample_to_sample_noise({{0, 1}, {0, 1}}, {{3, 4}, {5, 6}})));
}

TEST(ComparisonNoise, OfWhiteNoiseIsItsStandardDeviation) {
    // Mean of squares of second differences: relative variance 2 (1 + 2 (4/6)^2 + 2 (1/6)^2) / n = 3.9 / n; three times.
    const std::vector<double> e = persistent(10000, 0.0, 3);
    std::vector<double> time(e.size());
    for (std::size_t i = 0; i < e.size(); ++i) {
        time[i] = static_cast<double>(i);
    }
    EXPECT_NEAR(sample_to_sample_noise({time}, {e}), 1.0, 3.0 * 0.5 * std::sqrt(3.9 / 10000.0));
}

TEST(ModelUncertainty, WhatIsLeftOnceTheSensorIsRemoved) {
    // Scatter 0.5, rms 1.3, sensor 0.4: sqrt(0.25 - 0.16) = 0.3 and sqrt(1.69 - 0.16) = 1.2369.
    const ModelUncertainty found =
        model_uncertainty({.samples = 9, .bias = 1.2, .rmse = 1.3, .scatter = 0.5}, {}, {}, 0.4);
    EXPECT_NEAR(found.scatter, 0.3, 1e-15);
    EXPECT_NEAR(found.removable, std::sqrt(1.53), 1e-15);
    EXPECT_FALSE(found.below_sensor);
    EXPECT_EQ(found.compared, 0u);
}

TEST(ModelUncertainty, ScatterBelowTheSensorIsSaidAndNotNegative) {
    const ModelUncertainty found =
        model_uncertainty({.samples = 9, .bias = 0.0, .rmse = 0.2, .scatter = 0.2}, {}, {}, 0.4);
    EXPECT_TRUE(found.below_sensor);
    EXPECT_EQ(found.scatter, 0.0);
    EXPECT_EQ(found.removable, 0.0);
}

TEST(ModelUncertainty, FactorAndRelativeScatterOfTheRise) {
    // Simulated 1.2 and 0.9 times a measured 100 (sensor 2: 0.02 of it): x = ln 1.2 = 0.182322 and ln 0.9 = -0.105361, mean
    // 0.038480, variance 0.041381 (one degree of freedom): relative^2 = 0.041381 - 0.0004 = 0.040981, factor
    // exp(0.038480 + 0.0204905 - 0.0002) = 1.060533. A rise of 15 is below ten sensors, one of -5 is none.
    const std::vector<double> measured{100.0, 100.0, 15.0, -5.0};
    const std::vector<double> simulated{120.0, 90.0, 60.0, 5.0};
    const ModelUncertainty found =
        model_uncertainty({.samples = 4, .rmse = 9.0, .scatter = 9.0}, measured, simulated, 2.0);
    EXPECT_EQ(found.compared, 2u);
    EXPECT_NEAR(found.relative, std::sqrt(0.040981), 1e-5);
    EXPECT_NEAR(found.factor, 1.060533, 1e-5);
}

TEST(ModelUncertainty, RecoversAFactorThroughTheNoiseOfTheSensor) {
    // True rises 20 to 60 K, simulated 1.1 times with 3 % of its own, measured with 0.5 K: 20 000 samples leave 1.1 uncertain by
    // 0.0003 and 3 % by sqrt(0.5 / n) (0.033^2 / 0.03) = 0.0002; the logarithm's own third order is below that.
    std::mt19937_64 random(8);
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> rise(20.0, 60.0);
    std::vector<double> measured;
    std::vector<double> simulated;
    Pieces differences(1);
    for (int i = 0; i < 20000; ++i) {
        const double truth = rise(random);
        simulated.push_back(1.1 * truth * (1.0 + 0.03 * normal(random)));
        measured.push_back(truth + 0.5 * normal(random));
        differences[0].push_back(simulated.back() - measured.back());
    }
    const ModelUncertainty found = model_uncertainty(figures(differences), measured, simulated, 0.5);
    EXPECT_NEAR(found.factor, 1.1, 0.001);
    EXPECT_NEAR(found.relative, 0.03, 0.0008);
}

TEST(ComparisonBins, AreFifthsOfTheSamples) {
    // Ten samples, regressor 0 ... 9 in some order, difference = twice the regressor: means 1, 5, 9, 13, 17.
    const std::vector<Bin> found =
        bins({{9, 0, 4, 5, 1}, {2, 3, 8, 7, 6}}, {{18, 0, 8, 10, 2}, {4, 6, 16, 14, 12}}, 1.0);
    ASSERT_EQ(found.size(), 5u);
    for (std::size_t k = 0; k < 5; ++k) {
        const auto x = static_cast<double>(k);
        EXPECT_EQ(found[k].low, 2.0 * x);
        EXPECT_EQ(found[k].high, 2.0 * x + 1.0);
        EXPECT_EQ(found[k].samples, 2u);
        EXPECT_EQ(found[k].mean, 4.0 * x + 1.0);
    }
}

TEST(ComparisonBins, EqualValuesShareOne) {
    // Eight of ten at 0: fifths 1 to 4 are one bin of eight, the last holds 1 and 2.
    const std::vector<Bin> found = bins({{0, 0, 0, 0, 0, 0, 0, 0, 1, 2}}, {{1, 1, 1, 1, 1, 1, 1, 1, 4, 6}}, 1.0);
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[0].samples, 8u);
    EXPECT_EQ(found[0].mean, 1.0);
    EXPECT_EQ(found[1].low, 1.0);
    EXPECT_EQ(found[1].mean, 5.0);
}

TEST(Association, OfFourSamples) {
    // x = 0 1 2 3, d = 1 3 2 6: products about the means 3 + 0 - 0.5 + 4.5 = 7, squares 5 and 14: r = 7 / sqrt(70).
    const Association found = association({{0, 1, 2, 3}}, {{1, 3, 2, 6}});
    EXPECT_NEAR(found.correlation, 7.0 / std::sqrt(70.0), 1e-15);
    EXPECT_EQ(association({{1, 1, 1}}, {{1, 2, 3}}).correlation, 0.0);
    EXPECT_EQ(association({{0.1, 0.1, 0.1}}, {{1, 2, 3}}).correlation, 0.0);
    EXPECT_EQ(association({{1}}, {{2}}).chance, 1.0);
}

TEST(Association, OfUnrelatedSlowSignalsIsChance) {
    // Two unrelated signals of rho 0.9: 1 + 2 sum 0.81^k = 9.5 samples for one. Fisher's score is then standard normal; in
    // 200 seeds 5 % exceed 1.96, to three times 1.5 %. Taken for independent, 1 000 samples would exceed it in 52 %.
    int exceeding = 0;
    double samples = 0.0;
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        const Association found = association({persistent(1000, 0.9, seed)}, {persistent(1000, 0.9, seed + 5000)});
        exceeding += found.chance < 0.05 ? 1 : 0;
        samples += 1000.0 / found.independent / 200.0;
    }
    EXPECT_NEAR(exceeding / 200.0, 0.05, 0.045);
    EXPECT_NEAR(samples, 9.5, 1.0);
}

TEST(Association, OfARealRelationIsNot) {
    // d = x + noise of the same size and pace: r = 0.71 from about 100 independent samples, atanh(0.71) sqrt(100) = 8.7.
    const std::vector<double> x = persistent(1000, 0.9, 1);
    std::vector<double> d = persistent(1000, 0.9, 2);
    for (std::size_t i = 0; i < x.size(); ++i) {
        d[i] += x[i];
    }
    const Association found = association({x}, {d});
    EXPECT_NEAR(found.correlation, 0.71, 0.15);
    EXPECT_LT(found.chance, 1e-6);
}

}  // namespace
// A second between samples. 60 s without any are a gap of a log of 1060 s, of which a fiftieth are 21 s; 15 s are none. A car that
// cools down sampled every five minutes is sampled all the same.
TEST(Gap, IsNoSlowerLogger) {
    const auto at = [](double later) {
        std::vector<double> time;
        for (int i = 0; i <= 1000; ++i) {
            time.push_back(i + (i > 500 ? later : 0.0));
        }
        return time;
    };
    EXPECT_TRUE(is_gap(at(59.0), 501));
    EXPECT_FALSE(is_gap(at(59.0), 500));
    EXPECT_FALSE(is_gap(at(14.0), 501));
    std::vector<double> cooling = at(0.0);
    for (int i = 1; i <= 12; ++i) {
        cooling.push_back(1000.0 + 300.0 * i);
    }
    for (std::size_t i = 1; i < cooling.size(); ++i) {
        EXPECT_FALSE(is_gap(cooling, i)) << i;
    }
    EXPECT_FALSE(is_gap(std::vector{0.0, 600.0}, 1));
}

}  // namespace tiretherm::diagnosis
