// SPDX-License-Identifier: BSD-3-Clause
// Steady slab between two surroundings: exact surface temperatures for any number of cells.

#include "tests/support/problem.hpp"
#include "tests/support/surroundings.hpp"

namespace tiretherm {
namespace {

constexpr double slab_area = 0.5;

TEST(RobinSlab, SurfaceSettlesAt333K) {
    // 1/12.5 outside, 0.012/0.3 in the rubber, 1/25 inside: 0.08 + 0.04 + 0.04 = 0.16 m2K/W between 293.15 and 373.15
    // K. Half of it lies outside, so the outer surface stands at 293.15 + 40 = 333.15 K and the inner at 353.15 K, for
    // any number of cells: the scheme is exact for a straight profile, up to the round-off of 1e-9 K.
    for (const int cells : {1, 2, 7}) {
        solver::Problem problem;
        problem.title = "steady Robin slab";
        problem.mesh = mesh::build(mesh::Layers{.area = slab_area, .stack = {{"rubber", 0.012, cells, 2.0}}});
        problem.materials = {support::material(0.3, 1100.0, 1800.0)};
        support::switch_on(problem, "conduction");
        support::switch_on(problem, support::surroundings, {{"h", 12.5}, {"T", 293.15}}, {"outside"});
        support::switch_on(problem, support::surroundings, {{"h", 25.0}, {"T", 373.15}}, {"inside"});
        support::start_at(problem, 300.0);
        problem.settings.steady = true;
        support::read(problem, "outside", mesh::over_patch(problem.mesh, 0));
        support::read(problem, "inside", mesh::over_patch(problem.mesh, 1));
        const solver::MarchReport report = support::run_closed(problem);
        EXPECT_NEAR(report.channel_final[0], 333.15, 1e-9);
        EXPECT_NEAR(report.channel_final[1], 353.15, 1e-9);
        EXPECT_NEAR(report.watts[1], -slab_area * 80.0 / 0.16, 1e-7);  // 250 W
    }
}

}  // namespace
}  // namespace tiretherm
