// SPDX-License-Identifier: BSD-3-Clause
// Dense covariance matrices and noise samples written directly from the definition of the noise model.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include <Eigen/Core>

#include "diagnosis/noise/noise.hpp"

/// Noise and covariances written straight from their definitions.
namespace tiretherm::diagnosis::sample {

/// Independent standard normal numbers.
inline Eigen::MatrixXd normal(Eigen::Index rows, Eigen::Index columns, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> draw;
    return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return draw(random); });
}

/// V entry by entry: (1 - s) sigma^2 exp(-|t - t'| / tau), and s sigma^2 more on the diagonal.
inline Eigen::MatrixXd dense_covariance(const std::vector<NoiseBlock>& blocks, const std::vector<Noise>& noise,
                                        Eigen::Index rows) {
    Eigen::MatrixXd V = Eigen::MatrixXd::Zero(rows, rows);
    for (const NoiseBlock& block : blocks) {
        for (Eigen::Index i = 0; i < block.rows(); ++i) {
            const auto a = static_cast<std::size_t>(i);
            if (block.channel < 0) {
                V(block.first + i, block.first + i) = block.standard_deviation[a] * block.standard_deviation[a];
                continue;
            }
            const Noise& n = noise[static_cast<std::size_t>(block.channel)];
            for (Eigen::Index j = 0; j < block.rows(); ++j) {
                const double apart = std::abs(block.time[a] - block.time[static_cast<std::size_t>(j)]);
                V(block.first + i, block.first + j) =
                    n.sigma * n.sigma *
                    ((1.0 - n.white_share) * std::exp(-apart / n.correlation_time) + (i == j ? n.white_share : 0.0));
            }
        }
    }
    return V;
}

/// Draws the noise of a channel at ascending times, sample after sample: a' = phi a + sqrt(1 - phi^2) sigma_a n.
inline std::vector<double> draw(const Noise& noise, const std::vector<double>& time, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    const double slow = noise.sigma * std::sqrt(1.0 - noise.white_share);
    const double fast = noise.sigma * std::sqrt(noise.white_share);
    std::vector<double> values;
    double a = slow * normal(random);
    for (std::size_t i = 0; i < time.size(); ++i) {
        if (i > 0 && slow > 0.0) {
            const double phi = std::exp(-(time[i] - time[i - 1]) / noise.correlation_time);
            a = phi * a + std::sqrt(1.0 - phi * phi) * slow * normal(random);
        }
        values.push_back(a + fast * normal(random));
    }
    return values;
}

/// n times, dt apart.
inline std::vector<double> clock(std::size_t n, double dt) {
    std::vector<double> time(n);
    for (std::size_t i = 0; i < n; ++i) {
        time[i] = dt * static_cast<double>(i);
    }
    return time;
}

}  // namespace tiretherm::diagnosis::sample
