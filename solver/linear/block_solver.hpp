// SPDX-License-Identifier: BSD-3-Clause
// Solves J X = B for several right-hand sides with the kept factor M of a matrix near J: X <- X + M^-1 (B - J X). Used
// by tangent and adjoint.
#pragma once

#include <span>
#include <vector>

#include "solver/linear/factor.hpp"
#include "solver/linear/krylov.hpp"
#include "solver/linear/matrix.hpp"

namespace tiretherm::solver {

/// Solves J X = B for several right-hand sides at once with the kept factor of a matrix near J: a corrected sweep
/// X <- X + M^-1 (B - J X) over all columns together, which needs a product and a solve each, and truncated conjugate
/// residuals (Krylov) column by column for what a sweep does not make small fast. Buffers are allocated once.
class BlockSolver {
public:
    BlockSolver(int n, std::size_t n_columns);

    struct Result {
        bool converged = false;
        int sweeps = 0;  ///< block solves, and the columns' own ones divided by their number
    };

    /// @param B, X [n_columns][n]; X in: a guess, out: the solution
    /// @param tolerance largest error of a column beside its largest entry, as the last correction lets expect
    [[nodiscard]] Result solve(const Matrix& J, Factor& factor, std::span<const double> B, std::span<double> X,
                               double tolerance);

private:
    [[nodiscard]] bool finish_columns(const Matrix& J, Factor& factor, std::span<const double> B, std::span<double> X,
                                      double tolerance, Result& result);

    std::size_t n_;
    std::size_t n_columns_;
    std::vector<double> residual_;    ///< [n_columns][n]
    std::vector<double> correction_;  ///< [n_columns][n]
    std::vector<double> change_;      ///< [n_columns] largest entry of the last correction beside that of the solution
    Krylov krylov_;
    std::vector<double> column_;
    std::vector<double> left_;
    double contraction_ = 1.0;  ///< what a sweep leaves of an error, as last seen
};

}  // namespace tiretherm::solver
