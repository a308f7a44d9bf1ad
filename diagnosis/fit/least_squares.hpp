// SPDX-License-Identifier: BSD-3-Clause
// Bounded nonlinear least squares of whitened residuals, each parameter in units of its own scale.
#pragma once

#include <functional>
#include <optional>

#include <Eigen/Core>

namespace tiretherm::diagnosis {

/// Whitened residuals at some values, and their slopes.
struct Residuals {
    Eigen::VectorXd value;  ///< [n_rows] simulated - measured, unit variance
    Eigen::MatrixXd slope;  ///< [n_rows][n_parameters]
};

/// A fit by least squares within bounds.
struct LeastSquares {
    std::function<std::optional<Residuals>(const Eigen::VectorXd&)> residuals;  ///< nothing where the model fails
    Eigen::Index n_rows = 0;
    Eigen::VectorXd start;
    Eigen::VectorXd low;
    Eigen::VectorXd high;
    Eigen::VectorXd scale;   ///< > 0: what counts as one unit of each parameter
    Eigen::Index held = -1;  ///< a parameter that stays where it starts
};

struct LeastSquaresResult {
    Eigen::VectorXd values;
    double sum_of_squares = 0.0;
    bool converged = false;
    int iterations = 0;
};

/// Levenberg-Marquardt by Ceres.
[[nodiscard]] LeastSquaresResult minimise(const LeastSquares& least_squares);

}  // namespace tiretherm::diagnosis
