// SPDX-License-Identifier: BSD-3-Clause
// Several right-hand sides by the factor of another matrix: what is called converged is, whatever the call before saw.

#include <gtest/gtest.h>

#include "solver/linear/block_solver.hpp"
#include "tests/solver/linear/diffusion_matrix.hpp"

namespace tiretherm::solver {

// The matrix that was factorised has 0.5 on each node beside its conductances, the one to be solved 0.6. One sweep solves the
// first. A sweep on the other leaves 0.6/0.5 - 1 = 0.2 of an error that is even over the nodes, and less of any other. The first
// of a call is taken to leave 0.05 at least: four times the tolerance remain where it is the only one.
TEST(BlockSolver, HoldsItsToleranceWhenTheMatrixLeavesTheFactor) {
    const mesh::Mesh mesh = cube(4);
    const Pattern pattern = pattern_of(mesh);
    const Matrix near = diffusion(mesh, pattern, 0.5);
    const Matrix far = diffusion(mesh, pattern, 0.6);
    const auto factor = make_cholesky(pattern);
    ASSERT_EQ(factor->factorise(near), "");
    constexpr std::size_t columns = 3;
    constexpr double tolerance = 1e-5;
    const auto n = static_cast<std::size_t>(pattern.n);
    const std::vector<double> exact(columns * n, 2.0);
    std::vector<double> B(exact.size());
    std::vector<double> X(exact.size(), 0.0);
    BlockSolver solver(pattern.n, columns);
    near.multiply_block(exact, B, columns);
    ASSERT_TRUE(solver.solve(near, *factor, B, X, tolerance).converged);
    far.multiply_block(exact, B, columns);
    for (const double guess : {0.0, 1.0, 1.999, 1.9999}) {
        std::fill(X.begin(), X.end(), guess);
        ASSERT_TRUE(solver.solve(far, *factor, B, X, tolerance).converged);
        for (std::size_t i = 0; i < X.size(); ++i) {
            ASSERT_NEAR(X[i], exact[i], 2.0 * 4.0 * tolerance) << "from " << guess;
        }
        // The next call begins as one after the factor's own matrix.
        near.multiply_block(exact, B, columns);
        std::fill(X.begin(), X.end(), 0.0);
        ASSERT_TRUE(solver.solve(near, *factor, B, X, tolerance).converged);
        far.multiply_block(exact, B, columns);
    }
}

}  // namespace tiretherm::solver
