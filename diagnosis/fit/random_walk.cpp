// SPDX-License-Identifier: BSD-3-Clause
// The levels of the walks are taken out of the normal equations; what is left for the steps is made diagonal once, so that each
// size of the steps costs a sum.

#include "diagnosis/fit/random_walk.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

namespace tiretherm::diagnosis {

namespace {

/// tau times the root of the largest eigenvalue: from steps that no data see to steps that only themselves limit.
constexpr double smallest_step = 0.03;
constexpr double largest_step = 1e6;
constexpr double ratio = 1.2;
/// What a level keeps, relative to itself, that the free numbers of the model make up whole.
constexpr double ridge = 1e-9;

/// What a number of each walk and its steps since are in the sum: [m][walks], [m][m - walks].
struct Parts {
    Eigen::MatrixXd levels;
    Eigen::MatrixXd steps;
};
Parts parts_of(Eigen::Index m, const std::vector<Walk>& walks) {
    const auto n = static_cast<Eigen::Index>(walks.size());
    Parts parts{Eigen::MatrixXd::Zero(m, n), Eigen::MatrixXd::Zero(m, m - n)};
    Eigen::Index step = 0;
    for (Eigen::Index w = 0; w < n; ++w) {
        const Walk& walk = walks[static_cast<std::size_t>(w)];
        parts.levels.col(w).segment(walk.first, walk.count).setOnes();
        for (Eigen::Index i = 1; i < walk.count; ++i) {
            parts.steps.col(step++).segment(walk.first + i, walk.count - i).setConstant(std::sqrt(walk.interval));
        }
    }
    return parts;
}

}  // namespace

WalkEstimate estimate_walks(const Eigen::MatrixXd& normal, const Eigen::VectorXd& right,
                            const std::vector<Walk>& walks) {
    const Parts parts = parts_of(right.size(), walks);
    Eigen::MatrixXd of_levels = parts.levels.transpose() * normal * parts.levels;
    of_levels.diagonal() *= 1.0 + ridge;
    const Eigen::LDLT<Eigen::MatrixXd> levels(of_levels);
    const Eigen::VectorXd level = parts.levels * levels.solve(parts.levels.transpose() * right);
    const Eigen::VectorXd variance_of_level =
        (parts.levels * levels.solve(parts.levels.transpose())).diagonal().cwiseMax(0.0);
    if (parts.steps.cols() == 0) {
        return {level, variance_of_level.cwiseSqrt()};
    }
    // Steps beside levels that follow them as the data ask.
    const Eigen::MatrixXd steps =
        parts.steps - parts.levels * levels.solve(parts.levels.transpose() * normal * parts.steps);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> seen(steps.transpose() * normal * steps);
    const Eigen::ArrayXd strength = seen.eigenvalues().cwiseMax(0.0);
    const Eigen::MatrixXd directions = steps * seen.eigenvectors();
    const Eigen::ArrayXd pull = directions.transpose() * right;
    const Eigen::MatrixXd squares = directions.cwiseAbs2();

    Eigen::VectorXd value = Eigen::VectorXd::Zero(right.size());
    Eigen::VectorXd square = value;
    double total = 0.0;
    double best = -std::numeric_limits<double>::infinity();
    for (double size = smallest_step; size < largest_step && strength.maxCoeff() > 0.0; size *= ratio) {
        const double variance = size * size / strength.maxCoeff();
        const Eigen::ArrayXd shrunk = variance / (1.0 + variance * strength);
        // Twice: flat in tau, on a grid of its logarithm.
        const double twice = (pull.square() * shrunk - (variance * strength).log1p()).sum() + 2.0 * std::log(size);
        const double kept = std::exp(std::min(0.0, 0.5 * (best - twice)));  // of the sums so far
        const double weight = std::exp(std::min(0.0, 0.5 * (twice - best)));
        best = std::max(best, twice);
        const Eigen::VectorXd there = level + directions * (shrunk * pull).matrix();
        value = kept * value + weight * there;
        square = kept * square + weight * (there.cwiseAbs2() + variance_of_level + squares * shrunk.matrix());
        total = kept * total + weight;
    }
    if (total <= 0.0) {  // nothing tells steps from levels
        return {level, variance_of_level.cwiseSqrt()};
    }
    value /= total;
    return {value, (square / total - value.cwiseAbs2()).cwiseMax(0.0).cwiseSqrt()};
}

}  // namespace tiretherm::diagnosis
