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
/// X <- X + M^-1 (B - J X) over eight columns together, which needs a product and a solve each, and truncated conjugate
/// residuals (Krylov) column by column for what a sweep does not make small fast. Buffers are allocated once.
class BlockSolver {
public:
    explicit BlockSolver(int n);

    struct Result {
        bool converged = false;
        int sweeps = 0;  ///< of the eight columns that took most; columns' own solves divided by their number
    };

    /// @param B, X [n_columns][n]; X in: a guess, out: the solution
    /// @param tolerance largest error of a column beside its largest entry, as the last correction lets expect
    [[nodiscard]] Result solve(const Matrix& J, Factor& factor, std::span<const double> B, std::span<double> X,
                               double tolerance);

private:
    [[nodiscard]] Result solve_panel(const Matrix& J, Factor& factor, std::span<const double> B, std::span<double> X,
                                     double tolerance);
    void finish_columns(const Matrix& J, Factor& factor, std::span<const double> B, std::span<double> X,
                        std::span<const double> change, double tolerance, Result& result);

    std::size_t n_;
    // Of the columns that are solved together, [n]:
    std::vector<PanelRow> right_;
    std::vector<PanelRow> solution_;
    std::vector<PanelRow> residual_;
    std::vector<PanelRow> correction_;
    // Of one column, [n]:
    Krylov krylov_;
    std::vector<double> column_;
    std::vector<double> column_residual_;
    std::vector<double> left_;
    double contraction_ = 1.0;  ///< what a sweep leaves of an error, as last seen
};

}  // namespace tiretherm::solver
