// SPDX-License-Identifier: BSD-3-Clause
// Surfaces without capacity follow their cells: the rows of the surfaces hold to round-off, cells stay, and an iteration that
// does not come to an end says so.
#include "solver/sensitivity/surfaces.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "mesh/index.hpp"
#include "physics/effects/bench.hpp"

namespace tiretherm::solver {

namespace {

/// The matrix of a section with conduction and films, and two columns of random numbers.
struct Settling {
    Settling() {
        std::mt19937_64 random(24);
        std::uniform_real_distribution<double> any(-1.0, 1.0);
        whole.ask(physics::rolling());
        whole.system().matrices(2.0, false, A, J);
        n = at(J.pattern->n);
        for (std::vector<double>* block : {&x, &right}) {
            block->resize(2 * n);
            for (double& value : *block) {
                value = any(random);
            }
        }
        product.resize(2 * n);
    }
    [[nodiscard]] Status settle() { return SurfaceSettling(whole.system()).settle(J, right, scale, 1e-15, x); }

    physics::Whole whole{physics::section(), {{"conduction"}, {"air_convection"}, {"sidewall_convection"}}};
    Matrix A;
    Matrix J;
    std::size_t n = 0;
    double scale = 3.0;
    std::vector<double> x;
    std::vector<double> right;
    std::vector<double> product;
};

}  // namespace

TEST(SettleSurfaces, SolvesTheRowsOfTheSurfacesAndLeavesTheCells) {
    Settling settling;
    const std::vector<double> before = settling.x;
    const Status status = settling.settle();
    EXPECT_TRUE(status.ok()) << status.message;
    settling.J.multiply_block(settling.x, settling.product, 2);
    std::size_t surfaces = 0;
    for (std::size_t i = 0; i < 2 * settling.n; ++i) {
        if (settling.whole.system().has_capacity(i % settling.n)) {
            EXPECT_EQ(settling.x[i], before[i]);
            continue;
        }
        ++surfaces;
        // Of a row the sum of some five products, each rounded to 1e-16 of the largest, the diagonal's.
        const double size = std::abs(settling.J.value[at(settling.J.pattern->diagonal[i % settling.n])]);
        EXPECT_NEAR(settling.product[i], settling.scale * settling.right[i], 1e-14 * size + 1e-14) << i;
    }
    EXPECT_GT(surfaces, 0U);
}

// A law of the mean over all nodes that adds 1000 W/K to each row beside diagonals of some W/K: what one surface is off moves all
// others by a hundred times of it, and the sweeps go apart.
TEST(SettleSurfaces, SaysWhenItDoesNotComeToAnEnd) {
    Settling settling;
    mesh::Functional all;
    std::vector<double> row(settling.n, 1.0);
    for (std::size_t i = 0; i < settling.n; ++i) {
        all.nodes.push_back(static_cast<int>(i));
        all.weights.push_back(1.0);
    }
    for (const double scale : {1e3, 1e300}) {  // within numbers, and beyond them
        settling.J.outer = {{.row = row, .mean = &all, .scale = scale}};
        EXPECT_EQ(settling.settle().outcome, Outcome::not_converged) << scale;
    }
}

}  // namespace tiretherm::solver
