// SPDX-License-Identifier: BSD-3-Clause
// Parameter slopes of a tire section against differences of runs.

#include "solver/sensitivity/slopes.hpp"
#include "support/tire_section.hpp"

namespace tiretherm::solver {

TEST(Prediction, SlopesOfASectionEqualDifferences) {
    Problem problem = support::tire_problem(1);
    problem.materials[0].conductivity.fill(physics::Curve::quadratic_about(293.15, 0.29, 0.005, 1e-5));
    for (const mesh::Region& region : problem.mesh.regions) {
        support::read(problem, region.name, region.mean);
    }
    support::read(problem, "drag", {});
    problem.channels.back().quantity = Quantity::drag_force;
    using Kind = FreeParameter::Kind;
    expect_differences(
        problem, {number(problem, "air_convection", "lambda_h"), number(problem, "strain_energy_loss", "lambda_blk"),
                  law(Kind::conductivity, {0}, {300.0, 330.0, 360.0}, 1), law(Kind::heat_capacity, {1}, {300.0}, 0),
                  start_of(problem)});
}

}  // namespace tiretherm::solver
