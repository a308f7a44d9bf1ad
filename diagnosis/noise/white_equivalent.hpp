// SPDX-License-Identifier: BSD-3-Clause
// White noise of the same information: what correlated noise says of slow effects, spread evenly over the samples.
#pragma once

#include <span>

#include "diagnosis/noise/noise.hpp"

namespace tiretherm::diagnosis {

/// White noise whose mean over a long time has the variance that the mean of this noise has: its variance times the sum of
/// its autocorrelations over the samples,
///     sigma^2 (w + (1 - w) (1 + rho) / (1 - rho)),  rho = exp(-interval / correlation_time), w the white share.
/// Every sample counts alike, as in ordinary least squares, and all together as much as the independent ones among them
/// (effective sample size: Bayley and Hammersley, J. Roy. Statist. Soc. Suppl. 8 (1946) 184).
/// @param blocks whose median sample interval counts, channel by channel
[[nodiscard]] Covariance white_equivalent(const Covariance& covariance, std::span<const NoiseBlock> blocks);

/// Sum over time of the autocorrelation of what a channel leaves, up to where it first vanishes. @param left [n_rows] @returns s
[[nodiscard]] double time_scale(const Eigen::VectorXd& left, std::span<const NoiseBlock> blocks, int channel);

/// White noise as large as what a model leaves of each channel, and larger by as much as autocorrelation leaves fewer independent
/// samples, in the geometric mean over the channels: least squares in which every channel counts alike, as in a comparison of
/// predictions, and what was known before keeps its weight. @param left [n_rows] SI, measured - simulated
[[nodiscard]] Covariance white_noise_of(const Eigen::VectorXd& left, std::span<const NoiseBlock> blocks,
                                        std::size_t n_channels);

}  // namespace tiretherm::diagnosis
