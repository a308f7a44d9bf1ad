// SPDX-License-Identifier: BSD-3-Clause
// Sweeps over all columns until the estimated error is small; when a sweep leaves more than 35 % of the error, the
// remaining columns go to the Krylov iteration.

#include "solver/linear/block_solver.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace tiretherm::solver {

namespace {

/// A sweep that leaves more than this of an error is worse than conjugate residuals.
constexpr double slow = 0.35;
constexpr int most_sweeps = 40;
/// What the first sweep of a call is taken to leave at least: matrix and factor may be others than when it was seen.
constexpr double least_left = 0.05;

double largest_value(std::span<const double> values) {
    std::array<double, 4> most{};  // side by side: one alone would wait for each comparison
    std::size_t i = 0;
    for (; i + 4 <= values.size(); i += 4) {
        for (std::size_t k = 0; k < 4; ++k) {
            const double size = std::abs(values[i + k]);
            most[k] = size > most[k] ? size : most[k];
        }
    }
    for (; i < values.size(); ++i) {
        most[0] = std::max(most[0], std::abs(values[i]));
    }
    return std::ranges::max(most);
}

}  // namespace

BlockSolver::BlockSolver(int n, std::size_t n_columns)
    : n_(static_cast<std::size_t>(n)),
      n_columns_(n_columns),
      residual_(n_ * n_columns),
      correction_(n_ * n_columns),
      change_(n_columns),
      krylov_(n),
      column_(n_),
      left_(n_) {}

BlockSolver::Result BlockSolver::solve(const Matrix& J, Factor& factor, std::span<const double> B, std::span<double> X,
                                       double tolerance) {
    Result result;
    double before = 0.0;
    while (result.sweeps < most_sweeps) {
        J.multiply_block(X, residual_, n_columns_);
        for (std::size_t i = 0; i < residual_.size(); ++i) {
            residual_[i] = B[i] - residual_[i];
        }
        factor.solve_block(residual_, correction_, n_columns_);
        ++result.sweeps;
        double now = 0.0;
        for (std::size_t j = 0; j < n_columns_; ++j) {
            const std::span<double> x = X.subspan(j * n_, n_);
            const std::span<const double> correction = std::span(correction_).subspan(j * n_, n_);
            for (std::size_t i = 0; i < n_; ++i) {
                x[i] += correction[i];
            }
            const double size = largest_value(x);
            change_[j] = size > 0.0 ? largest_value(correction) / size : 0.0;
            now = std::max(now, change_[j]);
        }
        if (!std::isfinite(now)) {
            return result;
        }
        if (before > 0.0) {
            contraction_ = now / before;
        }
        const double left = before > 0.0 ? contraction_ : std::max(least_left, contraction_);
        before = now;
        // What the next sweep would change, were it to contract as the last.
        if (now * std::min(1.0, left / std::max(1e-3, 1.0 - left)) <= tolerance) {
            result.converged = true;
            return result;
        }
        if (result.sweeps > 1 && contraction_ > slow) {
            result.converged = finish_columns(J, factor, B, X, tolerance, result);
            return result;
        }
    }
    return result;
}

bool BlockSolver::finish_columns(const Matrix& J, Factor& factor, std::span<const double> B, std::span<double> X,
                                 double tolerance, Result& result) {
    J.multiply_block(X, residual_, n_columns_);
    int solves = 0;
    bool converged = true;
    for (std::size_t j = 0; j < n_columns_; ++j) {
        if (change_[j] * contraction_ <= tolerance) {
            continue;
        }
        const std::span<double> x = X.subspan(j * n_, n_);
        const std::span<double> r = std::span(residual_).subspan(j * n_, n_);
        for (std::size_t i = 0; i < n_; ++i) {
            r[i] = B[j * n_ + i] - r[i];
        }
        const Krylov::Result found = krylov_.solve(J, factor, r, column_, left_, tolerance * largest_value(x), 0.0);
        converged = converged && found.converged;
        solves += found.solves;
        for (std::size_t i = 0; i < n_; ++i) {
            x[i] += column_[i];
        }
    }
    result.sweeps += (solves + static_cast<int>(n_columns_) - 1) / static_cast<int>(n_columns_);
    return converged;
}

}  // namespace tiretherm::solver
