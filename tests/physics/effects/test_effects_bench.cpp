// SPDX-License-Identifier: BSD-3-Clause
// The extensions that can be distinguished on the bench of two nodes, each against an integration of its definition
// that shares no source file with the program: the thesis's model of tests/support, and the lines below.
#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "physics/effects/bench.hpp"
#include "solver/time_integration/march.hpp"
#include "tests/support/two_node_thesis.hpp"

namespace tiretherm::physics {

namespace {

/// Every number with which an effect enters the definitions, at the value where it is absent.
struct Truth {
    double conductance = 0.0;  ///< W/K, sidewalls
    double liner = 0.0;        ///< W/K
    double rim = 0.0;          ///< W/K
    double pressure = 0.0;     ///< exponent of the gas temperature
    double cornering = 0.0;    ///< 1/N
    double convection = 0.571;
    double partition = 0.0;   ///< s/m
    double loss_slope = 0.0;  ///< 1/K
    double load = 0.0;
    double wave = 0.0;              ///< 1/(km/h)^2
    double critical_speed = 140.0;  ///< km/h
    double road_rate = 0.0;         ///< K/h
    double air_rate = 0.0;          ///< K/h
    double capacity = 1.0;
    double conductivity = 1.0;
    double slip = 1.0;
    double tau = 0.0;         ///< s, bulk probe
    double kelvin = 0.0;      ///< bulk probe
    double excess = 0.0;      ///< bulk probe
    double emissivity = 1.0;  ///< surface camera
};

constexpr double duration = 600.0;

/// Ten minutes from 54 to 173 km/h, from 3 to 6 kN, from 1 to 3 degrees, all in straight lines.
struct Log {
    static double line(double from, double to, double t) { return from + (to - from) * t / duration; }
    static double V(double t) { return line(15.0, 48.0, t); }
    static double Fz(double t) { return line(3000.0, 6000.0, t); }
    static double alpha(double t) { return line(0.0174532925199433, 0.0523598775598299, t); }
    static double Fy(double t) { return line(-1500.0, -4000.0, t); }
    static double T_air(double t) { return line(296.15, 298.15, t); }
    static double T_road(double t) { return line(300.15, 305.15, t); }
};

/// Surface, bulk, gas of the cavity, gas of the pressure, and the lagging bulk probe.
using State = std::array<double, 5>;

State rate(const Truth& truth, double t, const State& y) {
    const auto [Ts, Tb, gas, pressure_gas, probe] = y;
    const double V = Log::V(t);
    const double Fz = Log::Fz(t);
    const double T_air = Log::T_air(t) + truth.air_rate * t / 3600.0;
    const double T_road = Log::T_road(t) + truth.road_rate * t / 3600.0;
    support::TwoNodeThesis model;
    model.V = V;
    model.Fz = Fz;

    double loss = model.SEL(Tb);
    loss *= std::pow((truth.liner > 0.0 ? gas : pressure_gas) / 294.15, -truth.pressure);
    loss *= std::exp(truth.loss_slope * (Tb - 273.15 - 60.0));
    loss *= std::pow(Fz / 4500.0, truth.load);
    loss *= 1.0 + truth.wave * std::pow(std::max(0.0, 3.6 * V - truth.critical_speed), 2);

    const double sliding = V * std::tan(Log::alpha(t));
    const double friction = 0.6 * (1.0 + truth.partition * sliding) * truth.slip * std::abs(Log::Fy(t)) * sliding;

    // (32) at 25 m/s, then its exponent; (33) with its floor.
    const double L = 1.0 / (1.0 / (2.0 * 0.3308) + 1.0 / 0.225);
    const double forced = 0.025 / L * 0.318 * std::pow(25.0 * L / 1.5e-5, 0.571) * std::pow(V / 25.0, truth.convection);
    const double h = std::max(30.0, forced + 8.59e-11 * std::exp(0.0879 * Ts));
    const double air = h * (model.S_tot() - model.S_cont()) * (T_air - Ts);
    const double road = 500.0 * model.S_cont() * (T_road - Ts);
    const double link = truth.conductivity * model.k(Tb) / 0.010 * model.S_tot() * (Tb - Ts);

    const double cornering = truth.cornering * std::pow(Log::Fy(t), 2) * V;
    const double to_gas = truth.liner * (Tb - gas);
    const double sidewall = truth.conductance * (T_air - Tb);
    return {(0.15 * loss + friction + air + road + link) / model.capacity_surface(),
            (0.85 * loss - link + cornering - to_gas + sidewall) / (truth.capacity * model.capacity_bulk()),
            (to_gas - truth.rim * (gas - T_air)) / 70.0,
            (9.0 * (Tb - pressure_gas) - 4.0 * (pressure_gas - T_air)) / 70.0,
            truth.tau > 0.0 ? (Tb - probe) / truth.tau : 0.0};
}

/// Readings of camera and bulk probe at the end, by Runge and Kutta in steps of 0.1 s.
std::array<double, 2> integrate(const Truth& truth) {
    State y{296.15, 298.15, 296.15, 296.15, 298.15};
    constexpr double dt = 0.1;
    for (int step = 0; step < 6000; ++step) {
        const double t = dt * step;
        const auto moved = [&](const State& k, double by) {
            State z = y;
            for (std::size_t i = 0; i < z.size(); ++i) {
                z[i] += by * k[i];
            }
            return z;
        };
        const State k1 = rate(truth, t, y);
        const State k2 = rate(truth, t + 0.5 * dt, moved(k1, 0.5 * dt));
        const State k3 = rate(truth, t + 0.5 * dt, moved(k2, 0.5 * dt));
        const State k4 = rate(truth, t + dt, moved(k3, dt));
        for (std::size_t i = 0; i < y.size(); ++i) {
            y[i] += dt / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]);
        }
    }
    const double mixed =
        truth.emissivity * std::pow(y[0], 4) + (1.0 - truth.emissivity) * std::pow(Log::T_air(duration), 4);
    double bulk = truth.tau > 0.0 ? y[4] : y[1];
    bulk += truth.kelvin;
    bulk += truth.excess * (bulk - 298.15);
    return {std::pow(mixed, 0.25), bulk};
}

