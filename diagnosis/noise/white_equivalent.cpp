// SPDX-License-Identifier: BSD-3-Clause
// Sums the autocorrelations of each channel's noise in closed form.

#include "diagnosis/noise/white_equivalent.hpp"

#include <algorithm>
#include <cmath>

namespace tiretherm::diagnosis {

Covariance white_equivalent(const Covariance& covariance, std::span<const NoiseBlock> blocks) {
    Covariance white = covariance;
    for (std::size_t c = 0; c < white.channels.size(); ++c) {
        Noise& noise = white.channels[c];
        const double interval = median_interval(blocks, static_cast<int>(c));
        double sum = 1.0;
        if (noise.correlation_time > 0.0 && interval > 0.0) {
            const double rho = std::exp(-interval / noise.correlation_time);
            sum = noise.white_share + (1.0 - noise.white_share) * (1.0 + rho) / (1.0 - rho);
        }
        noise = {.sigma = noise.sigma * std::sqrt(sum)};
    }
    return white;
}

double time_scale(const Eigen::VectorXd& left, std::span<const NoiseBlock> blocks, int channel) {
    double longest = 0.0;
    double weight = 0.0;
    for (const NoiseBlock& block : blocks) {
        if (block.channel != channel || block.rows() < 10) {
            continue;
        }
        const Eigen::VectorXd x = left.segment(block.first, block.rows());
        const double interval = (block.time.back() - block.time.front()) / static_cast<double>(block.rows() - 1);
        const double power = x.squaredNorm() / static_cast<double>(x.size());
        if (!(power > 0.0)) {
            continue;
        }
        double sum = 0.5;
        for (Eigen::Index lag = 1; lag < x.size() / 2; ++lag) {
            const Eigen::Index n = x.size() - lag;
            const double r = x.head(n).dot(x.tail(n)) / (static_cast<double>(n) * power);
            if (r <= 0.0) {
                break;
            }
            sum += r;
        }
        longest += sum * interval * power;
        weight += power;
    }
    return weight > 0.0 ? longest / weight : 0.0;
}

Covariance white_noise_of(const Eigen::VectorXd& left, std::span<const NoiseBlock> blocks, std::size_t n_channels) {
    constexpr double least = 1e-9;  // of readings that are met exactly
    Covariance white;
    double fewer = 0.0;  // logarithm, mean over the channels
    for (std::size_t c = 0; c < n_channels; ++c) {
        const auto channel = static_cast<int>(c);
        double square = 0.0;
        Eigen::Index rows = 0;
        for (const NoiseBlock& block : blocks) {
            if (block.channel == channel) {
                square += left.segment(block.first, block.rows()).squaredNorm();
                rows += block.rows();
            }
        }
        const double interval = median_interval(blocks, channel);
        const double times = interval > 0.0 ? 2.0 * time_scale(left, blocks, channel) / interval : 1.0;
        fewer += std::log(std::max(1.0, times)) / static_cast<double>(n_channels);
        const double mean = square / static_cast<double>(std::max<Eigen::Index>(1, rows));
        white.channels.push_back({.sigma = std::max(least, std::sqrt(mean))});
    }
    for (Noise& channel : white.channels) {
        channel.sigma *= std::exp(0.5 * fewer);
    }
    return white;
}

}  // namespace tiretherm::diagnosis
