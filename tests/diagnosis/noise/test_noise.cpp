// SPDX-License-Identifier: BSD-3-Clause
// Whitening, its transpose and the log determinant against the Cholesky factor of the dense covariance matrix.

#include "diagnosis/noise/noise.hpp"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>
#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "tests/diagnosis/noise/noise_sample.hpp"

namespace tiretherm::diagnosis {
namespace {

using sample::dense_covariance;

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

/// Two runs of two channels with uneven times, a gap of half an hour and missing samples, and three single numbers.
struct Stack {
    std::vector<NoiseBlock> blocks;
    Covariance covariance;
    Eigen::Index rows = 0;
};

Stack uneven_stack() {
    std::mt19937_64 random(7);
    std::exponential_distribution<double> interval(0.4);
    Stack stack;
    stack.covariance.channels = {{.sigma = 0.5, .correlation_time = 9.5, .white_share = 0.3},
                                 {.sigma = 40.0, .correlation_time = 0.8, .white_share = 0.05}};
    for (const int channel : {0, 1, 0, 1}) {
        std::vector<double> time;
        std::vector<double> value;
        double t = 100.0 * channel;
        for (int i = 0; i < 60; ++i) {
            t += i == 30 ? 1800.0 : 0.01 + interval(random);
            time.push_back(t);
            value.push_back(i % 7 == 3 ? missing : 1.0);
        }
        stack.blocks.push_back(series_block(channel, stack.rows, time, value));
        stack.rows += stack.blocks.back().rows();
    }
    stack.blocks.push_back(numbers_block(stack.rows, {2.0, 0.1, 5.0}));
    stack.rows += 3;
    return stack;
}

TEST(Whitening, EqualsTheCholeskyFactorOfTheCovariance) {
    // V = L L' with a lower L of positive diagonal is unique, and the filter's innovations are lower triangular too:
    // whitening is L^-1. Eleven columns are one group of eight and three single ones. Condition of V: about 1e5 within
    // a block (samples 0.01 s apart under a correlation time of 9.5 s and 30 % white), so round-off stays below 1e-12
    // of values of order ten.
    const Stack stack = uneven_stack();
    const Eigen::MatrixXd values = sample::normal(stack.rows, 11, 3);
    Eigen::MatrixXd filtered = values;
    whiten(stack.blocks, stack.covariance, filtered);
    const Eigen::MatrixXd V = dense_covariance(stack.blocks, stack.covariance.channels, stack.rows);
    const Eigen::MatrixXd expected = V.llt().matrixL().solve(values);
    EXPECT_LT((filtered - expected).cwiseAbs().maxCoeff(), 1e-12);
    EXPECT_GT(expected.cwiseAbs().maxCoeff(), 5.0);
}

TEST(Whitening, LogDeterminantIsThatOfTheCovariance) {
    const Stack stack = uneven_stack();
    const Eigen::MatrixXd V = dense_covariance(stack.blocks, stack.covariance.channels, stack.rows);
    const double expected = 2.0 * Eigen::MatrixXd(V.llt().matrixL()).diagonal().array().log().sum();
    EXPECT_NEAR(log_determinant(stack.blocks, stack.covariance), expected, 1e-11 * std::abs(expected));
}

TEST(Whitening, HoldsWithoutAnyWhiteNoise) {
    // A purely Markovian channel: V is well conditioned for samples two correlation times apart.
    const NoiseBlock block = series_block(0, 0, std::vector<double>{0, 2, 4, 5, 9}, std::vector<double>{1, 1, 1, 1, 1});
    const Covariance covariance{.channels = {{.sigma = 2.0, .correlation_time = 1.0, .white_share = 0.0}},
                                .weight = {}};
    const Eigen::MatrixXd V = dense_covariance({block}, covariance.channels, 5);
    Eigen::MatrixXd values = sample::normal(5, 2, 5);
    const Eigen::MatrixXd expected = V.llt().matrixL().solve(values);
    whiten({&block, 1}, covariance, values);
    EXPECT_LT((values - expected).cwiseAbs().maxCoeff(), 1e-14);
}

TEST(Whitening, AMissingSampleIsALongerInterval) {
    // Rows of the samples that are there have the covariance of the full log's same rows; a missing sample leaves none.
    const std::vector<double> time{0, 1, 2, 3, 4};
    const NoiseBlock block = series_block(0, 0, time, std::vector<double>{1, missing, 2, missing, 3});
    EXPECT_EQ(block.time, (std::vector<double>{0, 2, 4}));
    EXPECT_EQ(block.sample, (std::vector<std::size_t>{0, 2, 4}));
    EXPECT_EQ(block.rows(), 3);
}

TEST(Whitening, AWeightInflatesTheInnovationOfItsSample) {
    // The second of three samples with weight w: V + D with D only at that sample, D = F2 (1/w - 1) and F2 = l22^2 its
    // innovation's variance; all of it times 0.8214 = 2 Phi(1.345) - 1.
    const NoiseBlock block = series_block(0, 0, std::vector<double>{0, 1, 2}, std::vector<double>{1, 1, 1});
    Covariance covariance{.channels = {{.sigma = 1.5, .correlation_time = 3.0, .white_share = 0.4}}, .weight = {}};
    Eigen::MatrixXd V = dense_covariance({block}, covariance.channels, 3);
    const Eigen::MatrixXd L = V.llt().matrixL();
    const double w = 0.2;
    V(1, 1) += L(1, 1) * L(1, 1) * (1.0 / w - 1.0);
    V *= 0.8213748;
    Eigen::MatrixXd values = sample::normal(3, 1, 11);
    const Eigen::MatrixXd expected = V.llt().matrixL().solve(values);
    covariance.weight = Eigen::Vector3d(1.0, w, 1.0);
    whiten({&block, 1}, covariance, values);
    EXPECT_LT((values - expected).cwiseAbs().maxCoeff(), 1e-6);
    EXPECT_NEAR(log_determinant({&block, 1}, covariance), std::log(V.determinant()), 1e-6);
}

TEST(Whitening, CorrelationOverASecond) {
    // exp(-1 / 9.491) = 0.9, and 0 where nothing is correlated.
    EXPECT_NEAR((Noise{.sigma = 1.0, .correlation_time = -1.0 / std::log(0.9), .white_share = 0.3}).rho_1s(), 0.9,
                1e-15);
    EXPECT_EQ((Noise{.sigma = 1.0}).rho_1s(), 0.0);
}

}  // namespace
// (W u, v) = (u, W' v) for W = V^-1/2: over uneven samples of two channels, correlated and white, with weights, and over
// single numbers, to round-off of 400 products of order one.
TEST(Noise, TheTransposedFilterIsTheTransposedMatrix) {
    std::vector<double> time;
    for (int i = 0; i < 150; ++i) {
        time.push_back(2.0 * i + (i % 7 == 0 ? 0.7 : 0.0));
    }
    const std::vector<double> value(time.size(), 0.0);
    const std::vector<NoiseBlock> blocks{series_block(0, 0, time, value), series_block(1, 150, time, value),
                                         numbers_block(300, {0.5, 2.0})};
    Covariance covariance;
    covariance.channels = {{.sigma = 0.5, .correlation_time = 9.5, .white_share = 0.3}, {.sigma = 0.3}};
    covariance.weight = Eigen::VectorXd::LinSpaced(302, 0.4, 1.0);
    const Eigen::MatrixXd u = Eigen::VectorXd::LinSpaced(302, -1.0, 3.0).array().sin().matrix();
    const Eigen::MatrixXd v = Eigen::VectorXd::LinSpaced(302, 5.0, 40.0).array().cos().matrix();
    Eigen::MatrixXd Wu = u;
    whiten(blocks, covariance, Wu);
    Eigen::MatrixXd Wv = v;
    whiten_transposed(blocks, covariance, Wv);
    const double size = Wu.norm() * v.norm();
    EXPECT_NEAR(Wu.col(0).dot(v.col(0)), u.col(0).dot(Wv.col(0)), 1e-14 * size);
    EXPECT_GT(std::abs(Wu.col(0).dot(v.col(0))), 1e-3 * size);
}

}  // namespace tiretherm::diagnosis
