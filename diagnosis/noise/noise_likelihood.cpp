// SPDX-License-Identifier: BSD-3-Clause
// Whitens the rows of one channel, forms the products G_c, and finds sigma for a given correlation by Newton steps.

#include "diagnosis/noise/noise_likelihood.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Cholesky>

namespace tiretherm::diagnosis {

namespace {

constexpr std::size_t nobody = std::numeric_limits<std::size_t>::max();

/// W' W, only once for each pair of columns.
Eigen::MatrixXd products(const Eigen::MatrixXd& W) {
    Eigen::MatrixXd G = Eigen::MatrixXd::Zero(W.cols(), W.cols());
    G.selfadjointView<Eigen::Lower>().rankUpdate(W.transpose());
    G.triangularView<Eigen::StrictlyUpper>() = G.transpose();
    return G;
}

}  // namespace

Noise NoiseLikelihood::Trial::noise() const {
    return {.sigma = std::exp(log_sigma), .correlation_time = correlation_time, .white_share = white_share};
}

NoiseLikelihood::NoiseLikelihood(const NoiseProblem& problem, const std::vector<Eigen::Index>& columns)
    : problem_(problem), columns_(columns), parts_(problem.data_sheet.size()) {
    const auto n = static_cast<Eigen::Index>(columns_.size());
    length_.resize(n);
    for (Eigen::Index j = 0; j < n; ++j) {
        const Eigen::Index column = columns_[static_cast<std::size_t>(j)];
        const double length = std::hypot(problem.span.col(column).norm(), std::sqrt(problem.precision[column]));
        length_[j] = length > 0.0 ? length : 1.0;
    }
    const auto fill = [&](auto&& rows, const NoiseBlock& block) {
        for (Eigen::Index j = 0; j < n; ++j) {
            rows.col(j) =
                problem.span.col(columns_[static_cast<std::size_t>(j)]).segment(block.first, block.rows()) / length_[j];
        }
        rows.col(n) = problem.residual.segment(block.first, block.rows());
    };

    known_ = Eigen::MatrixXd::Zero(n + 1, n + 1);
    for (Eigen::Index j = 0; j < n; ++j) {
        known_(j, j) = problem.precision[columns_[static_cast<std::size_t>(j)]] / (length_[j] * length_[j]);
    }
    std::vector<Eigen::Index> size(parts_.size(), 0);
    for (const NoiseBlock& block : problem.blocks) {
        if (block.channel < 0) {
            NoiseBlock numbers = block;
            Eigen::MatrixXd rows(block.rows(), n + 1);
            fill(rows, block);
            numbers.first = 0;
            whiten({&numbers, 1}, {}, rows);
            known_ += products(rows);
            known_determinant_ += diagnosis::log_determinant({&numbers, 1}, {});
        } else {
            size[static_cast<std::size_t>(block.channel)] += block.rows();
        }
    }
    for (std::size_t c = 0; c < parts_.size(); ++c) {
        parts_[c].data.resize(size[c], n + 1);
        parts_[c].products = Eigen::MatrixXd::Zero(n + 1, n + 1);
        covariance_.channels.push_back({.sigma = 1.0, .correlation_time = 0.0, .white_share = 1.0});
    }
    for (const NoiseBlock& block : problem.blocks) {
        if (block.channel >= 0) {
            Part& part = parts_[static_cast<std::size_t>(block.channel)];
            const auto first = static_cast<Eigen::Index>(part.row.size());
            fill(part.data.middleRows(first, block.rows()), block);
            for (Eigen::Index i = 0; i < block.rows(); ++i) {
                part.row.push_back(block.first + i);
            }
            part.blocks.push_back(block);
            part.blocks.back().first = first;
        }
    }
}

NoiseLikelihood::Trial NoiseLikelihood::whitened(std::size_t channel, double correlation_time,
                                                 double white_share) const {
    const Part& part = parts_[channel];
    Trial trial{.correlation_time = correlation_time, .white_share = white_share, .products = {}};
    Covariance covariance{.channels = std::vector<Noise>(parts_.size()), .weight = part.weight};
    covariance.channels[channel] = {.sigma = 1.0, .correlation_time = correlation_time, .white_share = white_share};
    Eigen::MatrixXd rows = part.data;
    whiten(part.blocks, covariance, rows);
    trial.products = products(rows);
    trial.log_determinant = diagnosis::log_determinant(part.blocks, covariance);
    return trial;
}

double NoiseLikelihood::evaluate(Trial& trial, const Eigen::MatrixXd& others, double others_determinant) const {
    const auto n = static_cast<Eigen::Index>(columns_.size());
    const double t = std::exp(-2.0 * trial.log_sigma);
    const Eigen::MatrixXd G = others + t * trial.products;
    const auto rows = static_cast<double>(trial.freedom);
    double squares = t * trial.products(n, n);
    double taken = 0.0;
    trial.value = others_determinant + trial.log_determinant + 2.0 * rows * trial.log_sigma + G(n, n);
    if (n > 0) {
        const Eigen::LLT<Eigen::MatrixXd> factor(G.topLeftCorner(n, n));
        const Eigen::VectorXd b = factor.solve(G.col(n).head(n));
        trial.value -= b.dot(G.col(n).head(n));
        trial.value += 2.0 * factor.matrixLLT().diagonal().array().log().sum();
        squares += t * (b.dot(trial.products.topLeftCorner(n, n) * b) - 2.0 * b.dot(trial.products.col(n).head(n)));
        taken = t * factor.solve(trial.products.topLeftCorner(n, n)).trace();
    }
    trial.freedom = rows - taken;
    trial.empty = !(squares > 1e-12 * t * trial.products(n, n)) || !(trial.freedom > 1e-6 * rows);
    return squares;
}

NoiseLikelihood::Trial NoiseLikelihood::try_correlation(std::size_t channel, double correlation_time,
                                                        double white_share) const {
    // d value / d log sigma = 2 (rows - taken - squares) = 0. Newton's step on log(taken + squares) = log rows, in which
    // squares go with sigma^-2 and what the columns take stays: exact in one step for one channel without a prior.
    Trial trial = whitened(channel, correlation_time, white_share);
    const Eigen::MatrixXd others = products_without(channel);
    const double others_determinant = determinant_without(channel);
    const auto rows = static_cast<double>(samples(channel));
    trial.log_sigma = std::log(covariance_.channels[channel].sigma);
    for (int iteration = 0; iteration < 50; ++iteration) {
        trial.freedom = rows;
        const double squares = evaluate(trial, others, others_determinant);
        if (trial.empty) {
            break;
        }
        const double step = 0.5 * std::log(squares / trial.freedom);
        if (std::abs(step) < 1e-7) {
            break;
        }
        trial.log_sigma += std::clamp(step, -5.0, 5.0);
    }
    return trial;
}

NoiseLikelihood::Trial NoiseLikelihood::try_noise(std::size_t channel, const Noise& noise) const {
    Trial trial = whitened(channel, noise.correlation_time, noise.white_share);
    trial.log_sigma = std::log(noise.sigma);
    trial.freedom = static_cast<double>(samples(channel));
    evaluate(trial, products_without(channel), determinant_without(channel));
    return trial;
}

void NoiseLikelihood::accept(std::size_t channel, const Trial& trial) {
    Part& part = parts_[channel];
    covariance_.channels[channel] = trial.noise();
    part.products = std::exp(-2.0 * trial.log_sigma) * trial.products;
    part.log_determinant = trial.log_determinant + 2.0 * static_cast<double>(samples(channel)) * trial.log_sigma;
}

void NoiseLikelihood::set_weight(const Eigen::VectorXd& weight) {
    covariance_.weight = weight;
    for (std::size_t c = 0; c < parts_.size(); ++c) {
        Part& part = parts_[c];
        part.weight.resize(samples(c));
        for (Eigen::Index i = 0; i < samples(c); ++i) {
            part.weight[i] = weight[part.row[static_cast<std::size_t>(i)]];
        }
        if (samples(c) > 0) {
            accept(c, try_noise(c, covariance_.channels[c]));
        }
    }
}

Eigen::MatrixXd NoiseLikelihood::products_without(std::size_t channel) const {
    Eigen::MatrixXd sum = known_;
    for (std::size_t c = 0; c < parts_.size(); ++c) {
        if (c != channel) {
            sum += parts_[c].products;
        }
    }
    return sum;
}

double NoiseLikelihood::determinant_without(std::size_t channel) const {
    double sum = known_determinant_;
    for (std::size_t c = 0; c < parts_.size(); ++c) {
        sum += c == channel ? 0.0 : parts_[c].log_determinant;
    }
    return sum;
}

double NoiseLikelihood::value() const {
    const auto n = static_cast<Eigen::Index>(columns_.size());
    const Eigen::MatrixXd G = products_without(nobody);
    double sum = determinant_without(nobody) + G(n, n);
    if (n > 0) {
        const Eigen::LLT<Eigen::MatrixXd> factor(G.topLeftCorner(n, n));
        sum += 2.0 * factor.matrixLLT().diagonal().array().log().sum();
        sum -= G.col(n).head(n).dot(factor.solve(G.col(n).head(n)));
    }
    return sum;
}

Eigen::VectorXd NoiseLikelihood::unexplained() const {
    const auto n = static_cast<Eigen::Index>(columns_.size());
    Eigen::VectorXd rest = problem_.residual;
    if (n > 0) {
        const Eigen::MatrixXd G = products_without(nobody);
        const Eigen::VectorXd b = G.topLeftCorner(n, n).llt().solve(G.col(n).head(n));
        for (Eigen::Index j = 0; j < n; ++j) {
            rest -= problem_.span.col(columns_[static_cast<std::size_t>(j)]) * (b[j] / length_[j]);
        }
    }
    return rest;
}

double NoiseLikelihood::median_interval(std::size_t channel) const {
    return diagnosis::median_interval(parts_[channel].blocks, static_cast<int>(channel));
}

double NoiseLikelihood::longest_run(std::size_t channel) const {
    double longest = 0.0;
    for (const NoiseBlock& block : parts_[channel].blocks) {
        longest = std::max(longest, block.time.empty() ? 0.0 : block.time.back() - block.time.front());
    }
    return longest;
}

double NoiseLikelihood::raw_rms(std::size_t channel) const {
    const Part& part = parts_[channel];
    return part.data.rows() > 0
               ? part.data.col(part.data.cols() - 1).norm() / std::sqrt(static_cast<double>(part.data.rows()))
               : 0.0;
}

}  // namespace tiretherm::diagnosis
