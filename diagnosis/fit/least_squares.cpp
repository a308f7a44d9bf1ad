// SPDX-License-Identifier: BSD-3-Clause
// Levenberg-Marquardt by Ceres Solver; the only source that includes it. A trial value at which the model fails is
// rejected without ending the fit.

#include "diagnosis/fit/least_squares.hpp"

#include <cmath>

#include <ceres/ceres.h>
#include <glog/logging.h>

namespace tiretherm::diagnosis {

namespace {

/// The residuals as Ceres asks for them, in units of the scales. Slopes come with every value and are kept: a trial that
/// is accepted is not simulated a second time.
class Whitened final : public ceres::CostFunction {
public:
    explicit Whitened(const LeastSquares& least_squares) : least_squares_(least_squares) {
        set_num_residuals(static_cast<int>(least_squares.n_rows));
        mutable_parameter_block_sizes()->push_back(static_cast<int>(least_squares.start.size()));
    }

    bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override {
        const Eigen::VectorXd x = Eigen::Map<const Eigen::VectorXd>(parameters[0], least_squares_.start.size());
        if (x.size() != at_.size() || x != at_) {
            const std::optional<Residuals> found = least_squares_.residuals(x.cwiseProduct(least_squares_.scale));
            if (!found) {
                return false;
            }
            at_ = x;
            last_ = *found;
        }
        Eigen::Map<Eigen::VectorXd>(residuals, least_squares_.n_rows) = last_.value;
        if (jacobians != nullptr && jacobians[0] != nullptr) {
            using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
            Eigen::Map<RowMajor>(jacobians[0], least_squares_.n_rows, x.size()) =
                last_.slope * least_squares_.scale.asDiagonal();
        }
        return true;
    }

private:
    const LeastSquares& least_squares_;
    mutable Eigen::VectorXd at_;
    mutable Residuals last_;
};

}  // namespace

LeastSquaresResult minimise(const LeastSquares& least_squares) {
    // A trial value at which the model fails is an answer here, not a line on the user's terminal.
    FLAGS_minloglevel = google::FATAL;
    Eigen::VectorXd x = least_squares.start.cwiseQuotient(least_squares.scale);
    ceres::Problem problem;
    problem.AddResidualBlock(new Whitened(least_squares), nullptr, x.data());
    for (int j = 0; j < static_cast<int>(x.size()); ++j) {
        if (std::isfinite(least_squares.low[j])) {
            problem.SetParameterLowerBound(x.data(), j, least_squares.low[j] / least_squares.scale[j]);
        }
        if (std::isfinite(least_squares.high[j])) {
            problem.SetParameterUpperBound(x.data(), j, least_squares.high[j] / least_squares.scale[j]);
        }
    }
    if (least_squares.held >= 0) {
        problem.SetManifold(
            x.data(), new ceres::SubsetManifold(static_cast<int>(x.size()), {static_cast<int>(least_squares.held)}));
    }
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::DENSE_QR;
    options.logging_type = ceres::SILENT;
    options.max_num_iterations = 50;
    options.initial_trust_region_radius = 1e4;
    // The sum of squares is a chi-square: changes of a thousandth say nothing about the parameters.
    options.function_tolerance = 1e-7;
    options.parameter_tolerance = 1e-6;
    options.gradient_tolerance = 1e-8;
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);
    return {.values = x.cwiseProduct(least_squares.scale),
            .sum_of_squares = 2.0 * summary.final_cost,
            .converged = summary.termination_type == ceres::CONVERGENCE,
            .iterations = static_cast<int>(summary.iterations.size())};
}

}  // namespace tiretherm::diagnosis
