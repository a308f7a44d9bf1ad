// SPDX-License-Identifier: BSD-3-Clause
// The two-node model of the thesis as a problem of the solver.
#pragma once

#include "tests/support/problem.hpp"
#include "tests/support/two_node_thesis.hpp"

namespace tiretherm::support {

/// The same model as a problem of the solver: two lumps, one link, the thesis's five effects. No inputs yet.
inline solver::Problem two_node_problem(const TwoNodeThesis& thesis) {
    solver::Problem problem;
    problem.title = "two nodes";
    const double volume = problem.tire.band_mass() / problem.tire.density;
    problem.mesh = mesh::build(mesh::TwoNode{.area = problem.tire.outer_area(),
                                             .surface_volume = 0.15 * volume,
                                             .bulk_volume = 0.85 * volume,
                                             .bulk_depth = 0.010});
    problem.materials.assign(2, material(0.29, 1100.0, 1800.0));
    problem.link_laws = {physics::Curve::quadratic_about(293.15, thesis.k_20, thesis.k_per_K, thesis.k_per_K2)};
    switch_on(problem, "conduction");
    switch_on(problem, "strain_energy_loss",
              {{"lambda_srf", thesis.lambda_SELsrf},
               {"lambda_blk", thesis.lambda_SELblk},
               {"tan_delta_peak", 0.0}});  // (49) as printed
    choose(problem, "speed", 1);           // (45) as printed
    switch_on(problem, "sliding_friction",
              {{"partition", thesis.hpc}, {"lambda_x", thesis.lambda_x}, {"lambda_y", thesis.lambda_y}});
    switch_on(problem, "air_convection", {{"lambda_h", thesis.lambda_h}});
    choose(problem, "exponential", 1);  // (33) as printed
    switch_on(problem, "road_contact", {{"lambda_Hc", thesis.lambda_Hc}});
    read(problem, "surface_temperature", problem.mesh.regions[0].mean);
    read(problem, "bulk_temperature", problem.mesh.regions[1].mean);
    return problem;
}

}  // namespace tiretherm::support
