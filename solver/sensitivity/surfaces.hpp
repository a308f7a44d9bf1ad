// SPDX-License-Identifier: BSD-3-Clause
// Sensitivities of surfaces without capacity at the begin of a step: they follow their cells at once.
#pragma once

#include <span>
#include <vector>

#include "solver/status.hpp"
#include "solver/system.hpp"

namespace tiretherm::solver {

/// Surfaces without capacity: J_ss x_s = scale right_s - J_sc x_c, by the diagonal of J_ss, which has little beside it.
/// Buffers are allocated once.
class SurfaceSettling {
public:
    /// @param system lives longer
    explicit SurfaceSettling(const System& system);

    /// @param J of the explicit stage, or its transpose  @param x, right [n_columns][n_nodes]; x of cells stays
    /// @param tolerance relative to the largest of a column, at which it ends
    /// @returns not_converged where the last change was above 1e-9 of the largest
    [[nodiscard]] Status settle(const Matrix& J, std::span<const double> right, double scale, double tolerance,
                                std::span<double> x);

private:
    void find_rows(const Matrix& J);
    void find_residual(const Matrix& J, std::span<const double> right, double scale, std::span<const double> x);

    /// An entry of a surface's row.
    struct Entry {
        std::size_t column;
        double value;
    };
    std::vector<std::size_t> surfaces_;
    std::vector<Entry> entries_;
    std::vector<std::size_t> first_;  ///< [n_surfaces + 1] into entries_
    std::vector<double> diagonal_;    ///< [n_surfaces]
    std::vector<double> residual_;    ///< [n_nodes] of the surfaces; of no use elsewhere
    std::vector<std::size_t> cells_;
};

}  // namespace tiretherm::solver
