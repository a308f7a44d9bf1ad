// SPDX-License-Identifier: BSD-3-Clause
// The noise's estimate against dense algebra, and over many made-up samples: right within its own uncertainty.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <Eigen/Cholesky>
#include <Eigen/LU>

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

/// Largest distance between the shares of a sample below each of its values and those of a standard normal, times the
/// root of its size: above 1.63 in one of a hundred samples (Kolmogorov).
double kolmogorov(std::vector<double> z) {
    std::sort(z.begin(), z.end());
    const auto n = static_cast<double>(z.size());
    double distance = 0.0;
    for (std::size_t i = 0; i < z.size(); ++i) {
        const double expected = 0.5 * std::erfc(-z[i] / std::numbers::sqrt2);
        distance =
            std::max({distance, expected - static_cast<double>(i) / n, static_cast<double>(i + 1) / n - expected});
    }
    return distance * std::sqrt(n);
}

TEST(NoiseEstimate, TheCriterionIsTheOneItStates) {
    // log |V| + log |X'V^-1X + Pi| + r'P r with dense matrices, in the columns' own scale: the estimate's criterion is
    // that less 2 sum log(length of column j), (length^2 = |X_j|^2 + Pi_j), for it divides the columns by their lengths.
    Data data;
    data.add(0, clock(50, 1.0), draw(camera, clock(50, 1.0), 1));
    data.add(1, clock(40, 2.0), draw(probe, clock(40, 2.0), 2));
    data.residual.conservativeResize(92);
    data.residual.tail(2) << 0.4, -1.0;
    data.blocks.push_back(numbers_block(90, {0.5, 2.0}));
    data.span = sample::normal(92, 4, 3);
    data.precision = Eigen::Vector4d(0.0, 0.0, 30.0, 1.0);
    const NoiseEstimate found = data.estimate();
    const Eigen::MatrixXd V = sample::dense_covariance(data.blocks, found.covariance.channels, 92);
    const Eigen::MatrixXd VX = V.llt().solve(data.span);
    const Eigen::VectorXd Vr = V.llt().solve(data.residual);
    const Eigen::MatrixXd A = data.span.transpose() * VX + Eigen::MatrixXd(data.precision.asDiagonal());
    const Eigen::VectorXd g = VX.transpose() * data.residual;
    double expected = 2.0 * Eigen::MatrixXd(V.llt().matrixL()).diagonal().array().log().sum() +
                      std::log(A.determinant()) + data.residual.dot(Vr) - g.dot(A.llt().solve(g));
    for (Eigen::Index j = 0; j < 4; ++j) {
        expected -= std::log(data.span.col(j).squaredNorm() + data.precision[j]);
    }
    EXPECT_NEAR(found.criterion, expected, 1e-9 * std::abs(expected));
}

TEST(NoiseEstimate, NoOtherNoiseNearbyIsMoreLikely) {
    // Against the dense criterion of the test above, at steps of a tenth of what 200 samples leave uncertain.
    const Data data = one_series(camera, 200, 2.0, 3, 5);
    const Noise best = data.estimate().covariance.channels[0];
    const auto criterion = [&](const Noise& noise) {
        const Eigen::MatrixXd V = sample::dense_covariance(data.blocks, {noise}, 200);
        const Eigen::LLT<Eigen::MatrixXd> factor(V);
        const Eigen::MatrixXd VX = factor.solve(data.span);
        const Eigen::MatrixXd A = data.span.transpose() * VX;
        const Eigen::VectorXd g = VX.transpose() * data.residual;
        return 2.0 * Eigen::MatrixXd(factor.matrixL()).diagonal().array().log().sum() + std::log(A.determinant()) +
               data.residual.dot(factor.solve(data.residual)) - g.dot(A.llt().solve(g));
    };
    const double lowest = criterion(best);
    for (const double sign : {-1.0, 1.0}) {
        Noise other = best;
        other.sigma *= 1.0 + 0.02 * sign;
        EXPECT_GT(criterion(other), lowest);
        other = best;
        other.correlation_time *= 1.0 + 0.04 * sign;
        EXPECT_GT(criterion(other), lowest);
        other = best;
        other.white_share += 0.01 * sign;
        EXPECT_GT(criterion(other), lowest);
    }
}

TEST(NoiseEstimate, IsRightWithinItsOwnUncertainty) {
    // 200 seeds of 20 minutes at 1 Hz, ten columns. A standardised error has mean 0, to 3 / sqrt(200) = 0.21, lies within
    // 1.96 in 95 % of the seeds, to 3 sqrt(0.05 0.95 / 200) = 4.6 %, and is normal. sigma and rho are taken in the
    // measures in which their likelihood is nearly normal, log sigma and log tau = -log(-log rho).
    std::vector<double> sigma;
    std::vector<double> rho;
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        const NoiseEstimate found = one_series(camera, 1200, 1.0, 10, seed).estimate();
        const Noise& noise = found.covariance.channels[0];
        sigma.push_back(std::log(noise.sigma / camera.sigma) / (found.channels[0].sigma_deviation / noise.sigma));
        const double log_time_deviation = found.channels[0].rho_1s_deviation * noise.correlation_time / noise.rho_1s();
        rho.push_back(std::log(noise.correlation_time / camera.correlation_time) / log_time_deviation);
    }
    for (const std::vector<double>& z : {sigma, rho}) {
        const Eigen::Map<const Eigen::ArrayXd> values(z.data(), 200);
        EXPECT_LT(std::abs(values.mean()), 0.21);
        EXPECT_NEAR(static_cast<double>((values.abs() < 1.96).count()) / 200.0, 0.95, 0.046);
        EXPECT_LT(kolmogorov(z), 1.63);
    }
}

