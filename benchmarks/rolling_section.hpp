// SPDX-License-Identifier: BSD-3-Clause
// Shared benchmark problem: a tire's cross-section of 24 x 64 cells with the thesis's effects, sidewalls, rim and gas,
// driven by a noisy log or by constant inputs.
#pragma once

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "mesh/builders.hpp"
#include "solver/problem.hpp"

namespace tiretherm::benchmarks {

inline constexpr double deg = std::numbers::pi / 180.0;
inline constexpr int seconds = 3600;

inline mesh::Section section(const physics::Tire& tire) {
    mesh::Section d;
    d.meridian = mesh::Meridian(tire.unloaded_radius, {{0.0675, 1.0}, {0.045, 16.0}, {0.105, 75.0 * deg / 0.105}});
    d.layers = {{"tread", 0.008, 12},
                {"belt", 0.002, 5},
                {"sidewall", 0.007, 17},
                {"carcass", 0.0012, 4},
                {"liner", 0.0008, 3}};
    d.zones = {{"outside_sidewall", 0.105, 8, 1.0, {2, 3, 4}, false},
               {"outside_shoulder", 0.045, 10, 1.0, {0, 1, 3, 4}},
               {"crown", 0.135, 28, 1.0, {0, 1, 3, 4}},
               {"inside_shoulder", 0.045, 10, 1.0, {0, 1, 3, 4}},
               {"inside_sidewall", 0.105, 8, 1.0, {2, 3, 4}, false}};
    return d;
}

/// Error-controlled to 0.05 K, an hour long, at 23 degC.
inline solver::Problem rolling_section() {
    solver::Problem problem;
    problem.mesh = mesh::build(section(problem.tire));
    const auto rubber = [](double k_20, double k_90) {
        const physics::Curve k = physics::Curve::quadratic_about(293.15, k_20, (k_90 - k_20) / 70.0, 0.0);
        return physics::Material{.name = "rubber",
                                 .density = 1100.0,
                                 .heat_capacity = physics::Curve::constant(1800.0),
                                 .conductivity = {k, k, k}};
    };
    const physics::Material outer = rubber(0.29, 0.95);
    const physics::Material inner = rubber(0.06, 0.075);
    problem.materials = {outer, inner, outer, inner, inner};
    for (const char* id : {"conduction", "strain_energy_loss", "sliding_friction", "air_convection", "road_contact",
                           "sidewall_convection", "rim_conduction", "inner_gas", "camber_asymmetry"}) {
        solver::switch_on(problem, physics::activate(*physics::find_effect(id), problem.mesh), 296.15);
    }
    problem.input_signals.add(*physics::find_signal("air_temperature"), 296.15);
    problem.input_signals.add(*physics::find_signal("road_temperature"), 300.15);
    problem.initial.assign(static_cast<std::size_t>(problem.mesh.n_nodes), 296.15);
    problem.settings.end = seconds;
    problem.settings.tolerance = 0.05;
    problem.settings.output_interval = 10.0;
    return problem;
}

/// Laps of 90 s: speed 60 to 180 km/h, load and slip with the corners, noise of a logger on all.
inline void drive_logged(solver::Problem& problem) {
    std::mt19937_64 random(7);
    std::normal_distribution<double> noise;
    std::vector<double> time;
    std::vector<std::vector<double>> values(5);
    for (int i = 0; i <= seconds; ++i) {
        const double lap = 2.0 * std::numbers::pi * i / 90.0;
        const double corner = std::sin(3.0 * lap) * std::abs(std::sin(3.0 * lap));
        time.push_back(i);
        values[0].push_back((120.0 + 60.0 * std::sin(lap) + 0.5 * noise(random)) / 3.6);
        values[1].push_back(4000.0 + 1500.0 * corner + 150.0 * noise(random));
        values[2].push_back(2.0 * deg * corner + 0.1 * deg * noise(random));
        values[3].push_back(3500.0 * corner + 200.0 * noise(random));
        values[4].push_back(-1.0 * deg);
    }
    const char* names[] = {"speed", "vertical_load", "slip_angle", "lateral_force", "camber"};
    for (std::size_t s = 0; s < values.size(); ++s) {
        problem.input_signals.add(
            solver::Series{.signal = physics::find_signal(names[s]), .time = time, .value = values[s], .logged = true});
    }
}

inline void drive_constant(solver::Problem& problem) {
    problem.input_signals.add(*physics::find_signal("speed"), 120.0 / 3.6);
    problem.input_signals.add(*physics::find_signal("vertical_load"), 4000.0);
    problem.input_signals.add(*physics::find_signal("camber"), -1.0 * deg);
}

}  // namespace tiretherm::benchmarks
