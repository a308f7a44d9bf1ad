// SPDX-License-Identifier: BSD-3-Clause
// The sensor of heat flux: mean over a patch, positive out of the rubber.
#include <cmath>

#include <gtest/gtest.h>

#include "mesh/probe.hpp"
#include "solver/bench.hpp"
#include "solver/time_integration/march.hpp"
#include "solver/user_effect.hpp"

namespace tiretherm::solver {

namespace {

Channel flux_through(const Problem& problem, const std::string& name) {
    const mesh::Patch& patch = problem.mesh.patches[static_cast<std::size_t>(problem.mesh.find_patch(name))];
    Channel channel{.name = "flux_" + name, .meaning = "", .where = {}, .quantity = Quantity::heat_flux};
    for (const mesh::PatchFace& face : patch.faces) {
        channel.where.add(face.node, 1.0 / patch.area());
    }
    return channel;
}

/// Channels: flux through the outside and the inside, mean temperatures of the two surfaces.
void watch_both_sides(Problem& problem) {
    problem.channels = {flux_through(problem, "outside"),
                        flux_through(problem, "inside"),
                        {.name = "T_outside", .meaning = "", .where = mesh::over_patch(problem.mesh, 0)},
                        {.name = "T_inside", .meaning = "", .where = mesh::over_patch(problem.mesh, 1)}};
}

MarchReport run_through(const Problem& problem) {
    MarchReport report = run(problem, [](const Snapshot&) { return true; });
    EXPECT_TRUE(report.status.ok()) << report.status.message;
    return report;
}

}  // namespace

// 300 W enter 1 m2 of a strip of 10 mm from the inside and leave outside, where h = 20 W/m2K to 300 K: 300 W/m2 through
// both faces, positive outside and negative inside, T = 315 K outside and 0.01/0.29 K m2/W 300 W/m2 more inside. The
// scheme is exact for a straight profile: to round-off, with which 20 W/K (T - 300 K) is known to 1e-11.
TEST(HeatFlux, OfASteadySlabIsItsConductivityTimesItsGradient) {
    for (const int cells : {1, 2, 7}) {
        Problem problem = strip(cells);
        problem.effects.back().patches = {0};
        add_user_effect(
            problem,
            {.name = "heater", .follows = "1", .places = {"inside"}, .signal = {{0.0}, {1.0}}, .amount = 300.0});
        problem.settings.steady = true;
        watch_both_sides(problem);
        const MarchReport report = run_through(problem);
        const double gradient = (report.channel_final[3] - report.channel_final[2]) / 0.01;
        EXPECT_NEAR(report.channel_final[0], 300.0, 1e-8);
        EXPECT_NEAR(report.channel_final[1], -300.0, 1e-8);
        EXPECT_NEAR(report.channel_final[0], 0.29 * gradient, 1e-8);
        EXPECT_NEAR(report.channel_final[2], 315.0, 1e-9);
    }
}

// On its way to steady state a strip that is heated through its volume, with k(T), loses through its faces what the air
// takes: the flux over both faces is the effect's watts at every step, from the first moment on, when nothing flows. Both
// are as exact as Newton's method is, whose corrections end below the step's tolerance of 1e-6 K: through half a cell,
// 0.29 / (0.01 / 18) = 522 W/K, that is 5.2e-4 W of 1000 W.
TEST(HeatFlux, IsTheHeatThatTheSurroundingsTake) {
    Problem problem = heated_strip(9);
    problem.materials = {material(physics::Curve::quadratic_about(293.15, 0.29, 0.003, 0.0))};
    watch_both_sides(problem);
    problem.settings.tolerance = 1e-6;
    int steps = 0;
    const MarchReport report = run(problem, [&](const Snapshot& now) {
        EXPECT_NEAR(now.channels[0] + now.channels[1], -now.watts[1], 5.2e-4);
        EXPECT_NEAR(now.channels[0], now.channels[1], 5.2e-4);
        ++steps;
        return true;
    });
    ASSERT_TRUE(report.status.ok()) << report.status.message;
    EXPECT_GT(steps, 5);
    EXPECT_NEAR(report.channel_min[0], 0.0, 1e-9);
    EXPECT_GT(report.channel_final[0], 100.0);
    EXPECT_LT(report.channel_final[0], 500.0);  // half of 1e5 W/m3 over 10 mm, in the end
}

// Friction heats the surface itself: what the air takes and what the rubber takes are two things, and the sensor reads
// the rubber's share. A surface that is heated with 1000 W/m2 and cooled with 20 W/m2K (T - 300 K) gives the difference.
TEST(HeatFlux, LeavesOutWhatPassesTheSurfaceAlone) {
    Problem problem = strip(6);
    problem.effects.back().patches = {0};
    const std::size_t heater = add_user_effect(
        problem, {.name = "heater", .follows = "1", .places = {"outside"}, .signal = {{0.0}, {1.0}}, .amount = 1000.0});
    problem.settings.end = 30.0;
    watch_both_sides(problem);
    const MarchReport report = run_through(problem);
    // Newton's corrections end at 5 % of the step's tolerance: the film's share of that.
    EXPECT_NEAR(report.channel_final[0], 20.0 * (report.channel_final[2] - 300.0) - 1000.0,
                20.0 * 0.05 * problem.settings.tolerance);
    EXPECT_LT(report.channel_final[0], -100.0);
    EXPECT_NEAR(report.channel_final[1], 0.0, 1e-8);
    EXPECT_NEAR(report.watts[heater], 1000.0, 1e-9);
}

TEST(HeatFlux, IsShownInWattsPerSquareMetre) {
    EXPECT_EQ(unit_of(Quantity::heat_flux), "W m-2");
    EXPECT_STREQ(shown_unit(Quantity::heat_flux).name, "W/m2");
}

}  // namespace tiretherm::solver
