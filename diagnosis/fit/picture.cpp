#include "diagnosis/fit/picture.hpp"

#include <cmath>

#include <Eigen/Cholesky>

namespace tiretherm::diagnosis {

Picture picture_of(const Refit& fit, const Observations& observations) {
    return {.slopes = fit.slopes,
            .raw = fit.raw,
            .residual = fit.residual,
            .left = observations.measured - fit.simulated,
            .precision = fit.precision,
            .known = fit.known};
}

Picture with_column(Picture picture, const Eigen::VectorXd& whitened, const Eigen::VectorXd& raw) {
    const Eigen::Index n = picture.slopes.cols();
    picture.slopes.conservativeResize(Eigen::NoChange, n + 1);
    picture.raw.conservativeResize(Eigen::NoChange, n + 1);
    picture.slopes.col(n) = whitened;
    picture.raw.col(n) = raw;
    picture.precision.conservativeResize(n + 1);
    picture.known.conservativeResize(n + 1);
    picture.precision[n] = picture.known[n] = 0.0;
    return picture;
}

Eigen::VectorXd solve(const Picture& picture, const Rows& rows, const Eigen::VectorXd& precision,
                      const Eigen::VectorXd& pull) {
    const Eigen::MatrixXd S = picture.slopes(rows, Eigen::all);
    Eigen::MatrixXd A = S.transpose() * S;
    A.diagonal() += precision;
    const Eigen::VectorXd b = S.transpose() * picture.residual(rows) + pull;
    Eigen::VectorXd diagonal = A.diagonal();
    for (double& entry : diagonal) {
        entry = entry > 0.0 ? 1.0 / std::sqrt(entry) : 0.0;
    }
    Eigen::MatrixXd unit = diagonal.asDiagonal() * A * diagonal.asDiagonal();
    unit.diagonal().array() += 1e-9;
    return diagonal.asDiagonal() * unit.ldlt().solve(diagonal.cwiseProduct(b));
}

Eigen::VectorXd solve(const Picture& picture, const Rows& rows) {
    return solve(picture, rows, picture.precision, picture.precision.cwiseSqrt().cwiseProduct(picture.known));
}

Eigen::VectorXd left_of(const Picture& picture, Eigen::VectorXd step, const Rows& test, const std::vector<bool>& own) {
    Picture there = picture;
    for (Eigen::Index j = 0; j < step.size(); ++j) {
        step[j] = own[static_cast<std::size_t>(j)] ? 0.0 : step[j];
    }
    there.residual -= picture.slopes * step;
    Eigen::VectorXd precision = picture.precision;
    Eigen::VectorXd pull = picture.precision.cwiseSqrt().cwiseProduct(picture.known);
    for (Eigen::Index j = 0; j < step.size(); ++j) {
        if (!own[static_cast<std::size_t>(j)]) {
            precision[j] = 1e30;
            pull[j] = 0.0;
        }
    }
    step += solve(there, test, precision, pull);
    return picture.left(test) - picture.raw(test, Eigen::all) * step;
}

}  // namespace tiretherm::diagnosis
