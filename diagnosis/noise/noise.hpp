// SPDX-License-Identifier: BSD-3-Clause
// Noise model of a channel, exponentially correlated (AR(1)) plus white, and whitening of residuals by a Kalman filter,
// with Huber's weights for outliers.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

/// Measured against simulated, and what to make of the difference.
namespace tiretherm::diagnosis {

/// Noise of a channel: a correlated part (AR(1)), a(t) with cov(a(t), a(s)) =
/// (1 - white_share) sigma^2 exp(-|t - s| / correlation_time) (sampled evenly it is AR(1)), and a part that is new in
/// every sample, of variance white_share sigma^2.
struct Noise {
    double sigma = 0.0;             ///< standard deviation of both parts together, > 0, in the channel's unit
    double correlation_time = 0.0;  ///< s; 0 with white noise
    double white_share = 1.0;       ///< of the variance, 0 to 1

    /// Correlation of the correlated part over one second.
    [[nodiscard]] double rho_1s() const;
};

/// Consecutive rows of a stack of residuals that share their noise: the samples of one channel in one run, or single
/// numbers, each with its own stated uncertainty and independent of all others. Blocks are independent of each other.
struct NoiseBlock {
    int channel = -1;          ///< whose noise; -1: single numbers
    Eigen::Index first = 0;    ///< row of its first entry
    std::vector<double> time;  ///< [n] s, strictly ascending, of a channel's samples; any gap is a long interval
    std::vector<double> standard_deviation;  ///< [n] of single numbers, > 0
    std::vector<std::size_t> sample;         ///< [n] index in the run's log, where samples are missing

    [[nodiscard]] Eigen::Index rows() const {
        return static_cast<Eigen::Index>(channel < 0 ? standard_deviation.size() : time.size());
    }
};

/// The rows of a channel in a run. A sample that is missing (NaN) has no row.
[[nodiscard]] NoiseBlock series_block(int channel, Eigen::Index first, std::span<const double> time,
                                      std::span<const double> value);
/// The median interval between the samples of a channel, s; 0 with fewer than two.
[[nodiscard]] double median_interval(std::span<const NoiseBlock> blocks, int channel);
[[nodiscard]] NoiseBlock numbers_block(Eigen::Index first, std::vector<double> standard_deviation);

/// Covariance matrix V of stacked residuals, never formed.
struct Covariance {
    std::vector<Noise> channels;  ///< [n_channels]
    /// [n_rows] Huber's weights, 1 and less, or empty. The innovation of a sample of weight w has 1/w times its
    /// variance, so that an outlier counts less and is believed less by the samples after it; all variances are
    /// multiplied by 2 Phi(1.345) - 1 = 0.82, the mean of w v^2 in normal noise, so that sigma stays that of the noise
    /// without its outliers.
    Eigen::VectorXd weight;
};

/// How far noise has moved: the largest relative change of a sigma, or change of a correlation over one second.
[[nodiscard]] double change(const Covariance& before, const Covariance& after);

/// Where a sample's weight begins to fall: 95 % efficient in normal noise (Huber 1981).
inline constexpr double huber_threshold = 1.345;

/// Multiplies each column by V^-1/2, so that its noise has unit variance and no correlation. A scalar Kalman filter runs
/// along each block with all columns at once; the result is that of the Cholesky factor of V.
/// @param rows [n_rows][any] in and out; all finite. Rows of no block stay as they are
void whiten(std::span<const NoiseBlock> blocks, const Covariance& covariance, Eigen::Ref<Eigen::MatrixXd> rows);

/// Multiplies each column by the transpose of V^-1/2 (that of `whiten`): the filter backwards in time, so that both after
/// each other make V^-1.
void whiten_transposed(std::span<const NoiseBlock> blocks, const Covariance& covariance, Eigen::MatrixXd& columns);

/// log |V|.
[[nodiscard]] double log_determinant(std::span<const NoiseBlock> blocks, const Covariance& covariance);

}  // namespace tiretherm::diagnosis
