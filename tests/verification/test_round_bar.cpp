// SPDX-License-Identifier: BSD-3-Clause
// Round bar that cools through its side: second order against its Bessel series.

#include <array>
#include <vector>

#include "tests/support/order.hpp"
#include "tests/support/problem.hpp"
#include "tests/support/round_bar.hpp"

namespace tiretherm {
namespace {

// A bar of 20 mm radius, from 80 C into air of 20 C through its side only: Biot number 2.07.
constexpr double radius = 0.020;
constexpr double bar_conductivity = 0.29;
constexpr double bar_density = 1100.0;
constexpr double bar_specific_heat = 1800.0;
constexpr double h = 30.0;
constexpr double hot_bar = 353.15;
constexpr double air_at_bar = 293.15;

TEST(RoundBar, SeriesStartsUniform) {
    // At t -> 0 the series is 1 on the axis: the front of cooling has not arrived at alpha t/a^2 = 1e-3, where
    // exp(-beta^2 1e-3) kills the terms from beta = 200 on, of 64 a pi apart.
    const support::RoundBar exact(radius, bar_conductivity, bar_density * bar_specific_heat, h, 64);
    const double t = 1e-3 * radius * radius * bar_density * bar_specific_heat / bar_conductivity;
    EXPECT_NEAR(exact.excess(0.0, t), 1.0, 1e-10);
}

TEST(RoundBar, CoolsAtSecondOrderOnTheAxisHalfwayAndAtTheSide) {
    // 600 s, alpha t/a^2 = 0.22, by the Bessel series of round_bar.hpp. Top and bottom are insulated, so that the depth
    // must not matter: two cells of it. Order 2; the point halfway lies on an edge between two cells of every grid.
    constexpr double end = 600.0;
    const support::RoundBar exact(radius, bar_conductivity, bar_density * bar_specific_heat, h, 20);
    constexpr std::array<double, 3> place{0.0, 0.5 * radius, radius};
    std::array<std::vector<double>, 3> errors;
    for (const int cells : {16, 32, 64, 128}) {
        solver::Problem problem;
        problem.title = "round bar";
        problem.mesh = mesh::build(mesh::Axisymmetric{
            .radius = {{radius, cells, 1.0}}, .stack = {{"rubber", 0.010, 2, 1.0}}, .side_patches = true});
        problem.materials = {support::material(bar_conductivity, bar_density, bar_specific_heat)};
        support::switch_on(problem, "conduction");
        support::switch_on(problem, "still_air", {{"h", h}}, {"rim"});
        support::hold(problem, "air_temperature", air_at_bar);
        support::start_at(problem, hot_bar);
        problem.settings.end = end;
        problem.settings.tolerance = 1e-8;
        problem.settings.output_interval = end;
        for (const double r : place) {
            support::read(problem, "at_radius", mesh::at_point(problem.mesh, {r, 0.5, 0.005}));
        }
        const solver::MarchReport report = support::run_closed(problem);
        for (std::size_t i = 0; i < place.size(); ++i) {
            errors[i].push_back(report.channel_final[i] - air_at_bar -
                                (hot_bar - air_at_bar) * exact.excess(place[i], end));
        }
    }
    support::expect_order("axis", errors[0], 1.9, 2.1);
    support::expect_order("halfway", errors[1], 1.9, 2.1);
    support::expect_order("side", errors[2], 1.9, 2.1);
}

}  // namespace
}  // namespace tiretherm
