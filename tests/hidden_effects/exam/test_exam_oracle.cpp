// SPDX-License-Identifier: BSD-3-Clause
// The examiner: does the oracle see what it says it sees, and does a data set hide what it is asked to hide?
#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>
#include <Eigen/Cholesky>

#include "exam/exam_data_set_truth.hpp"
#include "exam/exam_signals_truth.hpp"

namespace hidden_effects {

namespace {

/// Two runs of a data set as the oracle is given them, with a sample every 4 s.
Oracle oracle_of(std::uint64_t seed) { return Oracle(draw_data_set(Kind::nothing, 0.0, seed, 4.0).runs); }

Readings with_noise(Readings readings, const BenchRuns& runs, Random& random) {
    for (std::size_t run = 0; run < readings.size(); ++run) {
        for (std::size_t c = 0; c < readings[run].size(); ++c) {
            const std::vector<double> noise =
                draw_noise(runs.rig->channels[c].noise, runs.programmes[run].time, random);
            std::transform(noise.begin(), noise.end(), readings[run][c].begin(), readings[run][c].begin(),
                           std::plus<>());
        }
    }
    return readings;
}

}  // namespace

// V_ij = sigma^2 (0.7 * 0.9^|t_i - t_j| + 0.3 delta_ij), V = L L'. The innovations over their deviations are L^-1 y: both
// are lower triangular with a positive diagonal and whiten the same noise. Uneven times, a gap among them.
TEST(ExamOracle, WhitensAsTheCholeskyFactorOfTheNoiseDoes) {
    const Noise noise{.standard_deviation = 0.4};
    std::vector<double> times;
    Random random(3);
    for (double t = 0.0; times.size() < 40; t += times.size() == 20 ? 60.0 : random.uniform(0.5, 4.0)) {
        times.push_back(t);
    }
    const auto n = static_cast<Eigen::Index>(times.size());
    Eigen::MatrixXd V(n, n);
    Eigen::VectorXd y(n);
    for (Eigen::Index i = 0; i < n; ++i) {
        y[i] = random.normal();
        for (Eigen::Index j = 0; j < n; ++j) {
            const double apart = std::abs(times[static_cast<std::size_t>(i)] - times[static_cast<std::size_t>(j)]);
            V(i, j) = 0.16 * (0.7 * std::pow(0.9, apart) + (i == j ? 0.3 : 0.0));
        }
    }
    const Eigen::VectorXd expected = V.llt().matrixL().solve(y);
    const Eigen::VectorXd white = whitened(noise, times, {y.begin(), y.end()});
    EXPECT_LT((white - expected).cwiseAbs().maxCoeff(), 1e-10);
}

// A free number moved by a tenth of its prior leaves next to nothing: data that move it by s standard deviations of the
// posterior less than of the prior, as all of these do, leave at most the prior's price, 0.1 of a standard deviation, and
// the curvature. The same heat as a cause, a sidewall of 1 W/K, leaves what it is.
TEST(ExamOracle, TakesOffWhatTheFreeNumbersCanImitate) {
    const Oracle oracle = oracle_of(11);
    for (std::size_t number = 0; number < 4; ++number) {
        BenchRuns runs = oracle.runs();
        double* moved[] = {&runs.of_bench[0], &runs.of_bench[1], &runs.of_run[1][0], &runs.of_run[2][1]};
        const double step[] = {0.01, 0.01, 0.3, 0.3};
        *moved[number] += step[number];
        const Readings readings = readings_of(runs, {}, runs.rig->tolerance);
        EXPECT_GT(oracle.whitened_difference(readings).norm(), 0.3) << number;
        EXPECT_LT(oracle.left_of(readings).norm(), 0.15) << number;
    }
    const Cause sidewall{.id = "sidewall_convection", .parameters = {{"conductance", 1.0}}};
    EXPECT_GT(oracle.left_by({sidewall}).norm(), 5.0);
}

// Readings with the cause, other scales and starts drawn from their prior (to first order) and noise, over and over: what
// the oracle sees of the cause, z = l . l(readings) / |l|, has the mean |l| and the standard deviation 1. Of 200 draws
// the mean is within 3.3 / sqrt(200) = 0.23 and the standard deviation within 3.3 / sqrt(400) = 0.165, but once in 1000
// times. An oracle that took the noise for white would be off by a factor of two to four.
TEST(ExamOracle, SeesTheCauseAtItsStandardDeviations) {
    const Oracle oracle = oracle_of(12);
    for (const std::size_t which : {std::size_t{0}, std::size_t{12}}) {
        const Variant& variant = single_variants()[which];
        const std::optional<Size> size = size_for(oracle, variant, 1.0, 8.0, 140.0);
        ASSERT_TRUE(size.has_value());
        const std::vector<Cause> hidden{cause_of(variant, size->number, 140.0)};
        const Eigen::VectorXd left = oracle.left_by(hidden);
        EXPECT_NEAR(left.norm(), 8.0, 0.04);
        const Readings readings = readings_of(oracle.runs(), hidden, oracle.runs().rig->tolerance);
        Random random(100 + which);
        double sum = 0.0;
        double squares = 0.0;
        for (int draw = 0; draw < 200; ++draw) {
            Eigen::VectorXd difference = oracle.whitened_difference(with_noise(readings, oracle.runs(), random));
            for (Eigen::Index j = 0; j < oracle.prior().size(); ++j) {
                difference += oracle.columns().col(j) * oracle.prior()[j] * random.normal();
            }
            const double z = left.dot(oracle.left_of_whitened(difference)) / left.norm();
            sum += z;
            squares += z * z;
        }
        const double mean = sum / 200.0;
        EXPECT_NEAR(mean, 8.0, 0.27) << variant.name();
        EXPECT_NEAR(std::sqrt(squares / 200.0 - mean * mean), 1.0, 0.165) << variant.name();
    }
}

// Every variant can be hidden at 6 standard deviations in an ordinary programme, and shows as much then; what nothing
// follows in a dull one cannot.
TEST(ExamOracle, FindsASizeForEveryCause) {
    const Oracle oracle = oracle_of(13);
    for (const Variant& variant : single_variants()) {
        const std::optional<Size> size = size_for(oracle, variant, 1.0, 6.0, 120.0);
        ASSERT_TRUE(size.has_value()) << variant.name();
        EXPECT_NEAR(oracle.left_by({cause_of(variant, size->number, 120.0)}).norm(), 6.0, 0.03) << variant.name();
        EXPECT_GE(size->number, variant.low);
        EXPECT_LE(size->number, variant.high);
    }
    const Oracle dull(draw_data_set(Kind::dull_nothing, 0.0, 13, 4.0).runs);
    for (const char* slips : {"cornering_loss", "partition_speed", "slip_input_gain"}) {
        const auto variant = std::ranges::find(single_variants(), slips, &Variant::id);
        EXPECT_FALSE(size_for(dull, *variant, 1.0, 6.0, 120.0).has_value()) << slips;
    }
}

TEST(ExamPaper, HidesWhatItsKindSays) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        EXPECT_TRUE(draw_data_set(Kind::nothing, 10.0, seed, 4.0).hidden.empty());
        EXPECT_EQ(draw_data_set(Kind::decoy, 10.0, seed, 4.0).logs.front().size() % 2, 1U);  // 10 columns and 1 or 3
        const ExamDataSet single = draw_data_set(Kind::single, 14.0, seed, 4.0);
        ASSERT_EQ(single.hidden.size(), 1U);
        EXPECT_NEAR(single.oracle.front(), 14.0, 0.07);
        // The most like the truth is the truth, with which it correlates perfectly but for the size it is tried at.
        EXPECT_EQ(single.alike.front().variant->id, single.hidden.front().id);
        EXPECT_GT(std::abs(single.alike.front().correlation), 0.99);
        EXPECT_EQ(draw_data_set(Kind::single, 6.0, seed, 4.0).hidden.front().id, single.hidden.front().id);

