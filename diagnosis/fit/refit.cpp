// SPDX-License-Identifier: BSD-3-Clause
// Gauss-Newton steps with parameters held at their bounds and a line search by halving and by a parabola.

#include "diagnosis/fit/refit.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

#include "diagnosis/fit/gauss_newton.hpp"

namespace tiretherm::diagnosis {

namespace {

constexpr int most_halvings = 6;
/// Of any number, in standard deviations: what is left to gain is the square of it.
constexpr double settled = 0.05;
/// A fit that ends with less than this to gain, in log likelihood twice, has ended well.
constexpr double little = 0.1;

/// The model where the fit stands.
void look(const Fit& fit, Refit& at) {
    at.values = fit.values();
    at.scale = fit.scale();
    at.precision = fit.precision().cwiseProduct(at.scale.cwiseAbs2());
    at.slopes = fit.whitened_slopes();
    at.raw = fit.now().slope * at.scale.asDiagonal();
    at.residual = -fit.whitened_residuals();
    at.known = fit.precision().cwiseSqrt().cwiseProduct(fit.prior() - at.values);
    at.simulated = fit.now().simulated;
    at.cost = at.residual.squaredNorm() + at.known.squaredNorm();
}

/// Numbers at a bound that the data push outwards are held there.
void find_bounds(const Fit& fit, const Eigen::VectorXd& downhill, Refit& at) {
    at.at_bound.assign(static_cast<std::size_t>(at.values.size()), false);
    for (Eigen::Index j = 0; j < at.values.size(); ++j) {
        const double slack = 1e-9 * at.scale[j];
        const bool out = (at.values[j] <= fit.low()[j] + slack && downhill[j] <= 0.0) ||
                         (at.values[j] >= fit.high()[j] - slack && downhill[j] >= 0.0);
        at.at_bound[static_cast<std::size_t>(j)] = out;
    }
}

/// S'S + Pi with unit diagonal, numbers at a bound uncoupled.
Eigen::MatrixXd normal_matrix(const Refit& at, Eigen::VectorXd& diagonal) {
    Eigen::MatrixXd A = at.slopes.transpose() * at.slopes;
    A.diagonal() += at.precision;
    for (Eigen::Index j = 0; j < A.rows(); ++j) {
        if (at.at_bound[static_cast<std::size_t>(j)] || !(A(j, j) > 0.0)) {
            A.row(j).setZero();
            A.col(j).setZero();
            A(j, j) = 1.0;
        }
    }
    diagonal = A.diagonal().cwiseSqrt();
    const Eigen::VectorXd inverse = diagonal.cwiseInverse();
    Eigen::MatrixXd unit = inverse.asDiagonal() * A * inverse.asDiagonal();
    // Two numbers that do the same in these data share what there is to explain.
    unit.diagonal().array() += 1e-9;
    return unit;
}

/// Moves the fit along a step: all of it, half of it, a quarter, until the cost falls. Where it falls by less than half of
/// what the step predicts the valley is curved, and the lowest point of the parabola through both ends is tried as
/// well: full steps would cross it from side to side.
/// @param[out] there where the cost is lowest  @returns whether that is lower than `at`
bool go(Fit& fit, const Refit& at, const Eigen::VectorXd& step, double predicted, Refit& there) {
    const auto try_part = [&](double part) {
        const Eigen::VectorXd to =
            (at.values + part * step.cwiseProduct(at.scale)).cwiseMax(fit.low()).cwiseMin(fit.high());
        Refit tried;
        if (fit.move_to(to)) {
            look(fit, tried);
            if (tried.cost < (there.values.size() > 0 ? there.cost : at.cost)) {
                tried.at_bound = at.at_bound;
                there = std::move(tried);
                return true;
            }
        }
        return false;
    };
    for (int halvings = 0; halvings <= most_halvings; ++halvings) {
        const double part = std::ldexp(1.0, -halvings);
        if (try_part(part)) {
            const double fall = at.cost - there.cost;
            const double curvature = (2.0 * predicted * part - fall) / (part * part);
            if (fall < 0.5 * predicted * part && predicted / curvature < part) {
                try_part(predicted / curvature);
            }
            return true;
        }
    }
    return false;
}

}  // namespace

Eigen::VectorXd Refit::deviations() const {
    Eigen::VectorXd diagonal;
    const Eigen::MatrixXd unit = normal_matrix(*this, diagonal);
    const Eigen::MatrixXd inverse = unit.llt().solve(Eigen::MatrixXd::Identity(unit.rows(), unit.cols()));
    Eigen::VectorXd found = inverse.diagonal().cwiseSqrt().cwiseQuotient(diagonal).cwiseProduct(scale);
    for (Eigen::Index j = 0; j < found.size(); ++j) {
        if (at_bound[static_cast<std::size_t>(j)]) {
            found[j] = 0.0;
        }
    }
    return found;
}

GaussNewtonStep gauss_newton_step(const Fit& fit, Refit& at) {
    const Eigen::VectorXd downhill =
        at.slopes.transpose() * at.residual + at.precision.cwiseSqrt().cwiseProduct(at.known);
    find_bounds(fit, downhill, at);
    Eigen::VectorXd diagonal;
    const Eigen::MatrixXd unit = normal_matrix(at, diagonal);
    Eigen::VectorXd free = downhill;
    for (Eigen::Index j = 0; j < free.size(); ++j) {
        free[j] = at.at_bound[static_cast<std::size_t>(j)] ? 0.0 : free[j];
    }
    GaussNewtonStep step{.by = unit.llt().solve(free.cwiseQuotient(diagonal)).cwiseQuotient(diagonal)};
    step.to_gain = step.by.dot(free);
    return step;
}

Refit refit(Fit& fit, int most) {
    Refit at;
    look(fit, at);
    at.at_bound.assign(static_cast<std::size_t>(at.values.size()), false);
    for (at.iterations = 0; at.iterations < most; ++at.iterations) {
        // The predicted gain of a full step is compared with what is noise: a thousandth of a standard deviation.
        const auto [step, predicted] = gauss_newton_step(fit, at);
        if (predicted < settled * settled) {
            at.converged = true;
            break;
        }
        at.converged = predicted < little;
        Refit there;
        if (!go(fit, at, step, predicted, there)) {
            break;  // where little is promised, round-off of the predictions is as large as what is left to gain
        }
        there.iterations = at.iterations;
        there.converged = at.converged;
        at = std::move(there);
    }
    if (!fit.move_to(at.values)) {
        at.status = fit.now().status;
    }
    return at;
}

}  // namespace tiretherm::diagnosis
