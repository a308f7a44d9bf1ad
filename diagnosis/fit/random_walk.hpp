// SPDX-License-Identifier: BSD-3-Clause
// Numbers that follow each other, such as the heat of windows of time, estimated together as random walks.
#pragma once

#include <vector>

#include <Eigen/Core>

namespace tiretherm::diagnosis {

/// Consecutive entries of a vector of numbers that are one walk.
struct Walk {
    Eigen::Index first = 0;
    Eigen::Index count = 0;  ///< > 0
    double interval = 1.0;   ///< s between two entries, > 0: a step's variance grows with it
};

/// Numbers as they are after the data, in the unit of the problem.
struct WalkEstimate {
    Eigen::VectorXd value;      ///< [m] posterior mean
    Eigen::VectorXd deviation;  ///< [m] posterior standard deviation
};

/// Generalised least squares of y = X u + e, with e of unit variance, where each walk begins anywhere (a flat prior) and its steps
/// are independent, of mean 0 and variance tau^2 interval. So the steps are penalised and the level is not: nothing is drawn
/// towards zero. One tau holds for all walks; the restricted likelihood (REML; Patterson and Thompson, Biometrika 58 (1971) 545)
/// says how likely each is, and value and deviation are means over a grid of them with a flat prior (Gelman, Bayesian
/// Analysis 1 (2006) 515). The single most likely tau would make intervals too short where the data say little of it.
/// Deterministic.
/// @param normal [m][m] X'X  @param right [m] X'y  @param walks that cover 0 to m - 1 in order, each seen by the data
[[nodiscard]] WalkEstimate estimate_walks(const Eigen::MatrixXd& normal, const Eigen::VectorXd& right,
                                          const std::vector<Walk>& walks);

}  // namespace tiretherm::diagnosis
