// SPDX-License-Identifier: BSD-3-Clause
// Scores of signatures and their family-wise threshold, against what is known of normal numbers.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "diagnosis/detect/scores.hpp"

namespace tiretherm::diagnosis {

namespace {

constexpr double sqrt_half = 1.0 / std::numbers::sqrt2;

double normal_below(double z) { return 0.5 * std::erfc(-z * sqrt_half); }

Eigen::MatrixXd drawn(std::mt19937_64& engine, Eigen::Index rows, Eigen::Index columns) {
    std::normal_distribution<double> normal;
    return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return normal(engine); });
}

/// Largest distance between the distribution of values and the normal one.
double kolmogorov_smirnov(std::vector<double> values) {
    std::ranges::sort(values);
    const auto n = static_cast<double>(values.size());
    double most = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double p = normal_below(values[i]);
        most = std::max({most, std::abs(p - static_cast<double>(i) / n), std::abs(p - static_cast<double>(i + 1) / n)});
    }
    return most;
}

}  // namespace

// m independent signatures of either sign: P(max |z| < c) = (2 Phi(c) - 1)^m. For m = 1 and 1 in 200: c = 2.807; for
// m = 16: (1 - 0.005)^(1/16) = 1 - 3.132e-4, c = 3.604. The threshold is the 100th of 20 000 draws, whose rank scatters
// by 10: 10 % in the probability and 0.1 / c in c, that is 0.028 to 0.036; three of these are allowed.
TEST(FamilyThreshold, IsThatOfIndependentNumbers) {
    EXPECT_NEAR(family_threshold(Eigen::MatrixXd::Identity(1, 1), Eigen::VectorXi::Zero(1), 0.005), 2.807, 0.11);
    EXPECT_NEAR(family_threshold(Eigen::MatrixXd::Identity(16, 16), Eigen::VectorXi::Zero(16), 0.005), 3.604, 0.09);
}

// Sixteen times the same signature are one: 2.807. With a sign, 1 - Phi(c) = 0.005: c = 2.576.
TEST(FamilyThreshold, KnowsThatTheSameCountsOnce) {
    EXPECT_NEAR(family_threshold(Eigen::MatrixXd::Ones(16, 16), Eigen::VectorXi::Zero(16), 0.005), 2.807, 0.11);
    EXPECT_NEAR(family_threshold(Eigen::MatrixXd::Ones(16, 16), Eigen::VectorXi::Ones(16), 0.005), 2.576, 0.12);
}

// Two independent numbers together gain half a chi-square of two degrees of freedom, which is exponential: exceeded by 1 in
// 200 beyond ln 200 = 5.298. Only one of four draws has both signs positive: ln 50 = 3.912. Only the best of three such pairs
// that share nothing, 1 - (1 - e^-g)^3 = 0.005: g = 6.395. The 100th of 20 000 draws scatters by 10 % in the
// probability, 0.1 in the gain; three of these are allowed.
TEST(PairThreshold, IsThatOfIndependentNumbers) {
    const auto independent = [](Eigen::Index n, int sign, const std::vector<Pair>& pairs) {
        return pair_threshold(Eigen::MatrixXd::Identity(n, n), Eigen::VectorXi::Constant(n, sign), pairs, 0.005);
    };
    EXPECT_NEAR(independent(2, 0, {{0, 1}}), 5.298, 0.3);
    EXPECT_NEAR(independent(2, 1, {{0, 1}}), 3.912, 0.3);
    EXPECT_NEAR(independent(6, 0, {{0, 1}, {2, 3}, {4, 5}}), 6.395, 0.3);
}

// Two signatures whose correlation is 0.8, true amplitudes of 10 standard deviations and -10: alone each shows with
// 10 - 8 = 2 and -2, together with 10 each and a gain of (10 x 2 + 10 x 2) / 2 = 20.
TEST(PairScore, SeesWhatHidesEachOther) {
    Scores scores;
    scores.z = Eigen::Vector2d(2.0, -2.0);
    scores.length = Eigen::Vector2d::Ones();
    scores.correlation = Eigen::MatrixXd{{1.0, 0.8}, {0.8, 1.0}};
    const PairScore both = score_of_pair(scores, Eigen::Vector2i(0, -1), {0, 1});
    EXPECT_NEAR(both.first, 10.0, 1e-12);
    EXPECT_NEAR(both.second, -10.0, 1e-12);
    EXPECT_NEAR(both.gain, 20.0, 1e-12);
    EXPECT_EQ(score_of_pair(scores, Eigen::Vector2i(0, +1), {0, 1}).gain, 0.0);
}

