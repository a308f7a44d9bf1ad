// SPDX-License-Identifier: BSD-3-Clause
// Slab between two Robin faces against its exact series: orders in space and time, and error control.

#include <array>

#include "tests/support/layered_slab.hpp"
#include "tests/support/order.hpp"
#include "tests/support/problem.hpp"

namespace tiretherm {
namespace {

// 12 mm of rubber, from 80 C into air of 20 C at 60 W/m2K outside and 15 W/m2K inside: Biot numbers 2.5 and 0.6.
constexpr double thickness = 0.012;
constexpr double conductivity = 0.29;
constexpr double density = 1100.0;
constexpr double specific_heat = 1800.0;
constexpr double h_outside = 60.0;
constexpr double h_inside = 15.0;
constexpr double hot = 353.15;
constexpr double air = 293.15;
constexpr double area = 0.5;

support::LayeredSlab exact_slab() {
    return {.layers = {{thickness, conductivity, density * specific_heat}}, .h_top = h_outside, .h_bottom = h_inside};
}

enum : std::size_t { outside, middle, inside };

solver::Problem slab(int cells, double end) {
    solver::Problem problem;
    problem.title = "Robin slab";
    problem.mesh = mesh::build(mesh::Layers{.area = area, .stack = {{"rubber", thickness, cells, 1.0}}});
    problem.materials = {support::material(conductivity, density, specific_heat)};
    support::switch_on(problem, "conduction");
    support::switch_on(problem, "still_air", {{"h", h_outside}}, {"outside"});
    support::switch_on(problem, "still_air", {{"h", h_inside}}, {"inside"});
    support::hold(problem, "air_temperature", air);
    support::start_at(problem, hot);
    problem.settings.end = end;
    problem.settings.output_interval = end;
    support::read(problem, "outside", mesh::over_patch(problem.mesh, problem.mesh.find_patch("outside")));
    support::read(problem, "middle", mesh::at_point(problem.mesh, {0.5 * area, 0.5, 0.5 * thickness}));
    support::read(problem, "inside", mesh::over_patch(problem.mesh, problem.mesh.find_patch("inside")));
    return problem;
}

/// Errors of the three readings [K], and of the heat given off, as kelvin of the whole slab.
std::array<double, 4> errors_of_slab(const solver::Problem& problem) {
    const support::LayeredSlab exact = exact_slab();
    const double t = problem.settings.end;
    const auto modes = exact.modes(t);
    const solver::MarchReport report = support::run_closed(problem);
    std::array<double, 4> result{};
    const std::array<double, 3> depth{0.0, 0.5 * thickness, thickness};
    for (std::size_t i = 0; i < 3; ++i) {
        result[i] = report.channel_final[i] - (air + (hot - air) * exact.cooling(modes, depth[i], t));
    }
    const double capacity = density * specific_heat * thickness;
    const double given_off = (hot - air) * (exact.cooling_store(modes, t) - capacity);
    result[3] = (report.stored / area - given_off) / capacity;
    return result;
}

TEST(RobinSlab, SeriesStartsUniformAndLosesWhatItsFacesGiveOff) {
    // The exact solution is examined first. At t -> 0 it is 1 inside; between two times the heat lost equals what
    // leaves through both faces, integrated by Simpson's rule over 200 intervals (error of h^4, below 1e-9).
    const support::LayeredSlab exact = exact_slab();
    const auto many = exact.modes(0.05);
    EXPECT_NEAR(exact.cooling(many, 0.5 * thickness, 0.05), 1.0, 1e-12);
    const auto loss = [&](double t) {
        return h_outside * exact.cooling(many, 0.0, t) + h_inside * exact.cooling(many, thickness, t);
    };
    double left = 0.0;
    constexpr int intervals = 200;
    constexpr double from = 100.0;
    constexpr double step = 200.0 / intervals;
    for (int i = 0; i < intervals; ++i) {
        const double t = from + i * step;
        left += step / 6.0 * (loss(t) + 4.0 * loss(t + 0.5 * step) + loss(t + step));
    }
    const double lost = exact.cooling_store(many, 100.0) - exact.cooling_store(many, 300.0);
    EXPECT_NEAR(left / lost, 1.0, 1e-9);
}

TEST(RobinSlab, SurfacesAndMiddleConvergeAtSecondOrderInSpace) {
    // T = T_air + (T_0 - T_air) sum c_j Z_j(z) exp(-mu_j t), layered_slab.hpp. After 300 s; the error control keeps the
    // steps' part below 1e-6 K, a hundredth of the finest grid's error. Half distances to the surface nodes make every
    // reading, surfaces included, second order: 2 within 0.1.
    std::array<std::vector<double>, 4> all;
    for (const int cells : {8, 16, 32, 64}) {
        solver::Problem problem = slab(cells, 300.0);
        problem.settings.tolerance = 1e-9;
        const auto now = errors_of_slab(problem);
        for (std::size_t i = 0; i < 4; ++i) {
            all[i].push_back(now[i]);
        }
    }
    support::expect_order("outside", all[outside], 1.9, 2.1);
    support::expect_order("middle", all[middle], 1.9, 2.1);
    support::expect_order("inside", all[inside], 1.9, 2.1);
    support::expect_order("stored", all[3], 1.9, 2.1);
}

TEST(RobinSlab, TrBdf2ConvergesAtSecondOrderInTime) {
    // 600 cells leave 1e-5 K of error in space. The start does not fit the faces' condition: an L-stable method forgets
    // that within a few steps, and the order at 300 s is 2 all the same.
    std::vector<double> at_surface;
    std::vector<double> in_middle;
    for (const double step : {60.0, 30.0, 15.0, 7.5}) {
        solver::Problem problem = slab(600, 300.0);
        problem.settings.fixed_step = step;
        problem.settings.tolerance = 1e-7;
        const auto now = errors_of_slab(problem);
        at_surface.push_back(now[outside]);
        in_middle.push_back(now[middle]);
    }
    support::expect_order("outside", at_surface, 1.8, 2.2);
    support::expect_order("middle", in_middle, 1.8, 2.2);
}

TEST(RobinSlab, BackwardEulerConvergesAtFirstOrderInTime) {
    // As above, with order 1.
    std::vector<double> at_surface;
    std::vector<double> in_middle;
    for (const double step : {15.0, 7.5, 3.75, 1.875}) {
        solver::Problem problem = slab(600, 300.0);
        problem.settings.method = solver::Method::backward_euler;
        problem.settings.fixed_step = step;
        problem.settings.tolerance = 1e-7;
        const auto now = errors_of_slab(problem);
        at_surface.push_back(now[outside]);
        in_middle.push_back(now[middle]);
    }
    support::expect_order("outside", at_surface, 0.9, 1.1);
    support::expect_order("middle", in_middle, 0.9, 1.1);
}

TEST(RobinSlab, ErrorControlKeepsTheToleranceAfterTheUnfittingStart) {
    // The first steps meet an infinite rate of change at the surface. Errors of the readings after 5, 50 and 500 s stay
    // within three tolerances of the series; 400 cells leave 1e-4 K in space at 5 s.
    for (const double tolerance : {1e-1, 1e-2, 1e-3}) {
        for (const double end : {5.0, 50.0, 500.0}) {
            solver::Problem problem = slab(400, end);
            problem.settings.tolerance = tolerance;
            for (const double error : errors_of_slab(problem)) {
                EXPECT_LE(std::abs(error), 3.0 * tolerance) << "tolerance " << tolerance << " K, at " << end << " s";
            }
        }
    }
}

}  // namespace
}  // namespace tiretherm
