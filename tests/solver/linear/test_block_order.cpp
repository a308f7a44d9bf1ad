// SPDX-License-Identifier: BSD-3-Clause
// Blocks of nodes that do not touch, and the incomplete factor in their order beside one in the order of the nodes.

#include "solver/linear/block_order.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "mesh/index.hpp"
#include "mesh/parallel.hpp"
#include "solver/linear/factor.hpp"
#include "tests/solver/linear/diffusion_matrix.hpp"
#include "tests/support/threads.hpp"

namespace tiretherm::solver {
namespace {

/// 32 x 32 x 32 cells and their 6144 surface nodes: four blocks.
struct Cube {
    mesh::Mesh mesh = cube(32);
    Pattern pattern = pattern_of(mesh);
    Matrix A = diffusion(mesh, pattern, 0.5);
    std::vector<double> b = random_vector(pattern.n);
};

/// Conjugate gradients preconditioned by MIC(0) in the order of the nodes, as a textbook has them: Golub and van Loan, Matrix
/// Computations, 10.3; the pivots of Gustafsson with 98 % of the fill. @returns iterations until the residual in M^-1 is `accuracy`
int natural_iterations(const Matrix& A, const std::vector<double>& b, double accuracy) {
    const Pattern& p = *A.pattern;
    const std::size_t n = b.size();
    std::vector<double> pivot(n);
    for (std::size_t i = 0; i < n; ++i) {
        pivot[i] = A.value[at(p.diagonal[i])];
        for (int e = p.start[i]; e < p.diagonal[i]; ++e) {
            const std::size_t j = at(p.column[at(e)]);
            const double a = A.value[at(e)];
            double fill = -a;
            for (int k = p.diagonal[j] + 1; k < p.start[j + 1]; ++k) {
                fill += A.value[at(k)];
            }
            pivot[i] -= a / pivot[j] * (a + 0.98 * fill);
        }
    }
    const auto precondition = [&](std::vector<double> x) {
        for (std::size_t i = 0; i < n; ++i) {
            for (int e = p.start[i]; e < p.diagonal[i]; ++e) {
                x[i] -= A.value[at(e)] * x[at(p.column[at(e)])];
            }
            x[i] /= pivot[i];
        }
        for (std::size_t i = n; i-- > 0;) {
            for (int e = p.diagonal[i] + 1; e < p.start[i + 1]; ++e) {
                x[i] -= A.value[at(e)] * x[at(p.column[at(e)])] / pivot[i];
            }
        }
        return x;
    };
    const auto dot = [](const std::vector<double>& x, const std::vector<double>& y) {
        return std::inner_product(x.begin(), x.end(), y.begin(), 0.0);
    };
    std::vector<double> r = b;
    std::vector<double> z = precondition(r);
    std::vector<double> direction = z;
    std::vector<double> product(n);
    const double begin = dot(r, z);
    double now = begin;
    int iterations = 0;
    while (now > accuracy * accuracy * begin) {
        A.multiply(direction, product);
        const double step = now / dot(direction, product);
        for (std::size_t i = 0; i < n; ++i) {
            r[i] -= step * product[i];
        }
        z = precondition(r);
        const double next = dot(r, z);
        for (std::size_t i = 0; i < n; ++i) {
            direction[i] = z[i] + next / now * direction[i];
        }
        now = next;
        ++iterations;
    }
    return iterations;
}

TEST(BlockOrder, BlocksOfAPhaseDoNotTouch) {
    const Cube cube;
    const BlockOrder order = block_order_of(cube.pattern);
    std::vector<int> sorted = order.node;
    std::ranges::sort(sorted);
    std::vector<int> all(at(cube.pattern.n));
    std::iota(all.begin(), all.end(), 0);
    EXPECT_EQ(sorted, all);

    ASSERT_GE(order.phase.size(), 3U);
    EXPECT_EQ(order.phase[1], 4);                          // 38 912 nodes, at least 8000 in a block
    EXPECT_GT(order.block[4], cube.pattern.n * 85 / 100);  // three layers of 34 x 34 lie between the blocks: 9 %
    EXPECT_EQ(order.block.back(), cube.pattern.n);
    std::vector<std::size_t> block_of(all.size());
    std::vector<std::size_t> phase_of(all.size());
    for (std::size_t phase = 0; phase + 1 < order.phase.size(); ++phase) {
        for (std::size_t b = at(order.phase[phase]); b < at(order.phase[phase + 1]); ++b) {
            for (int k = order.block[b]; k < order.block[b + 1]; ++k) {
                block_of[at(order.node[at(k)])] = b;
                phase_of[at(order.node[at(k)])] = phase;
            }
        }
    }
    for (const mesh::Face& face : cube.mesh.faces) {
        const bool same_phase = phase_of[at(face.a)] == phase_of[at(face.b)];
        EXPECT_TRUE(!same_phase || block_of[at(face.a)] == block_of[at(face.b)]);
    }
}

TEST(BlockOrder, SmallPatternIsOneBlockInItsOwnOrder) {
    const mesh::Mesh mesh = cube(10);
    const BlockOrder order = block_order_of(pattern_of(mesh));
    EXPECT_EQ(order.block, (std::vector<int>{0, mesh.n_nodes}));
    EXPECT_EQ(order.phase, (std::vector<int>{0, 1}));
    EXPECT_TRUE(std::ranges::is_sorted(order.node));
}

// Fill that is left out between blocks is a little more than in the order of the nodes: a twentieth more iterations at most.
TEST(BlockOrder, CostsHardlyAnyIterations) {
    const Cube cube;
    std::vector<double> x(cube.b.size());
    const auto factor = make_incomplete_cholesky(cube.pattern);
    ASSERT_EQ(factor->factorise(cube.A), "");
    const int natural = natural_iterations(cube.A, cube.b, 1e-8);
    const int blocked = factor->solve_to(1e-8, cube.b, x);
    EXPECT_GT(natural, 20);
    EXPECT_LE(blocked, natural * 105 / 100 + 1);
    std::vector<double> product(x.size());
    cube.A.multiply(x, product);
    for (std::size_t i = 0; i < x.size(); ++i) {
        ASSERT_NEAR(product[i], cube.b[i], 1e-5);  // entries of A up to 60, b of order 1
    }
}

TEST(BlockOrder, FactorHasTheSameDigitsForAnyNumberOfThreads) {
    const Cube cube;
    std::vector<std::vector<double>> found;
    for (const int threads : {1, 2, 3}) {
        const support::Threads now(threads);
        std::vector<double> once(cube.b.size());
        std::vector<double> iterated(cube.b.size());
        Team::with(cube.b.size(), [&] {
            const auto factor = make_incomplete_cholesky(cube.pattern);
            ASSERT_EQ(factor->factorise(cube.A), "");
            factor->solve(cube.b, once);
            EXPECT_GT(factor->solve_to(1e-6, cube.b, iterated), 0);
        });
        found.push_back(once);
        found.push_back(iterated);
    }
    for (std::size_t k = 2; k < found.size(); ++k) {
        EXPECT_EQ(found[k], found[k % 2]);
    }
}

}  // namespace
}  // namespace tiretherm::solver