// Residuals of white noise of variance 1, 300 rows, 6 free numbers of which two are known before to a standard deviation,
// 10 signatures with arbitrary lengths and correlations: every z is normal with variance 1 whatever the free numbers are.
// Over 2 000 draws the distance of Kolmogorov and Smirnov stays below 1.95 / sqrt(2000) = 0.0436 in 999 of 1 000 cases, in
// all ten signatures in 99 of 100.
TEST(Scores, AreNormalWhereNothingIsMissing) {
    std::mt19937_64 engine(7);
    const Eigen::MatrixXd slopes = drawn(engine, 300, 6);
    Eigen::VectorXd precision = Eigen::VectorXd::Zero(6);
    precision.head(2).setConstant(400.0);
    Eigen::MatrixXd columns = drawn(engine, 300, 10) * drawn(engine, 10, 10);
    columns.rightCols(5) += slopes.leftCols(5) * 10.0;
    const NuisanceProjector projector(slopes, precision);
    const Eigen::MatrixXd signatures = projector.project(columns);
    std::vector<std::vector<double>> z(10);
    for (int draw = 0; draw < 2000; ++draw) {
        const Eigen::VectorXd noise = drawn(engine, 300, 1);
        // The truth of the free numbers lies anywhere, of the first two as far off as they are known.
        Eigen::VectorXd truth = 5.0 * drawn(engine, 6, 1);
        truth.head(2) = drawn(engine, 2, 1) / 20.0;
        const Scores scores =
            score(signatures, projector.project(Eigen::VectorXd(noise + slopes * truth), Eigen::VectorXd::Zero(6)),
                  columns.colwise().norm());
        for (std::size_t k = 0; k < z.size(); ++k) {
            z[k].push_back(scores.z[static_cast<Eigen::Index>(k)]);
        }
    }
    for (const std::vector<double>& one : z) {
        EXPECT_LT(kolmogorov_smirnov(one), 0.0436);
    }
}

// A signature of amplitude a beside free numbers has the z a |Ps| in data without noise, and the amplitude is a again.
TEST(Scores, FindTheAmplitudeBesideFreeNumbers) {
    std::mt19937_64 engine(8);
    const Eigen::MatrixXd slopes = drawn(engine, 50, 4);
    const Eigen::MatrixXd columns = drawn(engine, 50, 2);
    const NuisanceProjector projector(slopes, Eigen::VectorXd::Zero(4));
    const Eigen::VectorXd data = 3.0 * columns.col(0) + slopes * Eigen::Vector4d(1.0, -2.0, 0.5, 4.0);
    const Scores scores =
        score(projector.project(columns), projector.project(data, Eigen::VectorXd::Zero(4)), columns.colwise().norm());
    EXPECT_NEAR(scores.amplitude(0), 3.0, 1e-12);
    EXPECT_NEAR(scores.z[0], 3.0 * scores.length[0], 1e-11);
    EXPECT_NEAR(scores.z[1], scores.correlation(0, 1) * scores.z[0], 1e-11);
}

// What the free numbers make up but for a ten-thousandth cannot be seen: its score is round-off.
TEST(Scores, LeaveOutWhatTheFreeNumbersMakeUp) {
    std::mt19937_64 engine(9);
    const Eigen::MatrixXd slopes = drawn(engine, 50, 4);
    Eigen::MatrixXd column = slopes * Eigen::Vector4d(1.0, 1.0, 1.0, 1.0);
    column += 1e-5 * drawn(engine, 50, 1);
    const NuisanceProjector projector(slopes, Eigen::VectorXd::Zero(4));
    const Scores scores = score(projector.project(column),
                                projector.project(Eigen::VectorXd(drawn(engine, 50, 1)), Eigen::VectorXd::Zero(4)),
                                column.colwise().norm());
    EXPECT_EQ(scores.length[0], 0.0);
    EXPECT_EQ(scores.z[0], 0.0);
}

TEST(Scores, CountASignOnlyWhereItIsPhysical) {
    EXPECT_EQ(admitted(-3.0, 0), 3.0);
    EXPECT_EQ(admitted(-3.0, 1), 0.0);
    EXPECT_EQ(admitted(-3.0, -1), 3.0);
}

}  // namespace tiretherm::diagnosis
