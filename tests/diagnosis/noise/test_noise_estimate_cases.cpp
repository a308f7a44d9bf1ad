// SPDX-License-Identifier: BSD-3-Clause
// The noise's estimate where the data are special: several runs, other units and intervals, columns that others make up,
// too few samples, outliers.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/diagnosis/noise/noise_data.hpp"

namespace tiretherm::diagnosis {
namespace {

using sample::camera;
using sample::clock;
using sample::Data;
using sample::draw;
using sample::one_series;
using sample::probe;
using sample::white;

TEST(NoiseEstimate, RunsShareTheirChannelsNoise) {
    // Four runs of two channels. The four together leave half the uncertainty that one leaves, sqrt(1 / 4), to a third
    // of that, for the deviations are themselves estimates.
    Data all;
    Data one;
    const std::vector<double> time = clock(600, 2.0);
    for (std::uint64_t run = 0; run < 4; ++run) {
        for (const int channel : {0, 1}) {
            const std::vector<double> e =
                draw(channel == 0 ? camera : probe, time, 10 * run + static_cast<std::uint64_t>(channel) + 1);
            all.add(channel, time, e);
            if (run == 0) {
                one.add(channel, time, e);
            }
        }
    }
    all.span_cosines(6);
    one.span_cosines(6);
    const NoiseEstimate four = all.estimate();
    const NoiseEstimate single = one.estimate();
    for (const std::size_t c : {0u, 1u}) {
        const Noise& truth = c == 0 ? camera : probe;
        EXPECT_NEAR(four.covariance.channels[c].sigma, truth.sigma, 3.0 * four.channels[c].sigma_deviation);
        EXPECT_NEAR(four.covariance.channels[c].rho_1s(), truth.rho_1s(), 3.0 * four.channels[c].rho_1s_deviation);
        EXPECT_NEAR(four.channels[c].sigma_deviation / single.channels[c].sigma_deviation, 0.5, 0.17);
        EXPECT_EQ(four.channels[c].samples, 2400);
    }
}

TEST(NoiseEstimate, UnitsDoNotMatter) {
    // A channel in mK, a run's clock in ms and columns per other units of their parameters: sigma is a thousand times
    // larger, the correlation time too, the white share the same.
    const Data data = one_series(camera, 600, 2.0, 5, 9);
    Data scaled = data;
    scaled.residual *= 1e3;
    scaled.span *= 1e3;
    for (double& t : scaled.blocks[0].time) {
        t *= 1e3;
    }
    for (Eigen::Index j = 0; j < 5; ++j) {
        scaled.span.col(j) *= std::pow(10.0, 3 * static_cast<double>(j) - 6.0);
    }
    const Noise a = data.estimate().covariance.channels[0];
    const Noise b = scaled.estimate().covariance.channels[0];
    EXPECT_NEAR(b.sigma / a.sigma, 1e3, 1e-3);
    EXPECT_NEAR(b.correlation_time / a.correlation_time, 1e3, 1e-3);
    EXPECT_NEAR(b.white_share, a.white_share, 1e-6);
}

TEST(NoiseEstimate, EverySecondSampleTellsTheSame) {
    // 10 Hz logging of noise that forgets itself over 9.5 s. White noise is per sample, so that its share stays.
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        const std::vector<double> time = clock(12000, 0.1);
        const std::vector<double> value = draw(camera, time, seed);
        Data all;
        all.add(0, time, value);
        all.span_cosines(5);
        Data half;
        std::vector<double> half_time;
        std::vector<double> half_value;
        for (std::size_t i = 0; i < time.size(); i += 2) {
            half_time.push_back(time[i]);
            half_value.push_back(value[i]);
        }
        half.add(0, half_time, half_value);
        half.span_cosines(5);
        const NoiseEstimate a = all.estimate();
        const NoiseEstimate b = half.estimate();
        EXPECT_NEAR(a.covariance.channels[0].sigma, b.covariance.channels[0].sigma, a.channels[0].sigma_deviation);
        EXPECT_NEAR(a.covariance.channels[0].rho_1s(), b.covariance.channels[0].rho_1s(),
                    a.channels[0].rho_1s_deviation);
    }
}

TEST(NoiseEstimate, AColumnThatOthersMakeUpIsLeftOut) {
    // Column 2 is a combination of columns 0 and 1, column 3 is nothing at all; both without a prior. With a prior
    // they may stay: X'V^-1X + Pi is then regular. What is left out changes nothing.
    Data data = one_series(camera, 300, 2.0, 2, 4);
    const Noise before = data.estimate().covariance.channels[0];
    data.span.conservativeResize(Eigen::NoChange, 4);
    data.span.col(2) = 2.0 * data.span.col(0) - 1e3 * data.span.col(1);
    data.span.col(3).setZero();
    data.precision = Eigen::VectorXd::Zero(4);
    const NoiseEstimate found = data.estimate();
    EXPECT_EQ(found.left_out, (std::vector<Eigen::Index>{2, 3}));
    EXPECT_NEAR(found.covariance.channels[0].sigma, before.sigma, 1e-9);
    data.precision << 0.0, 0.0, 1.0, 1.0;
    const NoiseEstimate known = data.estimate();
    EXPECT_TRUE(known.left_out.empty());
    EXPECT_TRUE(std::isfinite(known.criterion));
    // The search ends where a thousandth of -2 log likelihood is left, 0.03 deviations of sigma: 0.001 K.
    EXPECT_NEAR(known.covariance.channels[0].sigma, before.sigma, 1e-3);
}

TEST(NoiseEstimate, TheDataSheetSpeaksWhereSamplesDoNot) {
    // Nine samples; a residual of exact zeros; a span with a column for every sample: nothing to estimate from.
    Data few = one_series(camera, 9, 2.0, 1, 1);
    few.data_sheet = {0.7};
    Data nothing = one_series(camera, 50, 2.0, 1, 1);
    nothing.residual.setZero();
    nothing.data_sheet = {0.7};
    Data full = one_series(camera, 12, 2.0, 12, 1);
    full.data_sheet = {0.7};
    for (const Data& data : {few, nothing, full}) {
        const NoiseEstimate found = data.estimate();
        EXPECT_EQ(found.channels[0].source, NoiseSource::data_sheet);
        EXPECT_EQ(found.covariance.channels[0].sigma, 0.7);
        EXPECT_EQ(found.covariance.channels[0].rho_1s(), 0.0);
        EXPECT_TRUE(std::isfinite(found.criterion));
    }
    few.data_sheet = {0.0};
    const NoiseEstimate found = few.estimate();
    EXPECT_EQ(found.channels[0].source, NoiseSource::assumed);
    EXPECT_EQ(found.covariance.channels[0].sigma, 1.0);
    EXPECT_EQ(cautions("bulk", "K", found.covariance.channels[0], found.channels[0], 0.0, {}).size(), 1u);
}

TEST(NoiseEstimate, AChannelWithoutAnySampleIsNoHindrance) {
    Data data = one_series(camera, 300, 2.0, 2, 4);
    const Noise alone = data.estimate().covariance.channels[0];
    data.data_sheet = {0.0, 0.3};
    const NoiseEstimate found = data.estimate();
    EXPECT_EQ(found.covariance.channels[0].sigma, alone.sigma);
    EXPECT_EQ(found.covariance.channels[1].sigma, 0.3);
    EXPECT_EQ(found.channels[1].samples, 0);
}

TEST(NoiseEstimate, OutliersCountLess) {
    // Five samples of a hundred are off by ten standard deviations, which adds 0.05 * 25 K^2 to a variance of 0.25 K^2:
    // 1.22 K. Huber's sigma is s times 0.5 K where 0.95 (2 Phi(1.345 s) - 1) / s^2 + 0.05 * 1.345 * 10 / s = 0.8214, the
    // mean of w v^2: s = 1.54. An outlier of 10 +- 3 deviations then weighs less than 1.345 * 1.54 / 7 = 0.30.
    Data data = one_series(white, 1000, 2.0, 3, 6);
    for (Eigen::Index i = 7; i < 1000; i += 20) {
        data.residual[i] += i % 40 == 7 ? 5.0 : -5.0;
    }
    const double plain = data.estimate().covariance.channels[0].sigma;
    data.robust = true;
    const NoiseEstimate found = data.estimate();
    EXPECT_NEAR(plain, 1.22, 0.05);
    EXPECT_NEAR(found.covariance.channels[0].sigma, 0.77, 0.05);  // three deviations of 0.77 / sqrt(2 * 1000)
    for (Eigen::Index i = 7; i < 1000; i += 20) {
        EXPECT_LT(found.covariance.weight[i], 0.30);
    }
}

TEST(NoiseEstimate, WeightsLeaveOrdinaryNoiseAsItIs) {
    // Without an outlier sigma stays what it is, to three deviations. Scores of a column stay standard normal or a
    // little narrower: their variance is E[w^2 v^2] / (E[w v^2] E[w]) = 0.710 / (0.821 * 0.957) = 0.90 (deviation 0.95).
    std::vector<double> score;
    double sigma = 0.0;
    double spread = 0.0;
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        Data data = one_series(white, 400, 2.0, 1, seed);
        data.robust = true;
        const NoiseEstimate found = data.estimate();
        sigma += std::log(found.covariance.channels[0].sigma / 0.5) / 100.0;
        spread = 1.0 / std::sqrt(2.0 * 399.0);
        Eigen::MatrixXd rows(400, 2);
        rows << sample::normal(400, 1, seed + 1000), data.residual;
        whiten(data.blocks, found.covariance, rows);
        score.push_back(rows.col(0).dot(rows.col(1)) / rows.col(0).norm());
    }
    const Eigen::Map<const Eigen::ArrayXd> z(score.data(), 100);
    EXPECT_NEAR(std::sqrt(z.square().mean()), 0.95, 3.0 * 0.95 / std::sqrt(200.0));
    EXPECT_LT(std::abs(sigma), 3.0 * spread / std::sqrt(100.0) * 1.1);  // 95 % efficient and less in its scale
}

