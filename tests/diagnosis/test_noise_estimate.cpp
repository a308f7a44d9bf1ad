#include "diagnosis/noise_estimate.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include <gtest/gtest.h>
#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "tests/diagnosis/noise_sample.hpp"

namespace tiretherm::diagnosis {
namespace {

using sample::clock;
using sample::draw;

/// Camera and probe of the practice bench, sampled every 2 s: rho 0.9 at 1 s, 30 % white.
const Noise camera{.sigma = 0.5, .correlation_time = 9.491, .white_share = 0.3};
const Noise probe{.sigma = 0.3, .correlation_time = 9.491, .white_share = 0.3};
const Noise white{.sigma = 0.5, .correlation_time = 0.0, .white_share = 1.0};

/// Residuals, and what an estimate is asked with.
struct Data {
    std::vector<Block> blocks;
    Eigen::VectorXd residual;
    Eigen::MatrixXd span;
    Eigen::VectorXd precision;
    std::vector<double> data_sheet;
    NoiseModel model = NoiseModel::correlated;
    bool robust = false;

    [[nodiscard]] NoiseEstimate estimate() const {
        return estimate_noise({.blocks = blocks,
                               .residual = residual,
                               .span = span,
                               .precision = precision,
                               .data_sheet = data_sheet,
                               .model = model,
                               .robust = robust});
    }
    void add(int channel, const std::vector<double>& time, const std::vector<double>& value) {
        const Eigen::Index first = residual.size();
        blocks.push_back(series_block(channel, first, time, value));
        residual.conservativeResize(first + static_cast<Eigen::Index>(value.size()));
        residual.tail(static_cast<Eigen::Index>(value.size())) =
            Eigen::Map<const Eigen::VectorXd>(value.data(), static_cast<Eigen::Index>(value.size()));
        data_sheet.resize(std::max(data_sheet.size(), static_cast<std::size_t>(channel) + 1), 0.0);
    }
    /// Slow columns, as sensitivities are: cosines of up to `columns` half periods over each block.
    void span_cosines(Eigen::Index columns) {
        span.resize(residual.size(), columns);
        for (const Block& block : blocks) {
            for (Eigen::Index i = 0; i < block.rows(); ++i) {
                for (Eigen::Index j = 0; j < columns; ++j) {
                    span(block.first + i, j) =
                        std::cos(std::numbers::pi * static_cast<double>(j) * (static_cast<double>(i) + 0.5) /
                                 static_cast<double>(block.rows()));
                }
            }
        }
        precision = Eigen::VectorXd::Zero(columns);
    }
};

Data one_series(const Noise& noise, std::size_t samples, double interval, Eigen::Index columns, std::uint64_t seed) {
    Data data;
    const std::vector<double> time = clock(samples, interval);
    data.add(0, time, draw(noise, time, seed));
    data.span_cosines(columns);
    return data;
}

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
    const std::vector<std::string> said =
        cautions("bulk", "K", {.sigma = 1.6, .correlation_time = 50.0, .white_share = 0.3}, found, 0.5, {80.0, 600.0});
    ASSERT_EQ(said.size(), 2u);
    EXPECT_EQ(said[0].find("bulk: the noise of 1.6 K is 3.2 times what the data sheet says (0.5 K)"), 0u) << said[0];
    EXPECT_EQ(said[1].find("bulk: the noise forgets itself in 50 s, as fast as the tire does (80 s)"), 0u) << said[1];
    EXPECT_EQ(cautions("bulk", "K", {.sigma = 0.5, .correlation_time = 119.9, .white_share = 0.3}, found, 0.0, {})
                  .front()
                  .find("bulk: the noise is as slow as is allowed, 2 min"),
              0u);
}

}  // namespace
}  // namespace tiretherm::diagnosis
