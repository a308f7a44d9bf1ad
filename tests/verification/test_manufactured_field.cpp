// SPDX-License-Identifier: BSD-3-Clause
// Method of manufactured solutions: second order in space and time on an orthotropic block with k(T) and c(T).

#include <array>
#include <cmath>
#include <vector>

#include "tests/support/chosen_field.hpp"
#include "tests/support/order.hpp"
#include "tests/support/problem.hpp"

namespace tiretherm {
namespace {

namespace chosen = support::chosen;

constexpr double end = 80.0;

solver::Problem problem_with(int n, double ratio) {
    solver::Problem problem;
    problem.title = "manufactured";
    problem.mesh = mesh::build(mesh::Block{.x = {{0.015, n, ratio}},
                                           .y = {{0.010, n, 1.0 / ratio}},
                                           .stack = {{"rubber", 0.012, n, ratio}},
                                           .quarter = false,
                                           .side_patches = true});
    const auto law = [](const std::array<double, 3>& p) {
        return physics::Curve::quadratic_about(300.0, p[0], p[1], p[2]);
    };
    problem.materials = {{.name = "rubber",
                          .density = chosen::density,
                          .heat_capacity = law(chosen::c),
                          .conductivity = {law(chosen::k[0]), law(chosen::k[1]), law(chosen::k[2])}}};
    support::switch_on(problem, "conduction");
    support::switch_on(problem, chosen::inside);
    support::switch_on(problem, chosen::sides);
    support::schedule(problem, "inflation_pressure", {0.0, end}, {0.0, end});
    for (const mesh::Point& place : problem.mesh.centre) {
        problem.initial.push_back(chosen::field(place, 0.0).T);
    }
    problem.settings.end = end;
    problem.settings.tolerance = 1e-6;
    problem.settings.output_interval = end;
    return problem;
}

/// Root mean square error over the cells by volume, and over the nodes of all sides by area. K
std::array<double, 2> errors(const solver::Problem& problem) {
    const std::vector<double> T = support::final_field(problem);
    const mesh::Mesh& mesh = problem.mesh;
    double inside = 0.0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(mesh.n_cells); ++i) {
        inside += mesh.volume[i] * std::pow(T[i] - chosen::field(mesh.centre[i], end).T, 2);
    }
    double outside = 0.0;
    double area = 0.0;
    for (const mesh::Patch& patch : mesh.patches) {
        for (const mesh::PatchFace& face : patch.faces) {
            outside +=
                face.area * std::pow(T[static_cast<std::size_t>(face.node)] - chosen::field(face.centre, end).T, 2);
            area += face.area;
        }
    }
    return {std::sqrt(inside / mesh.total_volume()), std::sqrt(outside / area)};
}

TEST(ManufacturedField, SourceBalancesTheField) {
    // The derivation above against central differences: rho c T_t - div(k grad T) with steps of 1e-5 m and 1e-3 s,
    // whose error of the square of the step times fourth derivatives is 1e-6 of the terms, and round-off 1e-16/1e-10 =
    // 1e-6.
    const mesh::Point at{0.004, -0.003, 0.005};
    const double t = 25.0;
    const auto T = [](const mesh::Point& p, double time) { return chosen::field(p, time).T; };
    const double e = 1e-5;
    double q = chosen::density * chosen::quadratic(chosen::c, T(at, t)) * (T(at, t + 1e-3) - T(at, t - 1e-3)) / 2e-3;
    double size = std::abs(q);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        mesh::Point up = at;
        mesh::Point down = at;
        up[axis] += e;
        down[axis] -= e;
        const auto k_between = [&](const mesh::Point& p) {
            return chosen::quadratic(chosen::k[axis], 0.5 * (T(p, t) + T(at, t)));
        };
        const double out =
            (k_between(up) * (T(up, t) - T(at, t)) - k_between(down) * (T(at, t) - T(down, t))) / (e * e);
        q -= out;
        size += std::abs(out);
    }
    EXPECT_NEAR(chosen::source(chosen::field(at, t)), q, 1e-5 * size);
}

TEST(ManufacturedField, ConvergesAtSecondOrderInSpaceAndTimeTogether) {
    // Cells and steps halve together, so that either falling to first order would show. Cells graded by 2 (x, z) and
    // 1/2 (y): order 2 within 0.15, as grading adds terms of third order.
    std::vector<double> cells;
    std::vector<double> sides;
    for (const int n : {6, 12, 24}) {
        solver::Problem problem = problem_with(n, 2.0);
        problem.settings.fixed_step = end / n;
        const auto now = errors(problem);
        cells.push_back(now[0]);
        sides.push_back(now[1]);
    }
    support::expect_order("cells", cells, 1.85, 2.15);
    support::expect_order("sides", sides, 1.85, 2.15);
}

/// Root mean square difference of the final fields of one mesh, from each step to half of it.
std::vector<double> differences(solver::Method method, const std::vector<double>& steps) {
    std::vector<std::vector<double>> fields;
    for (const double step : steps) {
        solver::Problem problem = problem_with(6, 1.0);
        problem.settings.method = method;
        problem.settings.fixed_step = step;
        problem.settings.tolerance = 1e-9;
        fields.push_back(support::final_field(problem));
    }
    std::vector<double> result;
    for (std::size_t i = 0; i + 1 < fields.size(); ++i) {
        double squares = 0.0;
        for (std::size_t n = 0; n < fields[i].size(); ++n) {
            squares += std::pow(fields[i][n] - fields[i + 1][n], 2);
        }
        result.push_back(std::sqrt(squares / static_cast<double>(fields[i].size())));
    }
    return result;
}

TEST(ManufacturedField, StepsAloneConvergeAtTheOrderOfTheirMethod) {
    // On one coarse mesh the solution in time is that of a system of equations: T(dt) - T(dt/2) shrinks with the order
    // of the method, whatever the mesh's own error. Laws of k(T) and c(T) are converged in each step, or the order is
    // lost.
    support::expect_order("tr_bdf2", differences(solver::Method::tr_bdf2, {16.0, 8.0, 4.0, 2.0, 1.0}), 1.9, 2.1);
    support::expect_order("backward_euler", differences(solver::Method::backward_euler, {4.0, 2.0, 1.0, 0.5}), 0.9,
                          1.1);
}

}  // namespace
}  // namespace tiretherm
