// SPDX-License-Identifier: BSD-3-Clause
// Cholesky, incomplete Cholesky and Krylov solvers against multiplying back, and messages about indefinite matrices.

#include <gtest/gtest.h>

#include "solver/linear/factor.hpp"
#include "solver/linear/krylov.hpp"
#include "tests/solver/linear/diffusion_matrix.hpp"

namespace tiretherm::solver {

TEST(Pattern, HasTheDiagonalAndBothPlacesOfEveryFace) {
    const mesh::Mesh mesh = cube(3);
    const Pattern p = pattern_of(mesh);
    EXPECT_EQ(p.n, mesh.n_nodes);
    EXPECT_EQ(p.nonzeros(), static_cast<std::size_t>(mesh.n_nodes) + 2 * mesh.faces.size());
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
        EXPECT_EQ(p.column[static_cast<std::size_t>(p.ab[f])], mesh.faces[f].b);
        EXPECT_EQ(p.column[static_cast<std::size_t>(p.ba[f])], mesh.faces[f].a);
    }
}

TEST(Cholesky, SolvesToRoundOff) {
    const mesh::Mesh mesh = cube(6);
    const Pattern pattern = pattern_of(mesh);
    const Matrix A = diffusion(mesh, pattern, 0.5);
    const std::vector<double> exact = random_vector(pattern.n);
    std::vector<double> b(exact.size());
    std::vector<double> x(exact.size());
    A.multiply(exact, b);
    const auto factor = make_cholesky(pattern);
    ASSERT_EQ(factor->factorise(A), "");
    factor->solve(b, x);
    for (std::size_t i = 0; i < x.size(); ++i) {
        EXPECT_NEAR(x[i], exact[i], 1e-12);  // condition number about 100
    }
}

TEST(Cholesky, AnotherFactorOfThePatternHasItsOwnNumbers) {
    const mesh::Mesh mesh = cube(8);
    const Pattern pattern = pattern_of(mesh);
    const std::vector<double> exact = random_vector(pattern.n);
    std::vector<double> b(exact.size());
    std::vector<double> x(exact.size());
    const auto first = make_cholesky(pattern);
    ASSERT_EQ(first->factorise(diffusion(mesh, pattern, 0.5)), "");
    const auto second = first->alike();
    ASSERT_EQ(second->factorise(diffusion(mesh, pattern, 2.0)), "");
    EXPECT_EQ(second->description(), first->description());
    EXPECT_EQ(second->factor_cost(), first->factor_cost());
    for (const auto& [factor, s] : {std::pair{first.get(), 0.5}, std::pair{second.get(), 2.0}}) {
        diffusion(mesh, pattern, s).multiply(exact, b);
        factor->solve(b, x);
        for (std::size_t i = 0; i < x.size(); ++i) {
            EXPECT_NEAR(x[i], exact[i], 1e-12);
        }
    }
}

TEST(Cholesky, SaysInASentenceThatAMatrixIsNotPositiveDefinite) {
    // Without capacity and without exchange the constants are in the null space; a little below is indefinite.
    const mesh::Mesh mesh = cube(3);
    const Pattern pattern = pattern_of(mesh);
    const auto factor = make_cholesky(pattern);
    EXPECT_NE(factor->factorise(diffusion(mesh, pattern, -0.1)).find("not positive definite"), std::string::npos);
}

TEST(IncompleteCholesky, SolvesByIterationWhatCholeskySolves) {
    const mesh::Mesh mesh = cube(8);
    const Pattern pattern = pattern_of(mesh);
    const Matrix A = diffusion(mesh, pattern, 0.5);
    const std::vector<double> exact = random_vector(pattern.n);
    std::vector<double> b(exact.size());
    std::vector<double> x(exact.size());
    std::vector<double> residual(exact.size());
    A.multiply(exact, b);
    const auto factor = make_incomplete_cholesky(pattern);
    ASSERT_EQ(factor->factorise(A), "");
    Krylov krylov(pattern.n);
    const Krylov::Result result = krylov.solve(A, *factor, b, x, residual, 1e-10, 0.0);
    EXPECT_TRUE(result.converged);
    EXPECT_GT(result.solves, 3);
    for (std::size_t i = 0; i < x.size(); ++i) {
        EXPECT_NEAR(x[i], exact[i], 1e-8);  // 1e-10 in the preconditioned residual, times the condition number
    }
}

