// SPDX-License-Identifier: BSD-3-Clause
// Hollow cylinders against exact solutions: the logarithm of a composite tube, and an eigenfunction of Bessel functions.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "mesh/builders.hpp"
#include "mesh/probe.hpp"
#include "solver/user_effect.hpp"
#include "tests/support/problem.hpp"

namespace tiretherm {
namespace {

using std::numbers::pi;

/// A tube cooled outside with h to 300 K, with a heater of `watts` on its inner surface.
solver::Problem tube(const mesh::Cylinder& cylinder, const std::vector<double>& conductivities, double h,
                     double watts) {
    solver::Problem problem;
    problem.mesh = mesh::build(cylinder);
    for (const double k : conductivities) {
        problem.materials.push_back(support::material(k, 1100.0, 1800.0));
    }
    support::switch_on(problem, "conduction");
    support::switch_on(problem, "still_air", {{"h", h}}, {"outside"});
    problem.input_signals.add(*physics::find_signal("air_temperature"), 300.0);
    support::start_at(problem, 300.0);
    if (watts != 0.0) {
        solver::add_user_effect(
            problem,
            {.name = "heater", .follows = "1", .places = {"inside"}, .signal = {{0.0}, {1.0}}, .amount = watts});
    }
    support::read(problem, "outside", mesh::over_patch(problem.mesh, 0));
    support::read(problem, "inside", mesh::over_patch(problem.mesh, 1));
    return problem;
}

// J0(x r) Y1(x ri) - Y0(x r) J1(x ri): no flux through the inner radius ri.
double mode(double x, double r, double inner) {
    return std::cyl_bessel_j(0.0, x * r) * std::cyl_neumann(1.0, x * inner) -
           std::cyl_neumann(0.0, x * r) * std::cyl_bessel_j(1.0, x * inner);
}

double mode_slope(double x, double r, double inner) {
    return -x * (std::cyl_bessel_j(1.0, x * r) * std::cyl_neumann(1.0, x * inner) -
                 std::cyl_neumann(1.0, x * r) * std::cyl_bessel_j(1.0, x * inner));
}

}  // namespace

// 200 W through 0.2 m of a tube of two layers, 0.29 W/mK from 60 to 80 mm and 0.06 W/mK from 50 to 60 mm:
// T = 300 + Q/(2 pi L) (1/(h 0.08) + ln(80/60)/0.29 + ln(60/50)/0.06). Exact for the logarithm with any number of cells.
TEST(HollowCylinder, CarriesTheLogarithmOfACompositeTubeExactly) {
    for (const int cells : {1, 3, 8}) {
        const mesh::Cylinder cylinder{.inner_radius = 0.05,
                                      .length = 0.2,
                                      .stack = {{.name = "outer", .thickness = 0.02, .cells = cells, .ratio = 0.5},
                                                {.name = "inner", .thickness = 0.01, .cells = cells}}};
        solver::Problem problem = tube(cylinder, {0.29, 0.06}, 20.0, 200.0);
        problem.settings.steady = true;
        const solver::MarchReport report = support::run_closed(problem);
        const double per_length = 200.0 / (2.0 * pi * 0.2);
        const double outside = 300.0 + per_length / (20.0 * 0.08);
        const double inside = outside + per_length * (std::log(80.0 / 60.0) / 0.29 + std::log(60.0 / 50.0) / 0.06);
        EXPECT_NEAR(report.channel_final[0], outside, 1e-8);
        EXPECT_NEAR(report.channel_final[1], inside, 1e-8);
    }
}

// A tube of 50 to 80 mm without flux inside starts as its slowest mode above 300 K and decays with
// exp(-alpha x^2 t), alpha = k/(rho c) and -k mode'(80 mm) = h mode(80 mm). After 2000 s both surfaces are known; the
// errors of 5, 10, 20 cells fall by four each time.
TEST(HollowCylinder, DecaysWithItsSlowestModeAtSecondOrder) {
    constexpr double inner = 0.05;
    constexpr double outer = 0.08;
    constexpr double k = 0.29;
    constexpr double h = 20.0;
    const auto balance = [&](double x) { return k * mode_slope(x, outer, inner) + h * mode(x, outer, inner); };
    double low = 1.0;    // 1/m
    double high = 52.0;  // half a period of the flat slab, pi/(2 * 0.03 m)
    ASSERT_LT(balance(low) * balance(high), 0.0);
    for (int i = 0; i < 200; ++i) {
        const double middle = 0.5 * (low + high);
        (balance(low) * balance(middle) <= 0.0 ? high : low) = middle;
    }
    const double x = low;
    const double scale = 50.0 / mode(x, inner, inner);
    std::vector<double> errors;
    for (const int cells : {5, 10, 20}) {
        const mesh::Cylinder cylinder{
            .inner_radius = inner, .length = 0.2, .stack = {{.name = "rubber", .thickness = 0.03, .cells = cells}}};
        solver::Problem problem = tube(cylinder, {k}, h, 0.0);
        for (std::size_t node = 0; node < problem.initial.size(); ++node) {
            problem.initial[node] = 300.0 + scale * mode(x, outer - problem.mesh.centre[node][2], inner);
        }
        problem.settings.end = 2000.0;
        problem.settings.tolerance = 1e-6;
        const solver::MarchReport report = support::run_closed(problem);
        const double left = scale * std::exp(-k / (1100.0 * 1800.0) * x * x * problem.settings.end);
        const double at_outside = report.channel_final[0] - 300.0 - left * mode(x, outer, inner);
        const double at_inside = report.channel_final[1] - 300.0 - left * mode(x, inner, inner);
        errors.push_back(std::max(std::abs(at_outside), std::abs(at_inside)));
    }
    EXPECT_LT(errors[2], 0.02);
    EXPECT_NEAR(std::log2(errors[0] / errors[1]), 2.0, 0.15);
    EXPECT_NEAR(std::log2(errors[1] / errors[2]), 2.0, 0.1);
}

// A cylinder of large radius is a strip: with R = 100 m and 10 mm of rubber curvature changes the steady resistance by
// a share of thickness/(2 R) = 5e-5.
TEST(HollowCylinder, OfLargeRadiusIsAStrip) {
    const mesh::Cylinder cylinder{.inner_radius = 100.0,
                                  .length = 1.0 / (2.0 * pi * 100.01),  // 1 m2 outside
                                  .stack = {{.name = "rubber", .thickness = 0.01, .cells = 6}}};
    solver::Problem round = tube(cylinder, {0.29}, 20.0, 300.0);
    round.settings.end = 500.0;
    solver::Problem flat = round;
    flat.mesh = mesh::build(mesh::Layers{.area = 1.0, .stack = cylinder.stack});
    ASSERT_EQ(round.mesh.n_nodes, flat.mesh.n_nodes);
    const solver::MarchReport about_axis = support::run_closed(round);
    const solver::MarchReport of_strip = support::run_closed(flat);
    for (const std::size_t side : {0U, 1U}) {
        const double rise = of_strip.channel_final[side] - 300.0;
        EXPECT_NEAR(about_axis.channel_final[side] - 300.0, rise, 3e-4 * rise);
        EXPECT_NE(about_axis.channel_final[side] - 300.0, rise);
    }
}

}  // namespace tiretherm
