// SPDX-License-Identifier: BSD-3-Clause
// Small linear models whose predictions of what was left out are worked out by hand.

#include "diagnosis/assess/linear_prediction.hpp"

#include <gtest/gtest.h>

namespace tiretherm::diagnosis {
namespace {

constexpr double unbounded = 1e9;

/// Two runs of four samples of one channel, each left out once; unit noise.
const std::vector<Fold> each_run{{.test = {0, 1, 2, 3}, .rest = {4, 5, 6, 7}, .runs = {0}},
                                 {.test = {4, 5, 6, 7}, .rest = {0, 1, 2, 3}, .runs = {1}}};

/// The same four values in both runs.
Eigen::VectorXd twice(double a, double b, double c, double d) { return Eigen::VectorXd{{a, b, c, d, a, b, c, d}}; }

LinearisedModel model_of(const Eigen::VectorXd& left, const Eigen::MatrixXd& slopes) {
    const Eigen::VectorXd nothing = Eigen::VectorXd::Zero(slopes.cols());
    return {.slopes = slopes, .raw = slopes, .residual = left, .left = left, .precision = nothing, .known = nothing};
}

LinearPrediction beside(const LinearisedModel& model, const Eigen::MatrixXd& signatures, double most = unbounded,
                        const std::vector<std::vector<bool>>& own = {{}, {}}) {
    const std::vector<std::pair<double, double>> bounds(static_cast<std::size_t>(signatures.cols()), {-most, most});
    return {model, {.raw = signatures, .white = signatures, .bounds = bounds}, each_run, own, std::vector<int>(8, 0),
            1};
}

// a = (2, 1, 2, 1), b = (1, 2, 1, 2), left a - b = (1, -1, 1, -1) of mean square 1. Alone a gets the amplitude a'(a - b) / a'a =
// 2/10 and leaves (0.6, -1.2, 0.6, -1.2), of mean square 0.9; together they leave nothing: a ranking one by one would miss the pair.
TEST(LinearPrediction, CausesTogetherPredictWhatNeitherDoesAlone) {
    Eigen::MatrixXd signatures(8, 2);
    signatures << twice(2, 1, 2, 1), twice(1, 2, 1, 2);
    const LinearPrediction linear = beside(model_of(twice(1, -1, 1, -1), Eigen::MatrixXd(8, 0)), signatures);
    const LinearPrediction::MeanSquares before = linear.with({});
    EXPECT_NEAR(before[0], 1.0, 1e-12);
    EXPECT_NEAR(share_removed(before, linear.with({0})), 0.1, 1e-6);
    EXPECT_NEAR(share_removed(before, linear.with({1})), 0.1, 1e-6);
    EXPECT_NEAR(share_removed(before, linear.with({0, 1})), 1.0, 1e-6);
    EXPECT_NEAR(linear.amplitudes({0})[0], 0.2, 1e-6);
    EXPECT_NEAR(linear.amplitudes({0, 1})[0], 1.0, 1e-6);
    EXPECT_NEAR(linear.amplitudes({0, 1})[1], -1.0, 1e-6);
}

// The data ask for twice the signature and its bound allows one: half of the error is left, a quarter of its square.
TEST(LinearPrediction, HoldsAmplitudesWithinTheirBounds) {
    const Eigen::VectorXd signature = twice(1, -1, 2, 0);
    const LinearPrediction linear = beside(model_of(2.0 * signature, Eigen::MatrixXd(8, 0)), signature, 1.0);
    EXPECT_NEAR(linear.amplitudes({0})[0], 1.0, 1e-12);
    EXPECT_NEAR(share_removed(linear.with({}), linear.with({0})), 0.75, 1e-12);
}

// The same of a number that the model has: it may move by one where the data ask for two. Half of the error is left, (1, -1, 2, 0), of mean
// square 1.5; a number that the rest hardly tells would otherwise go anywhere, and what is left out would count against its cause.
TEST(LinearPrediction, HoldsTheModelsOwnNumbersWithinTheirBounds) {
    const Eigen::VectorXd slope = twice(1, -1, 2, 0);
    const Signatures none{
        .raw = Eigen::MatrixXd(8, 0), .white = Eigen::MatrixXd(8, 0), .bounds = {}, .bounds_of_numbers = {{-1.0, 1.0}}};
    const LinearPrediction linear{model_of(2.0 * slope, slope), none, each_run, {{false}, {false}},
                                  std::vector<int>(8, 0),       1};
    EXPECT_NEAR(linear.with({})[0], 1.5, 1e-6);
}

// The runs lie 3 and 5 above the model. A start of each run takes that from the run itself and leaves nothing; a number that only
// the rest may fit would leave 3^2 and 5^2, as the rest says nothing of it.
TEST(LinearPrediction, StartsComeFromWhatIsLeftOut) {
    Eigen::MatrixXd starts = Eigen::MatrixXd::Zero(8, 2);
    starts.col(0).head(4).setOnes();
    starts.col(1).tail(4).setOnes();
    const Eigen::VectorXd left{{3, 3, 3, 3, 5, 5, 5, 5}};
    const Eigen::MatrixXd none(8, 0);
    EXPECT_NEAR(beside(model_of(left, starts), none, 1.0, {{true, false}, {false, true}}).with({})[0], 0.0, 1e-6);
    EXPECT_NEAR(beside(model_of(left, starts), none, 1.0, {{false, false}, {false, false}}).with({})[0],
                0.5 * (9.0 + 25.0), 1e-6);
}

// A signature that is there in the first run alone is sized by that run, and predicts nothing of the second. Of the first, whose rest
// knows no size, all is left: 1 of the mean square of 1 in each.
TEST(LinearPrediction, WhatOneRunAloneShowsPredictsNothing) {
    const Eigen::VectorXd signature{{1, -1, 1, -1, 0, 0, 0, 0}};
    const LinearPrediction linear = beside(model_of(twice(1, -1, 1, -1), Eigen::MatrixXd(8, 0)), signature);
    EXPECT_NEAR(share_removed(linear.with({}), linear.with({0})), 0.0, 1e-12);
}

}  // namespace
}  // namespace tiretherm::diagnosis
