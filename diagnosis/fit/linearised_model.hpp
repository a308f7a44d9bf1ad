// SPDX-License-Identifier: BSD-3-Clause
// A fitted model linearised in its parameters, used to refit it to some of the data and to predict the rest (cross-
// validation).
#pragma once

#include <vector>

#include <Eigen/Core>

#include "diagnosis/fit/refit.hpp"
#include "diagnosis/observations/observation_subset.hpp"

namespace tiretherm::diagnosis {

/// A fitted model, linearised: what it leaves, and how its numbers would change that.
struct LinearisedModel {
    Eigen::MatrixXd slopes;     ///< [n_rows][n] whitened
    Eigen::MatrixXd raw;        ///< [n_rows][n] SI
    Eigen::VectorXd residual;   ///< [n_rows] whitened
    Eigen::VectorXd left;       ///< [n_rows] SI, measured - simulated
    Eigen::VectorXd precision;  ///< [n]
    Eigen::VectorXd known;      ///< [n]
};
[[nodiscard]] LinearisedModel linearise(const Refit& fit, const Observations& observations);

/// Least squares of some rows and of what was known.
/// @param pull [n] of what was known  @returns [n] the step from where the model was linearised
[[nodiscard]] Eigen::VectorXd solve(const LinearisedModel& model, const RowIndices& rows,
                                    const Eigen::VectorXd& precision, const Eigen::VectorXd& pull);
/// The same with what was known as the model has it.
[[nodiscard]] Eigen::VectorXd solve(const LinearisedModel& model, const RowIndices& rows);

/// Covariance of the parameters by some rows and by what was known. @returns [n][n] in the scales of the fit
[[nodiscard]] Eigen::MatrixXd covariance(const LinearisedModel& model, const RowIndices& rows);

/// What is left of rows that took no part, SI: numbers of all runs as the others gave them, those of the run (how it
/// started) from itself.
/// @param step [n] that the other rows gave  @param own [n] whether a number belongs to the run
[[nodiscard]] Eigen::VectorXd left_of(const LinearisedModel& model, Eigen::VectorXd step, const RowIndices& test,
                                      const std::vector<bool>& own);

}  // namespace tiretherm::diagnosis