std::array<double, 2> simulate(const std::vector<Part>& extensions) {
    Bench bench = two_nodes();
    bench.T = {296.15, 298.15};
    std::vector<Part> parts{{"conduction"},
                            {"strain_energy_loss"},
                            {"sliding_friction"},
                            {"air_convection", {}, {{"exponential", 1}}},
                            {"road_contact"}};
    parts.insert(parts.end(), extensions.begin(), extensions.end());
    solver::Problem problem = Whole::problem_of(bench, parts);
    for (ActiveEffect& active : problem.effects) {
        if (active.effect->sensor_model() != nullptr) {
            active.channels = {active.effect->id == "camera_emissivity" ? 0 : 1};
        }
    }
    const auto log = [&](std::string_view signal, double (*value)(double)) {
        problem.input_signals.add({.signal = find_signal(signal),
                                   .time = {0.0, duration},
                                   .value = {value(0.0), value(duration)},
                                   .logged = false});
    };
    log("speed", Log::V);
    log("vertical_load", Log::Fz);
    log("slip_angle", Log::alpha);
    log("lateral_force", Log::Fy);
    log("air_temperature", Log::T_air);
    log("road_temperature", Log::T_road);
    problem.settings.end = duration;
    problem.settings.tolerance = 1e-6;
    const solver::MarchReport report = solver::run(problem, [](const solver::Snapshot&) { return true; });
    EXPECT_TRUE(report.status.ok()) << report.status.message;
    return {report.channel_final[0], report.channel_final[1]};
}

struct Definition {
    const char* name;
    std::vector<Part> parts;
    Truth truth;
};

class BenchOfTwoNodes : public testing::TestWithParam<Definition> {};

}  // namespace

