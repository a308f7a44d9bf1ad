// SPDX-License-Identifier: BSD-3-Clause
// A lagging sensor follows a parabola exactly in long steps, against the closed form.

#include <cmath>

#include <gtest/gtest.h>

#include "solver/bench.hpp"
#include "solver/time_integration/march.hpp"

namespace tiretherm::solver {

// An insulated lump under a power that grows as p t: T = T0 + a t^2 with a = p/(2 C), which the method steps exactly. A
// sensor behind it by tau dm/dt = T - m gives m = T0 + a (t^2 - 2 tau t + 2 tau^2 (1 - exp(-t/tau))), at the ends of
// the steps and inside them.
TEST(SensorOutputs, LagFollowsAParabolaExactlyInLongSteps) {
    constexpr double tau = 10.0;
    constexpr double p = 2.0;  // W/s
    Problem problem;
    problem.mesh = mesh::build(mesh::Layers{.area = 0.01, .stack = {{"rubber", 0.01, 1}}});
    problem.materials = {material(physics::Curve::constant(0.29))};
    act(problem, "conduction");
    act(problem, "laser");
    problem.effects.back().patches = {1};
    act(problem, "sensor_lag", {{"tau", tau}});
    problem.effects.back().channels = {0};
    problem.input_signals.add(
        {.signal = physics::find_signal("laser_power"), .time = {0.0, 60.0}, .value = {0.0, p * 60.0}});
    problem.initial.assign(static_cast<std::size_t>(problem.mesh.n_nodes), 300.0);
    problem.settings.end = 60.0;
    problem.settings.fixed_step = 20.0;
    problem.settings.tolerance = 1e-9;
    problem.settings.output_interval = 4.0;
    problem.channels = {{.name = "mean", .meaning = "", .where = mesh::over_cells(problem.mesh, 0)}};
    const double a = p / (2.0 * 0.01 * 0.01 * 1100.0 * 1800.0);
    int rows = 0;
    const MarchReport report = run(problem, [&](const Snapshot& now) {
        const double t = now.time;
        const double lagged = 300.0 + a * (t * t - 2.0 * tau * t + 2.0 * tau * tau * (1.0 - std::exp(-t / tau)));
        EXPECT_NEAR(now.channels[0], lagged, 1e-8) << "at " << t << " s";
        ++rows;
        return true;
    });
    EXPECT_TRUE(report.status.ok()) << report.status.message;
    EXPECT_EQ(rows, 16);
}

}  // namespace tiretherm::solver
