// SPDX-License-Identifier: BSD-3-Clause
// A whole run of a mesh large enough for several threads.

#include <vector>

#include <gtest/gtest.h>

#include "tests/support/problem.hpp"
#include "tests/support/threads.hpp"

namespace tiretherm::solver {
namespace {

/// The laser's slab with k(T), 32 x 32 x 32 cells: above the length at which loops are shared, and in four blocks of the factor.
Problem slab() {
    const std::vector<mesh::Segment> side{{.to = 0.030, .cells = 32}};
    Problem problem;
    problem.mesh =
        mesh::build(mesh::Block{.x = side, .y = side, .stack = {{.name = "a", .thickness = 0.015, .cells = 32}}});
    problem.materials = {support::material(physics::Curve::quadratic_about(293.15, 0.29, 0.0094, 0.0), 1100.0,
                                           physics::Curve::quadratic_about(293.15, 1800.0, 3.0, 0.0))};
    support::switch_on(problem, "conduction");
    support::switch_on(problem, "laser");
    support::switch_on(problem, "still_air");
    support::hold(problem, "laser_power", 1.0);
    support::hold(problem, "air_temperature", 296.15);
    support::start_at(problem, 296.15);
    problem.settings.end = 5.0;
    problem.settings.linear_solver = LinearSolver::conjugate_gradient;
    return problem;
}

TEST(Threads, RunHasTheSameDigitsForAnyNumberOfThem) {
    const Problem problem = slab();
    std::vector<std::vector<double>> ends;
    for (const int threads : {1, 2, 3}) {
        const support::Threads now(threads);
        ends.emplace_back();
        const MarchReport report = run(problem, [&](const Snapshot& snapshot) {
            ends.back().assign(snapshot.temperature.begin(), snapshot.temperature.end());
            return true;
        });
        EXPECT_TRUE(report.status.ok()) << report.status.message;
        EXPECT_LT(report.energy_closure, 1e-12);
    }
    EXPECT_GT(ends[0][0], 296.15);
    EXPECT_EQ(ends[1], ends[0]);
    EXPECT_EQ(ends[2], ends[0]);
}

}  // namespace
}  // namespace tiretherm::solver
