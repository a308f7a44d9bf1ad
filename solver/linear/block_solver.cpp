// SPDX-License-Identifier: BSD-3-Clause
// Sweeps over eight columns at a time until the estimated error is small; when a sweep leaves more than 35 % of the
// error, the columns that need more go to the Krylov iteration.

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
    double most = 0.0;
    for (const double value : values) {
        most = std::max(most, std::abs(value));
    }
    return most;
}

/// Adds a correction. @returns of each column the largest entry of the correction beside that of the sum
std::array<double, panel_width> add_correction(ConstPanel correction, Panel to) {
    PanelRow size{};
    PanelRow change{};
    in_wide_vectors([&] {
        PanelRow most{};
        PanelRow most_by{};
        for (std::size_t i = 0; i < to.size(); ++i) {
            to[i] += correction[i];
            for (std::size_t h = 0; h < most.half.size(); ++h) {
                const PanelRow::Half here = to[i].half[h] < 0.0 ? -to[i].half[h] : to[i].half[h];
                const PanelRow::Half by = correction[i].half[h] < 0.0 ? -correction[i].half[h] : correction[i].half[h];
                most.half[h] = here > most.half[h] ? here : most.half[h];
                most_by.half[h] = by <= most_by.half[h] ? most_by.half[h] : by;  // what is no number goes on
            }
        }
        size = most;
        change = most_by;
    });
    std::array<double, panel_width> shares{};
    for (std::size_t c = 0; c < panel_width; ++c) {
        shares[c] = size[c] > 0.0 ? change[c] / size[c] : 0.0;
    }
    return shares;
}

}  // namespace

BlockSolver::BlockSolver(int n)
    : n_(static_cast<std::size_t>(n)),
      right_(n_),
      solution_(n_),
      residual_(n_),
      correction_(n_),
      krylov_(n),
      column_(n_),
      column_residual_(n_),
      left_(n_) {}

BlockSolver::Result BlockSolver::solve(const Matrix& J, Factor& factor, std::span<const double> B, std::span<double> X,
                                       double tolerance) {
    const std::size_t n_columns = X.size() / n_;
    Result result{.converged = true};
    for (std::size_t first = 0; first < n_columns; first += panel_width) {
        const std::size_t width = std::min(panel_width, n_columns - first);
        const Result one =
            solve_panel(J, factor, B.subspan(first * n_, width * n_), X.subspan(first * n_, width * n_), tolerance);
        result.converged = result.converged && one.converged;
        result.sweeps = std::max(result.sweeps, one.sweeps);
    }
    return result;
}

/// @param B, X [width][n]
BlockSolver::Result BlockSolver::solve_panel(const Matrix& J, Factor& factor, std::span<const double> B,
                                             std::span<double> X, double tolerance) {
    Result result;
    double before = 0.0;
    pack(B, right_);
    pack(X, solution_);
    while (result.sweeps < most_sweeps) {
        J.find_residual(right_, solution_, residual_);
        factor.solve_panel(residual_, correction_);
        ++result.sweeps;
        const std::array<double, panel_width> change = add_correction(correction_, solution_);
        double now = 0.0;
        for (const double of_column : change) {
            if (!std::isfinite(of_column)) {
                return result;
            }
            now = std::max(now, of_column);
        }
        if (before > 0.0) {
            contraction_ = now / before;
        }
        const double left = before > 0.0 ? contraction_ : std::max(least_left, contraction_);
        before = now;
        // What the next sweep would change, were it to contract as the last.
        result.converged = now * std::min(1.0, left / std::max(1e-3, 1.0 - left)) <= tolerance;
        const bool is_slow = result.sweeps > 1 && contraction_ > slow;
        if (result.converged || is_slow) {
            unpack(solution_, X);
            if (!result.converged) {
                finish_columns(J, factor, B, X, change, tolerance, result);
            }
            return result;
        }
    }
    return result;
}

/// @param change of each column by the last sweep, beside its largest entry
void BlockSolver::finish_columns(const Matrix& J, Factor& factor, std::span<const double> B, std::span<double> X,
                                 std::span<const double> change, double tolerance, Result& result) {
    const std::size_t width = X.size() / n_;
    int solves = 0;
    result.converged = true;
    for (std::size_t j = 0; j < width; ++j) {
        if (change[j] * contraction_ <= tolerance) {
            continue;
        }
        const std::span<double> x = X.subspan(j * n_, n_);
        J.multiply(x, column_residual_);
        for (std::size_t i = 0; i < n_; ++i) {
            column_residual_[i] = B[j * n_ + i] - column_residual_[i];
        }
        const Krylov::Result found =
            krylov_.solve(J, factor, column_residual_, column_, left_, tolerance * largest_value(x), 0.0);
        result.converged = result.converged && found.converged;
        solves += found.solves;
        for (std::size_t i = 0; i < n_; ++i) {
            x[i] += column_[i];
        }
    }
    result.sweeps += (solves + static_cast<int>(width) - 1) / static_cast<int>(width);
}

}  // namespace tiretherm::solver