TEST(Krylov, WithAFreshFactorOfASymmetricMatrixOneSolveIsEnough) {
    const mesh::Mesh mesh = cube(4);
    const Pattern pattern = pattern_of(mesh);
    const Matrix A = diffusion(mesh, pattern, 0.5);
    const std::vector<double> b = random_vector(pattern.n);
    std::vector<double> x(b.size());
    std::vector<double> residual(b.size());
    const auto factor = make_cholesky(pattern);
    ASSERT_EQ(factor->factorise(A), "");
    Krylov krylov(pattern.n);
    EXPECT_EQ(krylov.solve(A, *factor, b, x, residual, 1e-9, 0.0).solves, 1);
}

TEST(Krylov, SolvesAnUnsymmetricMatrixWithAnOuterProduct) {
    // J = A with one-sided entries, plus row * mean': checked by multiplying back.
    const mesh::Mesh mesh = cube(5);
    const Pattern pattern = pattern_of(mesh);
    const Matrix A = diffusion(mesh, pattern, 2.0);
    Matrix J = A;
    J.symmetric = false;
    for (const int place : pattern.ab) {
        J.value[static_cast<std::size_t>(place)] *= 0.8;
    }
    const std::vector<double> row = random_vector(pattern.n);
    J.outer.push_back({.row = row, .mean = &mesh.regions[1].mean, .scale = 0.7});
    const std::vector<double> b = random_vector(pattern.n);
    std::vector<double> x(b.size());
    std::vector<double> residual(b.size());
    std::vector<double> back(b.size());
    const auto factor = make_cholesky(pattern);
    ASSERT_EQ(factor->factorise(A), "");
    Krylov krylov(pattern.n);
    EXPECT_TRUE(krylov.solve(J, *factor, b, x, residual, 1e-11, 0.0).converged);
    J.multiply(x, back);
    for (std::size_t i = 0; i < b.size(); ++i) {
        EXPECT_NEAR(back[i], b[i], 1e-8);
        EXPECT_NEAR(b[i] - back[i], residual[i], 1e-10);  // the residual it returns is the true one
    }
}

// 35 937 cells are above the length from which the iteration takes its memory with the first solution.
TEST(Krylov, SolvesOnALargeMesh) {
    const mesh::Mesh mesh = cube(33);
    const Pattern pattern = pattern_of(mesh);
    const Matrix J = diffusion(mesh, pattern, 5.0);
    const auto factor = make_incomplete_cholesky(pattern);
    ASSERT_EQ(factor->factorise(J), "");
    const std::vector<double> b = random_vector(pattern.n);
    std::vector<double> x(b.size());
    std::vector<double> residual(b.size());
    EXPECT_TRUE(Krylov(pattern.n).solve(J, *factor, b, x, residual, 1e-9, 0.0).converged);
    std::vector<double> back(b.size());
    J.multiply(x, back);
    for (std::size_t i = 0; i < b.size(); ++i) {
        ASSERT_NEAR(back[i], b[i], 1e-6);  // x is good to 1e-9, entries of J go up to 65
    }
}

TEST(MakeFactor, TakesCholeskyForAPlaneAndIterationForABlock) {
    const std::vector<mesh::Segment> side{{.to = 0.01, .cells = 22}};
    const std::vector<mesh::Layer> stack{{.name = "a", .thickness = 0.01, .cells = 22}};
    const mesh::Mesh plane = mesh::build(mesh::Axisymmetric{.radius = side, .stack = stack});
    const mesh::Mesh block = mesh::build(mesh::Block{.x = side, .y = side, .stack = stack});
    EXPECT_NE(make_factor(pattern_of(plane), LinearSolver::automatic)->description().find("CHOLMOD"),
              std::string::npos);
    const Pattern pattern = pattern_of(block);
    EXPECT_NE(make_factor(pattern, LinearSolver::automatic)->description().find("incomplete"), std::string::npos);
    EXPECT_NE(make_factor(pattern, LinearSolver::cholesky)->description().find("CHOLMOD"), std::string::npos);
}

// Minimum degree leaves 203 entries a row here, METIS 147 (CHOLMOD 3.0.14).
TEST(MakeFactor, LooksLongerForAnOrderOnlyWhereTheFactorIsTaken) {
    const Pattern pattern = pattern_of(cube(30));
    const std::string words = make_factor(pattern, LinearSolver::cholesky)->description();
    const double entries = std::stod(words.substr(words.rfind(", ") + 2));
    EXPECT_LT(entries, 175.0 * pattern.n) << words;
    EXPECT_NE(make_factor(pattern, LinearSolver::automatic)->description().find("incomplete"), std::string::npos);
}

}  // namespace tiretherm::solver
