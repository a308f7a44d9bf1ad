// SPDX-License-Identifier: BSD-3-Clause
// The restricted likelihood (REML) evaluated channel by channel; keeps the products of whitened columns, so that a
// trial of one channel is cheap.
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "diagnosis/noise/noise_estimate.hpp"

namespace tiretherm::diagnosis {

/// The restricted likelihood of a NoiseProblem, channel by channel. The products G_c = [X r]' V_c^-1 [X r] of every
/// channel are kept, so that a trial of one channel's correlation whitens its rows alone, and one of its sigma nothing.
class NoiseLikelihood {
public:
    /// @param columns of the span that are used
    NoiseLikelihood(const NoiseProblem& problem, const std::vector<Eigen::Index>& columns);

    /// A channel's correlation on trial, with the sigma that suits it best.
    struct Trial {
        double correlation_time = 0.0;
        double white_share = 1.0;
        double log_sigma = 0.0;
        double value = 0.0;            ///< -2 log likelihood of all channels
        double freedom = 0.0;          ///< samples of the channel less what the span takes of them
        bool empty = false;            ///< nothing is left to estimate sigma from
        double log_determinant = 0.0;  ///< of V_c at sigma 1
        Eigen::MatrixXd products;      ///< G_c at sigma 1

        [[nodiscard]] Noise noise() const;
    };
    [[nodiscard]] Trial try_correlation(std::size_t channel, double correlation_time, double white_share) const;
    /// The same without a choice of sigma.
    [[nodiscard]] Trial try_noise(std::size_t channel, const Noise& noise) const;
    /// Takes a trial as the channel's noise from now on.
    void accept(std::size_t channel, const Trial& trial);
    /// @param weight [n_rows of the problem] Huber's; all channels keep their noise
    void set_weight(const Eigen::VectorXd& weight);

    [[nodiscard]] const Covariance& covariance() const { return covariance_; }
    [[nodiscard]] double value() const;
    /// [n_rows] the problem's residual less what the span explains of it at the noise of now.
    [[nodiscard]] Eigen::VectorXd unexplained() const;

    [[nodiscard]] Eigen::Index samples(std::size_t channel) const { return parts_[channel].data.rows(); }
    [[nodiscard]] double median_interval(std::size_t channel) const;  ///< s
    [[nodiscard]] double longest_run(std::size_t channel) const;      ///< s
    [[nodiscard]] double raw_rms(std::size_t channel) const;          ///< of the residual as it came

private:
    /// The rows of one channel.
    struct Part {
        std::vector<NoiseBlock> blocks;  ///< of rows that are counted within the part
        std::vector<Eigen::Index> row;   ///< of the problem
        Eigen::MatrixXd data;            ///< [n_rows][n_columns + 1] span and residual
        Eigen::VectorXd weight;
        Eigen::MatrixXd products;  ///< G_c
        double log_determinant = 0.0;
    };
    [[nodiscard]] Trial whitened(std::size_t channel, double correlation_time, double white_share) const;
    /// Sets freedom, value and emptiness of a trial at its sigma.
    /// @returns whitened sum of squares of the channel's unexplained residual
    double evaluate(Trial& trial, const Eigen::MatrixXd& others, double others_determinant) const;
    [[nodiscard]] Eigen::MatrixXd products_without(std::size_t channel) const;
    [[nodiscard]] double determinant_without(std::size_t channel) const;

    const NoiseProblem& problem_;
    std::vector<Eigen::Index> columns_;
    Eigen::VectorXd length_;  ///< [n_columns] by which the columns are divided
    Eigen::MatrixXd known_;   ///< products of the single numbers, and the prior
    double known_determinant_ = 0.0;
    std::vector<Part> parts_;
    Covariance covariance_;
};

/// Columns of the span that can be distinguished: no column without a prior is made up of earlier ones without a prior.
[[nodiscard]] std::vector<Eigen::Index> independent_columns(const NoiseProblem& problem);

}  // namespace tiretherm::diagnosis
