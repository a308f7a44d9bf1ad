// SPDX-License-Identifier: BSD-3-Clause
// Direct factorisation and conjugate gradients give the same temperature field.

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/support/order.hpp"
#include "tests/support/problem.hpp"

namespace tiretherm {
namespace {

/// A small laser specimen in three dimensions.
solver::Problem block_with(bool varying) {
    solver::Problem problem;
    problem.title = varying ? "nonlinear block" : "linear block";
    problem.mesh = mesh::build(mesh::Block{.x = {{0.006, 4, 1.0}, {0.030, 6, 4.0}},
                                           .y = {{0.006, 4, 1.0}, {0.030, 6, 4.0}},
                                           .stack = {{"tread", 0.003, 5, 2.0}, {"bulk", 0.012, 8, 3.0}},
                                           .quarter = true});
    const double slope = varying ? 1.0 : 0.0;
    problem.materials = {support::material(physics::Curve::quadratic_about(293.15, 0.29, 0.0094 * slope, 0.0), 1100.0,
                                           physics::Curve::quadratic_about(293.15, 1800.0, 3.0 * slope, 0.0)),
                         support::material(physics::Curve::quadratic_about(293.15, 0.06, 0.0002 * slope, 0.0), 1100.0,
                                           physics::Curve::constant(1800.0))};
    support::switch_on(problem, "conduction");
    support::switch_on(problem, "laser");
    support::switch_on(problem, "still_air");
    support::hold(problem, "laser_power", 2.0);
    support::hold(problem, "air_temperature", 296.15);
    support::start_at(problem, 296.15);
    problem.settings.end = 120.0;
    problem.settings.output_interval = 120.0;
    return problem;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
    double worst = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        worst = std::max(worst, std::abs(a[i] - b[i]));
    }
    return worst;
}

TEST(LinearSolvers, CholeskyAndConjugateGradientsGiveTheSameField) {
    // The same system solved exactly and by iteration. With equal steps the fields differ by the iterations' remainder
    // only, some hundredths of the tolerance a step over 24 steps; with error control the steps may differ as well, and
    // the fields then by a few tolerances. Linear, nonlinear and steady.
    for (const bool varying : {false, true}) {
        for (const double tolerance : {1e-2, 1e-4}) {
            for (const bool fixed : {true, false}) {
                solver::Problem problem = block_with(varying);
                problem.settings.tolerance = tolerance;
                if (fixed) {
                    problem.settings.fixed_step = 5.0;
                }
                problem.settings.linear_solver = solver::LinearSolver::cholesky;
                const std::vector<double> direct = support::final_field(problem);
                problem.settings.linear_solver = solver::LinearSolver::conjugate_gradient;
                const std::vector<double> iterative = support::final_field(problem);
                support::expect_below(problem.title + (fixed ? "_fixed_" : "_controlled_") + std::to_string(tolerance),
                                      largest_difference(direct, iterative), (fixed ? 1.0 : 3.0) * tolerance);
            }
        }
        solver::Problem problem = block_with(varying);
        problem.settings.steady = true;
        problem.settings.tolerance = 1e-5;
        problem.settings.linear_solver = solver::LinearSolver::cholesky;
        const std::vector<double> direct = support::final_field(problem);
        problem.settings.linear_solver = solver::LinearSolver::conjugate_gradient;
        support::expect_below(problem.title + "_steady", largest_difference(direct, support::final_field(problem)),
                              1e-5);
    }
}

TEST(LinearSolvers, SteadyStateOfConductivitiesAMillionApartIsWithinTheTolerance) {
    // Layers of 1e3 and 1e-3 W/mK in turn: what one good conductor is warmer than the next hardly shows in the heat balance,
    // so that an iteration that ends on a small residual is far from the field.
    solver::Problem problem = block_with(false);
    problem.mesh = mesh::build(mesh::Block{.x = {{0.03, 8, 1.0}},
                                           .y = {{0.03, 8, 1.0}},
                                           .stack = {{"tread", 0.003, 3, 1.0},
                                                     {"belt", 0.003, 3, 1.0},
                                                     {"carcass", 0.003, 3, 1.0},
                                                     {"liner", 0.003, 3, 1.0}},
                                           .quarter = true});
    const physics::Curve heat_capacity = physics::Curve::constant(1800.0);
    for (const double k : {1e3, 1e-3, 1e3, 1e-3}) {
        problem.materials.push_back(support::material(physics::Curve::constant(k), 1100.0, heat_capacity));
    }
    problem.materials.erase(problem.materials.begin(), problem.materials.begin() + 2);
    support::start_at(problem, 296.15);
    problem.settings.steady = true;
    for (const double tolerance : {1e-2, 1e-4}) {
        problem.settings.tolerance = tolerance;
        problem.settings.linear_solver = solver::LinearSolver::cholesky;
        const std::vector<double> direct = support::final_field(problem);
        problem.settings.linear_solver = solver::LinearSolver::conjugate_gradient;
        support::expect_below("steady_state_of_unlike_layers_" + std::to_string(tolerance),
                              largest_difference(direct, support::final_field(problem)), tolerance);
    }
}

}  // namespace
}  // namespace tiretherm
