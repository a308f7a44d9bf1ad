// SPDX-License-Identifier: BSD-3-Clause
// Modified incomplete Cholesky: exact where there is no fill, row sums kept, conjugate gradients to the accuracy asked for.

#include <algorithm>
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "solver/linear/factor.hpp"
#include "tests/solver/linear/diffusion_matrix.hpp"

namespace tiretherm::solver {
namespace {

/// Length of a vector in the energy of a matrix.
double energy(const Matrix& A, const std::vector<double>& x) {
    std::vector<double> Ax(x.size());
    A.multiply(x, Ax);
    return std::sqrt(std::inner_product(x.begin(), x.end(), Ax.begin(), 0.0));
}

TEST(IncompleteFactor, IsTheExactFactorOfAChain) {
    // Elimination along a chain fills nothing in, so that what is left out is nothing. The surfaces, which come last in the
    // order and touch the first cell, are cut off.
    const mesh::Mesh chain =
        mesh::build(mesh::Layers{.area = 0.5, .stack = {{.name = "a", .thickness = 0.01, .cells = 30}}});
    const Pattern pattern = pattern_of(chain);
    Matrix A = diffusion(chain, pattern, 0.5);
    for (std::size_t f = 0; f < chain.faces.size(); ++f) {
        if (std::max(chain.faces[f].a, chain.faces[f].b) >= chain.n_cells) {
            A.value[static_cast<std::size_t>(pattern.ab[f])] = A.value[static_cast<std::size_t>(pattern.ba[f])] = 0.0;
        }
    }
    const std::vector<double> exact = random_vector(pattern.n);
    std::vector<double> b(exact.size());
    std::vector<double> x(exact.size());
    A.multiply(exact, b);
    const auto factor = make_incomplete_cholesky(pattern);
    ASSERT_EQ(factor->factorise(A), "");
    factor->solve(b, x);
    for (std::size_t i = 0; i < x.size(); ++i) {
        EXPECT_NEAR(x[i], exact[i], 1e-10);  // condition number about 100
    }
    EXPECT_EQ(factor->solve_to(1e-6, b, x), 1);
}

// A factor that keeps row sums sees smooth errors as they are: M^-1 A 1 is near 1, where one of order 0 without that falls
// far short. 2 % of the fill are not kept.
TEST(IncompleteFactor, NearlyKeepsRowSums) {
    const mesh::Mesh mesh = cube(10);
    const Pattern pattern = pattern_of(mesh);
    const Matrix A = diffusion(mesh, pattern, 0.5);
    const std::vector<double> ones(static_cast<std::size_t>(pattern.n), 1.0);
    std::vector<double> b(ones.size());
    std::vector<double> x(ones.size());
    A.multiply(ones, b);
    const auto factor = make_incomplete_cholesky(pattern);
    ASSERT_EQ(factor->factorise(A), "");
    factor->solve(b, x);
    const double mean = std::accumulate(x.begin(), x.end(), 0.0) / static_cast<double>(x.size());
    EXPECT_GT(mean, 0.8);
    EXPECT_LT(mean, 1.01);
}

TEST(IncompleteFactor, SolvesToTheAccuracyAskedFor) {
    const mesh::Mesh mesh = cube(12);
    const Pattern pattern = pattern_of(mesh);
    const Matrix A = diffusion(mesh, pattern, 0.5);
    const std::vector<double> exact = random_vector(pattern.n);
    std::vector<double> b(exact.size());
    std::vector<double> x(exact.size());
    A.multiply(exact, b);
    const auto factor = make_incomplete_cholesky(pattern);
    ASSERT_EQ(factor->factorise(A), "");
    int before = 0;
    for (const double accuracy : {1e-1, 1e-3, 1e-6, 1e-10}) {
        const int solves = factor->solve_to(accuracy, b, x);
        EXPECT_GT(solves, before);
        before = solves;
        std::vector<double> error(x.size());
        for (std::size_t i = 0; i < x.size(); ++i) {
            error[i] = x[i] - exact[i];
        }
        // The residual is measured by the factor, the error by the matrix: eigenvalues of M^-1 A between 0.3 and 3 let the
        // two differ by the root of their ratio.
        EXPECT_LT(energy(A, error), std::sqrt(10.0) * accuracy * energy(A, exact)) << accuracy;
    }
    EXPECT_LT(before, 60);
}

TEST(IncompleteFactor, SaysThatItDidNotConverge) {
    const mesh::Mesh mesh = cube(4);
    const Pattern pattern = pattern_of(mesh);
    const auto factor = make_incomplete_cholesky(pattern);
    ASSERT_EQ(factor->factorise(diffusion(mesh, pattern, 0.5)), "");
    std::vector<double> b = random_vector(pattern.n);
    std::vector<double> x(b.size());
    b[3] = std::nan("");
    EXPECT_NE(factor->solve_to(1e-3, b, x), 0);
    b = std::vector<double>(x.size(), 0.0);
    EXPECT_EQ(factor->solve_to(1e-3, b, x), 0);
    EXPECT_EQ(x[3], 0.0);
}

TEST(IncompleteFactor, IsMadeAgainFromItsValuesToTheLastDigit) {
    const mesh::Mesh mesh = cube(6);
    const Pattern pattern = pattern_of(mesh);
    const auto factor = make_incomplete_cholesky(pattern);
    const auto again = make_incomplete_cholesky(pattern);
    ASSERT_EQ(factor->factorise(diffusion(mesh, pattern, 0.5)), "");
    ASSERT_EQ(again->factorise_again(factor->values()), "");
    const std::vector<double> b = random_vector(pattern.n);
    std::vector<double> x(b.size());
    std::vector<double> y(b.size());
    factor->solve_to(1e-4, b, x);
    again->solve_to(1e-4, b, y);
    EXPECT_EQ(x, y);
}

TEST(IncompleteFactor, SaysInASentenceThatAMatrixIsNotPositiveDefinite) {
    const mesh::Mesh mesh = cube(3);
    const Pattern pattern = pattern_of(mesh);
    const auto factor = make_incomplete_cholesky(pattern);
    EXPECT_NE(factor->factorise(diffusion(mesh, pattern, -5.0)).find("not positive definite"), std::string::npos);
}

}  // namespace
}  // namespace tiretherm::solver
