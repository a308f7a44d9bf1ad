// SPDX-License-Identifier: BSD-3-Clause
// What data that were left out would be missed by, were some candidates in a model: least squares in the linearised model, so that
// every candidate and every group of them is judged by prediction without a simulation.
#pragma once

#include <utility>
#include <vector>

#include <Eigen/Core>

#include "diagnosis/fit/held_out.hpp"
#include "diagnosis/fit/linearised_model.hpp"

namespace tiretherm::diagnosis {

/// Signatures beside a linearised model.
struct Signatures {
    Eigen::MatrixXd raw;                            ///< [n_rows][m] SI per unit of each
    Eigen::MatrixXd white;                          ///< the same, whitened
    std::vector<std::pair<double, double>> bounds;  ///< [m] of the amplitude of each: it is held within them
    /// [n] of the steps of the model's own numbers, likewise; empty: none has any.
    std::vector<std::pair<double, double>> bounds_of_numbers{};
};

/// A linearised model with signatures beside it, and the sums of products that its least squares need. Each fold is left out in turn:
/// the shared numbers and the amplitudes come from the rest, the starts of what is left out from itself.
class LinearPrediction {
public:
    /// @param own [n_folds][n] whether a number of the model is a start of what the fold leaves out
    /// @param noise_of [n_rows] as noise_of_rows gives it
    LinearPrediction(const LinearisedModel& model, const Signatures& beside, const std::vector<Fold>& folds,
                     const std::vector<std::vector<bool>>& own, const std::vector<int>& noise_of, std::size_t n_noises);

    /// Mean square of each channel's error on what was left out. SI; NaN without any
    using MeanSquares = std::vector<double>;
    /// @param chosen columns of the signatures that are in the model
    [[nodiscard]] MeanSquares with(const std::vector<Eigen::Index>& chosen) const;
    /// Of a fit to everything. @returns as many as were chosen
    [[nodiscard]] std::vector<double> amplitudes(const std::vector<Eigen::Index>& chosen) const;

private:
    /// Sums of products of all columns: the model's numbers, the signatures, what is left.
    struct FoldSums {
        Eigen::MatrixXd rest;                     ///< whitened
        Eigen::MatrixXd test;                     ///< whitened
        std::vector<Eigen::MatrixXd> by_channel;  ///< of the test, SI
    };
    [[nodiscard]] Eigen::VectorXd solution(const Eigen::MatrixXd& sums, const std::vector<Eigen::Index>& columns,
                                           const Eigen::VectorXd& start, const std::vector<bool>& held) const;
    [[nodiscard]] Eigen::VectorXd bounded(const Eigen::MatrixXd& sums, const std::vector<Eigen::Index>& columns) const;
    [[nodiscard]] std::vector<Eigen::Index> columns_of(const std::vector<Eigen::Index>& chosen) const;

    Eigen::Index n_;
    Eigen::Index last_;                              ///< the column of what is left
    Eigen::VectorXd precision_;                      ///< [n + m] 0 of signatures
    Eigen::VectorXd pull_;                           ///< [n + m]
    std::vector<std::pair<double, double>> bounds_;  ///< [n + m]
    std::vector<std::vector<bool>> own_;
    Eigen::MatrixXd all_;  ///< whitened, of all rows
    std::vector<FoldSums> folds_;
    std::vector<double> count_;  ///< [n_noises] rows that were left out
};

/// Share of the mean square that is removed, mean over the channels.
[[nodiscard]] double share_removed(const LinearPrediction::MeanSquares& before,
                                   const LinearPrediction::MeanSquares& after);

}  // namespace tiretherm::diagnosis
