// SPDX-License-Identifier: BSD-3-Clause
// Fit of a model with the noise held, by the Gauss-Newton method within bounds, and the linearisation at its end.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "diagnosis/fit/fit.hpp"

namespace tiretherm::diagnosis {

/// A model fitted to the data with the noise held, and its linearisation there.
struct Refit {
    solver::Status status;
    Eigen::VectorXd values;     ///< [n]
    Eigen::VectorXd scale;      ///< [n] unit of each number in what follows
    Eigen::MatrixXd slopes;     ///< [n_rows][n] whitened
    Eigen::MatrixXd raw;        ///< [n_rows][n] the same in SI
    Eigen::VectorXd precision;  ///< [n] of what was known
    Eigen::VectorXd residual;   ///< [n_rows] whitened, measured - simulated
    Eigen::VectorXd known;      ///< [n] what was known less the value, in standard deviations
    Eigen::VectorXd simulated;  ///< [n_rows] SI
    std::vector<bool> at_bound;
    double cost = 0.0;  ///< sum of squares, of what was known as well
    int iterations = 0;
    bool converged = false;

    /// Standard deviations of the numbers, those at a bound held. @returns [n], 0 at a bound
    [[nodiscard]] Eigen::VectorXd deviations() const;
};

/// Gauss and Newton's method within the bounds, halving a step that makes things worse. Data that are nearly linear in
/// the numbers need three or four predictions.
/// @param fit at values where the model runs, with the noise taken  @param most iterations; 0: as it stands, linearised
[[nodiscard]] Refit refit(Fit& fit, int most = 12);

}  // namespace tiretherm::diagnosis
