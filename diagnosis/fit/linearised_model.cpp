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

Eigen::VectorXd solve(const LinearisedModel& model, const RowIndices& rows, const Eigen::VectorXd& precision,
                      const Eigen::VectorXd& pull) {
    const Eigen::MatrixXd S = model.slopes(rows, Eigen::all);
    Eigen::MatrixXd A = S.transpose() * S;
    A.diagonal() += precision;
    const Eigen::VectorXd b = S.transpose() * model.residual(rows) + pull;
    Eigen::VectorXd diagonal = A.diagonal();
    for (double& entry : diagonal) {
        entry = entry > 0.0 ? 1.0 / std::sqrt(entry) : 0.0;
    }
    Eigen::MatrixXd unit = diagonal.asDiagonal() * A * diagonal.asDiagonal();
    unit.diagonal().array() += 1e-9;
    return diagonal.asDiagonal() * unit.ldlt().solve(diagonal.cwiseProduct(b));
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
