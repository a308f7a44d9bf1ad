// SPDX-License-Identifier: BSD-3-Clause
// Sensitivities of surfaces without capacity at the begin of a step: they follow their cells at once.
#pragma once

#include <span>

#include "solver/status.hpp"
#include "solver/system.hpp"

namespace tiretherm::solver {

/// Surfaces without capacity: J_ss x_s = scale right_s - J_sc x_c, by the diagonal of J_ss, which has little beside it.
/// @param J of the explicit stage, or its transpose  @param x, right, product [n_columns][n_nodes]; x of cells stays
/// @param tolerance relative to the largest of a column, at which it ends
/// @returns not_converged where the last change was above 1e-9 of the largest
[[nodiscard]] Status settle_surfaces(const System& system, const Matrix& J, std::span<const double> right, double scale,
                                     double tolerance, std::span<double> x, std::span<double> product);

}  // namespace tiretherm::solver
