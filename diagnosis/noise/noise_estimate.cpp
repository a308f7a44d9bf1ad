// SPDX-License-Identifier: BSD-3-Clause
// Improves the noise of each channel in turn until the restricted likelihood settles; decides between white and
// correlated noise and sets Huber's weights.

#include "diagnosis/noise/noise_estimate.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include <Eigen/LU>

#include "diagnosis/noise/noise_likelihood.hpp"
#include "diagnosis/noise/noise_search.hpp"

namespace tiretherm::diagnosis {

namespace {

constexpr double undetermined = std::numeric_limits<double>::quiet_NaN();
constexpr Eigen::Index fewest_samples = 10;
/// In -2 log likelihood. Three standard deviations of a parameter that is off by this much are off by 0.05.
constexpr double settled_log_likelihood = 1e-3;
/// In -2 log likelihood, exceeded by a few in a hundred white series. A stricter test (BIC: 14 for 1 000 samples) would
/// let pass slow noise of 5 % of the variance, which doubles the variance of a slow effect's size.
constexpr double significant = 4.0;
constexpr int most_passes = 20;

/// One estimate on its way.
struct Estimation {
    const NoiseProblem& problem;
    NoiseLikelihood likelihood;
    std::vector<ChannelNoise> found;
    std::vector<bool> is_correlated;

    [[nodiscard]] bool is_estimated(std::size_t c) const { return found[c].source == NoiseSource::estimated; }
    void take_stated(std::size_t c);
    void begin();
    void improve(std::size_t c);
    void settle(NoiseEstimate& estimate);
    void reweigh();
};

/// The data sheet's word where the samples have none.
void Estimation::take_stated(std::size_t c) {
    const bool stated = problem.data_sheet[c] > 0.0;
    found[c].source = stated ? NoiseSource::data_sheet : NoiseSource::assumed;
    found[c].sigma_deviation = undetermined;
    found[c].rho_1s_deviation = undetermined;
    const NoiseLikelihood::Trial trial = likelihood.try_noise(
        c, {.sigma = stated ? problem.data_sheet[c] : 1.0, .correlation_time = 0.0, .white_share = 1.0});
    found[c].freedom = trial.freedom;
    likelihood.accept(c, trial);
}

/// White noise of the residuals' size, as a start that leaves nothing of them unexplained.
void Estimation::begin() {
    for (std::size_t c = 0; c < found.size(); ++c) {
        found[c].samples = likelihood.samples(c);
        found[c].longest_correlation = likelihood.longest_run(c) / 10.0;
        const double rms = likelihood.raw_rms(c);
        if (found[c].samples < fewest_samples || rms == 0.0) {
            take_stated(c);
        } else if (!problem.start.empty() && problem.start[c].correlation_time > 0.0) {
            is_correlated[c] = true;
            likelihood.accept(c, likelihood.try_noise(c, problem.start[c]));
        } else {
            likelihood.accept(c, likelihood.try_noise(c, {.sigma = rms, .correlation_time = 0.0, .white_share = 1.0}));
        }
    }
}

/// The best noise of one channel, given the others'.
void Estimation::improve(std::size_t c) {
    ChannelNoise& channel = found[c];
    const NoiseLikelihood::Trial white = likelihood.try_correlation(c, 0.0, 1.0);
    if (white.empty) {
        take_stated(c);
        return;
    }
    channel.freedom = white.freedom;
    channel.sigma_deviation = std::exp(white.log_sigma) / std::sqrt(2.0 * white.freedom);
    channel.rho_1s_deviation = 0.0;
    channel.gain = 0.0;
    const NoiseBounds bounds{.shortest = likelihood.median_interval(c) / 5.0, .longest = channel.longest_correlation};
    if (problem.model == NoiseModel::correlated && bounds.shortest < bounds.longest) {
        const NoiseOptimum optimum = search_noise(likelihood, c, bounds, is_correlated[c]);
        channel.gain = white.value - optimum.best.value;
        is_correlated[c] = !optimum.best.empty && channel.gain > significant;
        if (is_correlated[c]) {
            channel.freedom = optimum.best.freedom;
            channel.sigma_deviation = optimum.sigma_deviation;
            channel.rho_1s_deviation = optimum.rho_1s_deviation;
            likelihood.accept(c, optimum.best);
            return;
        }
    }
    likelihood.accept(c, white);
}

void Estimation::settle(NoiseEstimate& estimate) {
    double before = std::numeric_limits<double>::infinity();
    for (int pass = 0; pass < most_passes; ++pass) {
        for (std::size_t c = 0; c < found.size(); ++c) {
            if (is_estimated(c)) {
                improve(c);
            }
        }
        ++estimate.passes;
        const double now = likelihood.value();
        if (std::abs(before - now) < settled_log_likelihood) {
            return;
        }
        before = now;
    }
}

/// Huber's weights of the whitened residuals that the fit of now leaves.
void Estimation::reweigh() {
    const Covariance& covariance = likelihood.covariance();
    Eigen::MatrixXd v = likelihood.unexplained();
    Eigen::VectorXd weight = Eigen::VectorXd::Ones(v.rows());
    whiten(problem.blocks, covariance, v);
    const double spread = covariance.weight.size() > 0 ? std::erf(huber_threshold / std::sqrt(2.0)) : 1.0;
    for (const NoiseBlock& block : problem.blocks) {
        for (Eigen::Index i = block.first; block.channel >= 0 && i < block.first + block.rows(); ++i) {
            const double counted = covariance.weight.size() > 0 ? covariance.weight[i] : 1.0;
            weight[i] = std::min(1.0, huber_threshold / std::abs(v(i, 0) * std::sqrt(spread / counted)));
        }
    }
    likelihood.set_weight(weight);
}

}  // namespace

NoiseEstimate estimate_noise(const NoiseProblem& problem) {
    assert(problem.residual.size() == problem.span.rows() && problem.residual.allFinite());
    assert(problem.precision.size() == problem.span.cols() && problem.span.allFinite());
    NoiseEstimate estimate;
    const std::vector<Eigen::Index> columns = independent_columns(problem);
    for (Eigen::Index j = 0; j < problem.span.cols(); ++j) {
        if (!std::binary_search(columns.begin(), columns.end(), j)) {
            estimate.left_out.push_back(j);
        }
    }
    const std::size_t n_channels = problem.data_sheet.size();
    Estimation estimation{.problem = problem,
                          .likelihood = NoiseLikelihood(problem, columns),
                          .found = std::vector<ChannelNoise>(n_channels),
                          .is_correlated = std::vector<bool>(n_channels, false)};
    estimation.begin();
    estimation.settle(estimate);
    if (problem.robust) {
        constexpr int most_rounds = 20;
        for (int round = 0; round < most_rounds; ++round) {
            const Eigen::VectorXd before = estimation.likelihood.covariance().weight;
            estimation.reweigh();
            const Eigen::VectorXd& now = estimation.likelihood.covariance().weight;
            if (before.size() == now.size() && (before - now).cwiseAbs().maxCoeff() < 1e-3) {
                break;
            }
            estimation.settle(estimate);
        }
    }
    estimate.covariance = estimation.likelihood.covariance();
    estimate.channels = estimation.found;
    estimate.criterion = estimation.likelihood.value();
    return estimate;
}

}  // namespace tiretherm::diagnosis
