// SPDX-License-Identifier: BSD-3-Clause
// The linear solver over several processes, where the library was built with PETSc.
#pragma once

#include "solver/linear/factor.hpp"

namespace tiretherm::solver {

/// Whether the library was built with PETSc (CMake option TIRETHERM_PETSC).
[[nodiscard]] bool has_petsc();

/// How many simulations with this solver a process makes side by side: 0, as many as the machine has threads, but for PETSc,
/// which has one state for all threads.
[[nodiscard]] inline unsigned side_by_side(LinearSolver of) { return of == LinearSolver::petsc ? 1 : 0; }

/// For a program that may be one of several ranks of mpirun: starts MPI and PETSc. The first rank returns at once and runs
/// the program; the others hold their rows of the matrices and serve the first one's linear solutions until it ends.
/// @returns whether this is the first rank, which has the program to run; always true without PETSc or without mpirun
[[nodiscard]] bool is_first_rank();

}  // namespace tiretherm::solver
