// SPDX-License-Identifier: BSD-3-Clause
// Disc source on a half-space, axisymmetric and as a block, against Carslaw and Jaeger; second order at the centre.

#include <cmath>
#include <numbers>
#include <vector>

#include "tests/support/disc_source.hpp"
#include "tests/support/order.hpp"
#include "tests/support/problem.hpp"

namespace tiretherm {
namespace {

// Half a watt on a disc of 1 cm2 of rubber, 60 s: sqrt(alpha t) is 2.96 mm, half the disc's radius of 5.64 mm. The
// domain ends 20 mm beyond the disc and 20 mm deep: erfc(20/5.93) = 2e-6 of the rise is lost there.
constexpr double conductivity = 0.29;
constexpr double capacity = 1100.0 * 1800.0;
constexpr double power = 0.5;
constexpr double start = 296.15;
const double radius = std::sqrt(1e-4 / std::numbers::pi);

support::DiscSource exact_source() {
    return {
        .flux = power / 1e-4, .radius = radius, .conductivity = conductivity, .diffusivity = conductivity / capacity};
}

std::vector<mesh::Layer> depth(int refinement) { return {{"rubber", 0.020, 10 * refinement, 6.0}}; }

/// From the disc's centre to its edge in equal cells, then wider and wider to the end.
std::vector<mesh::Segment> across(int refinement) {
    return {{radius, 4 * refinement, 1.0}, {radius + 0.020, 8 * refinement, 4.0}};
}

solver::Problem heated(mesh::Mesh mesh, double end) {
    solver::Problem problem;
    problem.title = "half-space under a disc";
    problem.mesh = std::move(mesh);
    problem.materials = {support::material(conductivity, 1100.0, 1800.0)};
    support::switch_on(problem, "conduction");
    support::switch_on(problem, "laser", {{"radius", radius}});
    support::hold(problem, "laser_power", power);
    support::start_at(problem, start);
    support::read(problem, "centre", mesh::at_point(problem.mesh, {0.0, 0.0, 0.0}));
    problem.settings.end = end;
    problem.settings.output_interval = end;
    return problem;
}

TEST(HalfSpace, FormulaTendsToItsTwoLimits) {
    // Early, the disc is a plane: 2 q sqrt(alpha t/pi)/k. Late, steady: q a/k (facts.md 2.2), approached as
    // 1 - a/(2 sqrt(pi alpha t)). At sqrt(alpha t) = a/10 and 1000 a both hold to 1e-6.
    const support::DiscSource exact = exact_source();
    const double early = 0.01 * radius * radius / exact.diffusivity;
    EXPECT_NEAR(exact.at_centre(early) / (2.0 * exact.flux * 0.1 * radius / conductivity * std::numbers::inv_sqrtpi),
                1.0, 1e-6);
    const double late = 1e6 * radius * radius / exact.diffusivity;
    const double approached = 1.0 - 0.5e-3 * std::numbers::inv_sqrtpi;
    EXPECT_NEAR(exact.at_centre(late) / (exact.flux * radius / conductivity * approached), 1.0, 1e-6);
}

TEST(HalfSpace, CentreOfTheDiscConvergesAtSecondOrderAboutTheAxis) {
    // T(0,0,t) = 2 q sqrt(alpha t)/k [1/sqrt(pi) - ierfc(a/(2 sqrt(alpha t)))] = 51.7 K at 60 s. The disc ends on an
    // edge between cells, where the flux jumps and the scheme is poor; the centre does not see it. Order 2 within 0.1.
    // (Half distances that are logarithmic in the radius would lose it: a regular field is not a line source, the error
    // on the axis becomes h^2 ln(1/h) and the observed order 1.8.)
    const support::DiscSource exact = exact_source();
    std::vector<double> errors;
    for (const int refinement : {1, 2, 4, 8}) {
        solver::Problem problem =
            heated(mesh::build(mesh::Axisymmetric{.radius = across(refinement), .stack = depth(refinement)}), 60.0);
        problem.settings.tolerance = 3e-5;
        errors.push_back(support::run_closed(problem).channel_final[0] - start - exact.at_centre(60.0));
    }
    support::expect_order("centre", errors, 1.9, 2.1);
    support::expect_below("finest_over_rise", errors.back() / exact.at_centre(60.0), 3e-4);
}

TEST(HalfSpace, BlockAndAxisymmetricMeshBothWarmUpAsCarslawAndJaeger) {
    // The same at 10 and 60 s. In the block the circle cuts cells, whose light is shared by exact overlap: what is
    // smeared over a cell's width at the edge hardly reaches the centre. 0.5 % of the rise on these grids.
    const support::DiscSource exact = exact_source();
    for (const double end : {10.0, 60.0}) {
        solver::Problem round = heated(mesh::build(mesh::Axisymmetric{.radius = across(4), .stack = depth(4)}), end);
        solver::Problem block =
            heated(mesh::build(mesh::Block{.x = across(2), .y = across(2), .stack = depth(4), .quarter = true}), end);
        const double rise = exact.at_centre(end);
        const std::string at = "_at_" + std::to_string(static_cast<int>(end)) + "_s";
        support::expect_below("round" + at, (support::run_closed(round).channel_final[0] - start) / rise - 1.0, 5e-3);
        support::expect_below("block" + at, (support::run_closed(block).channel_final[0] - start) / rise - 1.0, 5e-3);
    }
}

TEST(HalfSpace, WholeBlockEqualsItsQuarter) {
    // Symmetry about x = 0 and y = 0: a whole block with the mirrored grid holds the same numbers, to the tolerance of
    // the linear solution (a hundredth of the 1e-6 K of a step, some tens of steps), and four times the heat.
    solver::Problem quarter =
        heated(mesh::build(mesh::Block{.x = across(1), .y = across(1), .stack = depth(1), .quarter = true}), 60.0);
    mesh::Block whole{.x = {}, .y = {}, .stack = depth(1), .quarter = false};
    // The mirrored segments: from -X the wide ones first, with their ratio inverted.
    whole.x = {{-radius, 8, 0.25}, {radius, 8, 1.0}, {radius + 0.020, 8, 4.0}};
    whole.y = whole.x;
    solver::Problem full = heated(mesh::build(whole), 60.0);
    for (solver::Problem* problem : {&quarter, &full}) {
        problem->settings.tolerance = 1e-6;
        problem->settings.fixed_step = 2.0;
    }
    // Between the two cells beside the axis the whole block reads their value, the quarter a parabola: compare a cell.
    const auto cell = [](const solver::Problem& problem) {
        const mesh::Grid& grid = *problem.mesh.grid;
        const double x = 0.5 * radius / 4.0;
        return mesh::at_point(problem.mesh, {x, x, grid.centre[2][0]});
    };
    support::read(quarter, "cell", cell(quarter));
    support::read(full, "cell", cell(full));
    const solver::MarchReport a = support::run_closed(quarter);
    const solver::MarchReport b = support::run_closed(full);
    EXPECT_NEAR(a.channel_final[1], b.channel_final[1], 1e-6);
    EXPECT_NEAR(4.0 * a.stored, b.stored, 1e-9 * b.stored);
}

}  // namespace
}  // namespace tiretherm
