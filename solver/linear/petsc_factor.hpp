// SPDX-License-Identifier: BSD-3-Clause
// The linear solver over several processes, where the library was built with PETSc.
#pragma once

namespace tiretherm::solver {

/// Whether the library was built with PETSc (CMake option TIRETHERM_PETSC).
[[nodiscard]] bool has_petsc();

/// For a program that may be one of several ranks of mpirun: starts MPI and PETSc. The first rank returns at once and runs
/// the program; the others hold their rows of the matrices and serve the first one's linear solutions until it ends.
/// @returns whether this is the first rank, which has the program to run; always true without PETSc or without mpirun
[[nodiscard]] bool is_first_rank();

}  // namespace tiretherm::solver
