// SPDX-License-Identifier: BSD-3-Clause
// Effects between the field and a channel: one number each, by hand.
#include <cmath>

#include <gtest/gtest.h>

#include "mesh/probe.hpp"
#include "physics/effects/bench.hpp"
#include "solver/time_integration/march.hpp"

namespace tiretherm::physics {

namespace {

/// What a sensor model makes of a value, with its numbers.
double read(const Part& part, double value, const Inputs& logged) {
    const solver::Problem problem = Whole::problem_of(two_nodes(), {part});
    const ActiveEffect& effect = problem.effects.front();
    return effect.effect->sensor_model()->read(effect, 1, value, logged);
}

/// A slab 10 mm thick without losses, heated at 1e5 W/m3: 1e5/1.98e6 = 0.0505051 K/s. One channel, 3 mm deep.
constexpr double sampling_rate = 1e5 / 1.98e6;
Bench slab() {
    Bench bench;
    bench.mesh = mesh::build(mesh::Layers{.area = 1.0, .stack = {{.name = "rubber", .thickness = 0.01, .cells = 5}}});
    bench.materials = {rubber()};
    bench.T.assign(static_cast<std::size_t>(bench.mesh.n_nodes), 300.0);
    return bench;
}

solver::Problem heated(const std::vector<Part>& readings) {
    std::vector<Part> parts{{"conduction"}, {"uniform_source", {{"power_density", 1e5}}}};
    parts.insert(parts.end(), readings.begin(), readings.end());
    solver::Problem problem = Whole::problem_of(slab(), parts);
    const mesh::Point point{0.0, 0.0, 0.003};
    problem.channels.resize(1);
    problem.channels[0].where = mesh::at_point(problem.mesh, point);
    problem.channels[0].point = point;
    for (ActiveEffect& effect : problem.effects) {
        if (effect.effect->sensor_model() != nullptr) {
            effect.channels = {0};
        }
    }
    problem.input_signals.add(*find_signal("air_temperature"), 280.0);
    problem.settings.end = 60.0;
    return problem;
}

double final_reading(const std::vector<Part>& readings) {
    const solver::Problem problem = heated(readings);
    const solver::MarchReport report = solver::run(problem, [](const solver::Snapshot&) { return true; });
    EXPECT_TRUE(report.status.ok());
    return report.channel_final.front();
}

}  // namespace

TEST(CameraEmissivity, MixesTheFourthPowers) {
    // 80 C seen with 0.95 in air of 23 C: (0.95 * 353.15^4 + 0.05 * 296.15^4)^(1/4) = 350.89 K, 2.3 K low.
    const double seen = read({"camera_emissivity", {{"emissivity", 0.95}}}, 353.15, rolling());
    EXPECT_NEAR(seen, std::pow(0.95 * std::pow(353.15, 4) + 0.05 * std::pow(296.15, 4), 0.25), 1e-9);
    EXPECT_NEAR(seen, 350.89, 0.01);
    EXPECT_NEAR(read({"camera_emissivity"}, 296.15, rolling()), 296.15, 1e-9);
}

TEST(SensorOffset, AddsKelvin) { EXPECT_NEAR(read({"sensor_offset", {{"kelvin", -1.5}}}, 353.15, {}), 351.65, 1e-12); }

TEST(SensorOffset, MayDifferBetweenChannels) {
    ActiveEffect effect = activate(*find_effect("sensor_offset"), two_nodes().mesh);
    effect.parameters = {1.0};
    effect.channels = {4, 7};
    effect.overrides = {{.scope = Scope::channel, .index = 7, .parameter = 0, .value = 3.0}};
    EXPECT_EQ(effect.effect->sensor_model()->read(effect, 0, 300.0, {}), 301.0);
    EXPECT_EQ(effect.effect->sensor_model()->read(effect, 1, 300.0, {}), 303.0);
}

TEST(SensorDrift, GrowsWithTheTimeOfTheRun) {
    // 60 K/h for the 60 s of the run: 1 K.
    EXPECT_NEAR(final_reading({{"sensor_drift", {{"rate", 60.0}}}}) - final_reading({}), 1.0, 1e-9);
}

TEST(SensorGain, TurnsAbout25C) {
    // 80 C: 0.05 * (80 - 25) = 2.75 K too high.
    EXPECT_NEAR(read({"sensor_gain", {{"excess", 0.05}}}, 353.15, {}), 353.15 + 2.75, 1e-12);
    EXPECT_EQ(read({"sensor_gain", {{"excess", 0.05}}}, 298.15, {}), 298.15);
}

TEST(PressureReadingSpeed, FallsWithTheSquareOfTheSpeed) {
    // 2.5 bar at 30 m/s: 2.5e5 / (1 + 1e-5 * 900) = 247 770 Pa.
    EXPECT_NEAR(read({"pressure_reading_speed"}, 2.5e5, {.speed = 30.0}), 247770.0, 0.1);
}

TEST(SensorLag, StaysBehindARamp) {
    // T = 300 + r t: T - T_m = r tau (1 - exp(-t/tau)); tau 10 s, after 60 s 0.503799 K. The lag is integrated exactly.
    EXPECT_NEAR(final_reading({{"sensor_lag", {{"tau", 10.0}}}}),
                300.0 + sampling_rate * 60.0 - sampling_rate * 10.0 * (1.0 - std::exp(-6.0)), 1e-9);
}

TEST(ClockDelay, ReadsAnEarlierTime) {
    // 0.5 s late on a ramp: r * 0.5 s low, 0.5 s early: as much high.
    EXPECT_NEAR(final_reading({{"clock_delay", {{"delay", 0.5}}}}), 300.0 + sampling_rate * 59.5, 1e-9);
    EXPECT_NEAR(final_reading({{"clock_delay", {{"delay", -0.5}}}}), 300.0 + sampling_rate * 60.5, 1e-9);
}

TEST(ClockRate, ReadsLaterAndLater) {
    // 0.1 s for each second, of 60 s on a ramp: what was there at 54 s, or at 66 s.
    EXPECT_NEAR(final_reading({{"clock_rate", {{"rate", 0.1}}}}), 300.0 + sampling_rate * 54.0, 1e-9);
    EXPECT_NEAR(final_reading({{"clock_rate", {{"rate", -0.1}}}}), 300.0 + sampling_rate * 66.0, 1e-9);
}

TEST(SensorDepth, ReadsDeeper) {
    // A field that rises by 1 K/mm, read at 3 + 1.5 mm before anything happens: 304.5 K.
    solver::Problem problem = heated({{"sensor_depth", {{"offset", 0.0015}}}});
    for (std::size_t node = 0; node < problem.initial.size(); ++node) {
        problem.initial[node] = 300.0 + 1000.0 * problem.mesh.centre[node][2];
    }
    double first = 0.0;
    const solver::MarchReport report = solver::run(problem, [&](const solver::Snapshot& s) {
        first = s.channels[0];
        return false;
    });
    EXPECT_EQ(report.status.outcome, solver::Outcome::stopped);
    EXPECT_NEAR(first, 304.5, 1e-9);
}

TEST(SensorOutputs, ActInTheOrderOfTheCatalogue) {
    // Lag first, then the offset, then the gain about 25 C of what the offset left, whatever the order in the case.
    const double lagged = 300.0 + sampling_rate * 60.0 - sampling_rate * 10.0 * (1.0 - std::exp(-6.0));
    const double expected = (lagged + 2.0) + 0.1 * (lagged + 2.0 - 298.15);
    EXPECT_NEAR(final_reading({{"sensor_lag", {{"tau", 10.0}}},
                               {"sensor_offset", {{"kelvin", 2.0}}},
                               {"sensor_gain", {{"excess", 0.1}}}}),
                expected, 1e-9);
}

TEST(SensorOutputs, CameraSeesBeforeItLags) {
    // What lags is the mixed temperature. On a ramp of 3 K it is straight to 1e-4 K: its own ramp less its own lag.
    const double e = 0.9;
    const auto seen = [&](double T) { return std::pow(e * std::pow(T, 4) + (1.0 - e) * std::pow(280.0, 4), 0.25); };
    const double end = seen(300.0 + sampling_rate * 60.0);
    const double slope = (end - seen(300.0 + sampling_rate * 59.0));
    EXPECT_NEAR(final_reading({{"camera_emissivity", {{"emissivity", e}}}, {"sensor_lag", {{"tau", 10.0}}}}),
                end - slope * 10.0 * (1.0 - std::exp(-6.0)), 1e-3);
}

}  // namespace tiretherm::physics