TEST(NoiseEstimate, CautionWhereNoiseEatsPhysics) {
    // 1.6 K are 3.2 times 0.5 K; 50 s are within a factor of two of the tire's 80 s; 119.9 s reach the 120 s allowed.
    const ChannelNoise found{.samples = 600, .longest_correlation = 120.0};
    const Noise fine{.sigma = 0.6, .correlation_time = 9.5, .white_share = 0.3};
    EXPECT_TRUE(cautions("bulk", "K", fine, found, 0.5, {80.0, 600.0}).empty());
    EXPECT_EQ(
        cautions("bulk", "K", {.sigma = 1.6, .correlation_time = 50.0, .white_share = 0.3}, found, 0.5, {80.0, 600.0}),
        (Remarks{remark::noise_above_data_sheet("bulk", 1.6, "K", 3.2, 0.5),
                 remark::noise_as_slow_as_tire("bulk", Seconds(50.0), Seconds(80.0))}));
    EXPECT_EQ(cautions("bulk", "K", {.sigma = 0.5, .correlation_time = 119.9, .white_share = 0.3}, found, 0.0, {}),
              (Remarks{remark::noise_as_slow_as_allowed("bulk", Seconds(120.0))}));
}

}  // namespace
}  // namespace tiretherm::diagnosis