TEST(NoiseEstimate, FortyColumnsDoNotDeflateIt) {
    // White noise, 200 samples, 40 columns: the fit takes 40 of 200 squares. Maximum likelihood divides the rest by 200
    // and finds sigma^2 0.8 times too small; restricted likelihood divides by 160. Both are means over 200 seeds of a
    // variance with 160 degrees of freedom: uncertain to sqrt(2 / 160 / 200) = 0.0079 of itself, here three times that.
    double restricted = 0.0;
    double maximum_likelihood = 0.0;
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        Data data = one_series(white, 200, 1.0, 40, seed);
        data.model = NoiseModel::white;
        const NoiseEstimate found = data.estimate();
        restricted += found.covariance.channels[0].sigma * found.covariance.channels[0].sigma / 0.25 / 200.0;
        EXPECT_NEAR(found.channels[0].freedom, 160.0, 1e-6);
        const Eigen::VectorXd b =
            (data.span.transpose() * data.span).llt().solve(data.span.transpose() * data.residual);
        maximum_likelihood += (data.residual - data.span * b).squaredNorm() / 200.0 / 0.25 / 200.0;
    }
    EXPECT_NEAR(restricted, 1.0, 0.024);
    EXPECT_NEAR(maximum_likelihood, 0.8, 0.019);
}

TEST(NoiseEstimate, FortySlowColumnsDoNotDeflateSlowNoise) {
    // Correlated noise of 4 s loses more to slow columns: forty cosines over 1600 s take all frequencies f below 1 / 80 s,
    // hence 2 / pi atan(2 pi 4 s f) = 0.19 of its correlated variance (0.7) and 40 / 800 of the white, together 0.15: the
    // rms of a fitted residual is exp(-0.082) times sigma, to sqrt(1 / (2 * 300)) / 10 for some 300 independent samples
    // in each of 100 seeds, three times. The standardised mean of restricted sigmas is 0 to 3 / sqrt(100).
    double z = 0.0;
    double fitted = 0.0;
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        const Data data = one_series({.sigma = 0.5, .correlation_time = 4.0, .white_share = 0.3}, 800, 2.0, 40, seed);
        const NoiseEstimate found = data.estimate();
        z += (found.covariance.channels[0].sigma - 0.5) / found.channels[0].sigma_deviation / 100.0;
        const Eigen::VectorXd b =
            (data.span.transpose() * data.span).llt().solve(data.span.transpose() * data.residual);
        fitted += std::log((data.residual - data.span * b).norm() / std::sqrt(800.0) / 0.5) / 100.0;
    }
    EXPECT_LT(std::abs(z), 0.3);
    EXPECT_NEAR(fitted, -0.082, 0.013);
}

TEST(NoiseEstimate, AnEffectInTheSpanCannotInflateIt) {
    // A column without a prior may have any factor: adding it to the residual changes nothing. Left out of the span it
    // does: 3 K of the slowest cosine have an rms of 2.1 K beside a noise of 0.5 K.
    Data data = one_series(camera, 600, 2.0, 5, 1);
    const Noise before = data.estimate().covariance.channels[0];
    data.residual += 3.0 * data.span.col(1);
    const Noise after = data.estimate().covariance.channels[0];
    EXPECT_NEAR(after.sigma, before.sigma, 1e-6);
    EXPECT_NEAR(after.rho_1s(), before.rho_1s(), 1e-6);
    data.span.conservativeResize(Eigen::NoChange, 1);
    data.precision.conservativeResize(1);
    const Noise outside = data.estimate().covariance.channels[0];
    EXPECT_GT(outside.sigma, 2.0 * before.sigma);
}

TEST(NoiseEstimate, APriorHoldsAColumnBack) {
    // With a prior deviation of 1e-6 the column explains nothing and its effect is noise; with 1e6 it is free.
    Data data = one_series(white, 600, 2.0, 1, 1);
    data.model = NoiseModel::white;
    data.residual += 3.0 * data.span.col(0);
    const double rms = std::sqrt(data.residual.squaredNorm() / 600.0);
    data.precision[0] = 1e12;
    EXPECT_NEAR(data.estimate().covariance.channels[0].sigma, rms, 1e-5);
    data.precision[0] = 1e-12;
    EXPECT_NEAR(data.estimate().covariance.channels[0].sigma, 0.5, 0.05);  // three times 0.5 / sqrt(2 * 599)
}

TEST(NoiseEstimate, WhiteNoiseIsFoundToBeWhite) {
    // Correlation gains more than 4 in at most 4 of 100 white series: at most 10 of 100 in 99.8 % of all draws of the seeds.
    int correlated = 0;
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        const Noise noise = one_series(white, 400, 2.0, 10, seed).estimate().covariance.channels[0];
        correlated += noise.correlation_time > 0.0 ? 1 : 0;
        EXPECT_EQ(noise.rho_1s() == 0.0, noise.white_share == 1.0);
    }
    EXPECT_LE(correlated, 10);
}

}  // namespace
}  // namespace tiretherm::diagnosis
