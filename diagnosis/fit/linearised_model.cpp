// SPDX-License-Identifier: BSD-3-Clause
// Normal equations over chosen rows, solved by Cholesky factorisation, and residuals of rows that were held out.

#include "diagnosis/fit/linearised_model.hpp"

#include <cmath>

#include <Eigen/Cholesky>

namespace tiretherm::diagnosis {

LinearisedModel linearise(const Refit& fit, const Observations& observations) {
    return {.slopes = fit.slopes,
            .raw = fit.raw,
            .residual = fit.residual,
            .left = observations.measured - fit.simulated,
            .precision = fit.precision,
            .known = fit.known};
}

namespace {

/// The normal matrix of some rows, factored with a diagonal of one.
struct NormalMatrix {
    Eigen::VectorXd diagonal;  ///< that scales to it, 0 of a parameter of which nothing is known
    Eigen::LDLT<Eigen::MatrixXd> factor;

    NormalMatrix(const Eigen::MatrixXd& slopes, const Eigen::VectorXd& precision) {
        Eigen::MatrixXd A = slopes.transpose() * slopes;
        A.diagonal() += precision;
        diagonal = A.diagonal();
        for (double& entry : diagonal) {
            entry = entry > 0.0 ? 1.0 / std::sqrt(entry) : 0.0;
        }
        Eigen::MatrixXd unit = diagonal.asDiagonal() * A * diagonal.asDiagonal();
        unit.diagonal().array() += 1e-9;
        factor.compute(unit);
    }
};

}  // namespace

Eigen::VectorXd solve(const LinearisedModel& model, const RowIndices& rows, const Eigen::VectorXd& precision,
                      const Eigen::VectorXd& pull) {
    const Eigen::MatrixXd S = model.slopes(rows, Eigen::all);
    const NormalMatrix normal(S, precision);
    const Eigen::VectorXd b = S.transpose() * model.residual(rows) + pull;
    return normal.diagonal.asDiagonal() * normal.factor.solve(normal.diagonal.cwiseProduct(b));
}

Eigen::MatrixXd covariance(const LinearisedModel& model, const RowIndices& rows) {
    const NormalMatrix normal(model.slopes(rows, Eigen::all), model.precision);
    const Eigen::Index n = normal.diagonal.size();
    return normal.diagonal.asDiagonal() * normal.factor.solve(Eigen::MatrixXd::Identity(n, n)) *
           normal.diagonal.asDiagonal();
}

Eigen::VectorXd solve(const LinearisedModel& model, const RowIndices& rows) {
    return solve(model, rows, model.precision, model.precision.cwiseSqrt().cwiseProduct(model.known));
}

Eigen::VectorXd left_of(const LinearisedModel& model, Eigen::VectorXd step, const RowIndices& test,
                        const std::vector<bool>& own) {
    LinearisedModel there = model;
    for (Eigen::Index j = 0; j < step.size(); ++j) {
        step[j] = own[static_cast<std::size_t>(j)] ? 0.0 : step[j];
    }
    there.residual -= model.slopes * step;
    Eigen::VectorXd precision = model.precision;
    Eigen::VectorXd pull = model.precision.cwiseSqrt().cwiseProduct(model.known);
    for (Eigen::Index j = 0; j < step.size(); ++j) {
        if (!own[static_cast<std::size_t>(j)]) {
            precision[j] = 1e30;
            pull[j] = 0.0;
        }
    }
    step += solve(there, test, precision, pull);
    return model.left(test) - model.raw(test, Eigen::all) * step;
}

}  // namespace tiretherm::diagnosis