TEST_P(BenchOfTwoNodes, FollowsTheDefinition) {
    // Both integrations are good to 1e-4 K: local errors of 1e-6 K over some thousand steps that forget, and the fourth
    // power of 0.1 s against time constants of minutes. The effect itself is a hundred times that.
    const std::array<double, 2> expected = integrate(GetParam().truth);
    const std::array<double, 2> simulated = simulate(GetParam().parts);
    EXPECT_NEAR(simulated[0], expected[0], 1e-4);
    EXPECT_NEAR(simulated[1], expected[1], 1e-4);
    if (!GetParam().parts.empty()) {
        const std::array<double, 2> without = integrate({});
        EXPECT_GT(std::max(std::abs(expected[0] - without[0]), std::abs(expected[1] - without[1])), 0.01);
    }
}

INSTANTIATE_TEST_SUITE_P(
    Effects, BenchOfTwoNodes,
    testing::Values(
        Definition{"nothing", {}, {}},
        Definition{"sidewall_convection", {{"sidewall_convection", {{"conductance", 8.0}}}}, {.conductance = 8.0}},
        Definition{"inner_gas", {{"inner_gas", {{"liner", 6.3}, {"rim", 2.8}}}}, {.liner = 6.3, .rim = 2.8}},
        Definition{"inflation_pressure_rise", {{"inflation_pressure_rise", {{"exponent", 0.6}}}}, {.pressure = 0.6}},
        Definition{"pressure_of_the_inner_gas",
                   {{"inner_gas"}, {"inflation_pressure_rise", {{"exponent", 0.6}}}},
                   {.liner = 9.0, .rim = 4.0, .pressure = 0.6}},
        Definition{"cornering_loss", {{"cornering_loss", {{"coefficient", 1e-6}}}}, {.cornering = 1e-6}},
        Definition{"convection_exponent", {{"convection_exponent", {{"exponent", 0.8}}}}, {.convection = 0.8}},
        Definition{"partition_speed", {{"partition_speed", {{"slope", -0.05}}}}, {.partition = -0.05}},
        Definition{"loss_tangent_slope", {{"loss_tangent_slope", {{"slope", -0.004}}}}, {.loss_slope = -0.004}},
        Definition{"load_exponent_of_loss", {{"load_exponent_of_loss", {{"exponent", 0.4}}}}, {.load = 0.4}},
        Definition{"standing_wave",
                   {{"standing_wave", {{"gain", 5e-4}, {"critical_speed", 120.0}}}},
                   {.wave = 5e-4, .critical_speed = 120.0}},
        Definition{"road_temperature_drift", {{"road_temperature_drift", {{"rate", 30.0}}}}, {.road_rate = 30.0}},
        Definition{"air_temperature_drift",
                   {{"air_temperature_drift", {{"rate", -20.0}}}, {"inner_gas"}, {"sidewall_convection"}},
                   {.conductance = 15.0, .liner = 9.0, .rim = 4.0, .air_rate = -20.0}},
        Definition{"sensor_lag", {{"sensor_lag", {{"tau", 40.0}}}}, {.tau = 40.0}},
        Definition{"sensor_offset", {{"sensor_offset", {{"kelvin", -1.5}}}}, {.kelvin = -1.5}},
        Definition{"sensor_gain", {{"sensor_gain", {{"excess", 0.03}}}}, {.excess = 0.03}},
        Definition{"lag_offset_and_gain",
                   {{"sensor_lag"}, {"sensor_offset", {{"kelvin", 2.0}}}, {"sensor_gain", {{"excess", 0.03}}}},
                   {.tau = 10.0, .kelvin = 2.0, .excess = 0.03}},
        Definition{"camera_emissivity",
                   {{"camera_emissivity", {{"emissivity", 0.9}}}, {"air_temperature_drift", {{"rate", 30.0}}}},
                   {.air_rate = 30.0, .emissivity = 0.9}},
        Definition{"layer_heat_capacity", {{"layer_heat_capacity", {{"scale", 1.3}}}}, {.capacity = 1.3}},
        Definition{"layer_conductivity", {{"layer_conductivity", {{"scale", 0.7}}}}, {.conductivity = 0.7}},
        Definition{"slip_input_gain", {{"slip_input_gain", {{"gain", 1.2}}}}, {.slip = 1.2}}),
    [](const testing::TestParamInfo<Definition>& test) { return std::string(test.param.name); });

}  // namespace tiretherm::physics