        const ExamDataSet pair = draw_data_set(Kind::pair, 10.0, seed, 4.0);
        ASSERT_EQ(pair.hidden.size(), 2U);
        const Oracle oracle(pair.runs);
        const auto left = [&](std::size_t i) { return oracle.left_by({pair.hidden[i]}); };
        EXPECT_LT(std::abs(correlation(left(0), left(1))), 0.9);
        EXPECT_NEAR(left(1).norm(), 10.0, 0.05);

        for (const Kind kind : {Kind::unknown, Kind::unknown_odd}) {
            const ExamDataSet unknown = draw_data_set(kind, 10.0, seed, 4.0);
            EXPECT_NEAR(unknown.oracle.front(), 10.0, 0.05);
            EXPECT_LT(std::abs(unknown.alike.front().correlation), 0.9);
            EXPECT_EQ(unknown.source.signals == std::vector<std::string>{"throttle"}, kind == Kind::unknown);
        }
    }
}

// Of 21 variants 25 draws meet 21 (1 - (20/21)^25) = 14.8 different ones, with a standard deviation of 1.5.
TEST(ExamPaper, EverythingIsDrawnSometimes) {
    std::set<std::string> names;
    std::set<std::string> sources;
    for (std::uint64_t seed = 1; seed <= 25; ++seed) {
        names.insert(answer_of(draw_data_set(Kind::single, 10.0, seed, 8.0)));
    }
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        Random random(seed);
        const HiddenSource source = draw_source(two_node_rig(), Kind::unknown_odd, 3, random);
        sources.insert(source.place + (source.signals.empty() ? "" : source.signals.front()) +
                       std::to_string(source.signals.size()));
    }
    EXPECT_GE(names.size(), 10U);
    EXPECT_EQ(sources.size(), 10U);  // 2 places; a window or one of four combinations
}

// The same seed, the same data set, to the last digit of its logs; another seed, another one.
TEST(ExamPaper, IsDrawnFromItsSeedAlone) {
    const ExamDataSet a = draw_data_set(Kind::pair, 10.0, 21, 8.0);
    const ExamDataSet b = draw_data_set(Kind::pair, 10.0, 21, 8.0);
    const ExamDataSet c = draw_data_set(Kind::pair, 10.0, 22, 8.0);
    EXPECT_EQ(written(a.logs.back()), written(b.logs.back()));
    EXPECT_NE(written(a.logs.back()), written(c.logs.back()));
}

}  // namespace hidden_effects
