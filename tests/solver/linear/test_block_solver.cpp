// SPDX-License-Identifier: BSD-3-Clause
// Several right-hand sides by the factor of another matrix: what is called converged is, whatever the call before saw.

#include <random>

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
    BlockSolver solver(pattern.n);
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

// Eleven columns, more than a panel has, of an unsymmetric matrix with a law of a mean, as it is and transposed: every column's
// equations hold. The solutions are good to 1e-12 of their largest, some 1; a row sums seven products of at most 40, and those of
// the law.
TEST(BlockSolver, SolvesMoreColumnsThanAPanelHas) {
    const mesh::Mesh mesh = cube(4);
    const Pattern pattern = pattern_of(mesh);
    Matrix J = diffusion(mesh, pattern, 1.0);
    const auto n = static_cast<std::size_t>(pattern.n);
    const auto factor = make_cholesky(pattern);
    ASSERT_EQ(factor->factorise(J), "");
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    for (std::size_t i = 0; i < n; ++i) {
        J.value[static_cast<std::size_t>(pattern.start[i])] += 0.01;  // to one side of the diagonal alone
    }
    mesh::Functional mean;
    std::vector<double> row(n);
    for (std::size_t i = 0; i < n; ++i) {
        row[i] = any(random);
        if (i % 3 == 0) {
            mean.add(static_cast<int>(i), 1.0);
        }
    }
    mean.normalise();
    J.outer = {{.row = row, .mean = &mean, .scale = 0.1}};
    constexpr std::size_t columns = 11;
    std::vector<double> B(columns * n);
    for (double& value : B) {
        value = any(random);
    }
    BlockSolver solver(pattern.n);
    for (const bool transposed : {false, true}) {
        J.transposed = transposed;
        std::vector<double> X(B.size(), 0.0);
        ASSERT_TRUE(solver.solve(J, *factor, B, X, 1e-12).converged);
        std::vector<double> product(B.size());
        J.multiply_block(X, product, columns);
        for (std::size_t i = 0; i < B.size(); ++i) {
            ASSERT_NEAR(product[i], B[i], 1e-12 * 8.0 * 40.0)
                << "column " << i / n << (transposed ? " transposed" : "");
        }
    }
}

}  // namespace tiretherm::solver
