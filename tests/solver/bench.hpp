// SPDX-License-Identifier: BSD-3-Clause
// Small problems put together by hand, for tests of the solver: a cooled strip and the two-node tire.
#pragma once

#include <initializer_list>
#include <string_view>
#include <utility>

#include "mesh/builders.hpp"
#include "mesh/probe.hpp"
#include "solver/problem.hpp"
#include "tests/support/problem.hpp"

namespace tiretherm::solver {

inline physics::Material material(const physics::Curve& k) {
    return {.name = "rubber",
            .density = 1100.0,
            .heat_capacity = physics::Curve::constant(1800.0),
            .conductivity = {k, k, k}};
}

inline void act(Problem& problem, std::string_view id,
                std::initializer_list<std::pair<std::string_view, double>> values = {}) {
    physics::ActiveEffect active = physics::activate(*physics::find_effect(id), problem.mesh);
    for (const auto& [key, value] : values) {
        active.parameters[static_cast<std::size_t>(physics::find_parameter(*active.effect, key))] = value;
    }
    switch_on(problem, std::move(active), 293.15);
}

using support::hold;

/// A strip of rubber, 10 mm thick, 1 m2, cooled on both sides with h = 20 W/m2K to 300 K; 300 K at the start.
inline Problem strip(int cells) {
    Problem problem;
    problem.mesh =
        mesh::build(mesh::Layers{.area = 1.0, .stack = {{.name = "rubber", .thickness = 0.01, .cells = cells}}});
    problem.materials = {material(physics::Curve::constant(0.29))};
    act(problem, "conduction");
    act(problem, "still_air", {{"h", 20.0}});
    problem.effects.back().patches = {0, 1};
    hold(problem, "air_temperature", 300.0);
    problem.initial.assign(static_cast<std::size_t>(problem.mesh.n_nodes), 300.0);
    problem.settings.end = 1000.0;
    problem.channels = {{.name = "mean", .meaning = "", .where = mesh::over_cells(problem.mesh, 0)}};
    return problem;
}

/// The same heated through its volume.
inline Problem heated_strip(int cells, double watts_per_m3 = 1e5) {
    Problem problem = strip(cells);
    act(problem, "uniform_source", {{"power_density", watts_per_m3}});
    return problem;
}

/// The thesis's tire at 4000 N and 100 km/h, everything at 23 C.
inline Problem two_node_tire() {
    Problem problem;
    const double volume = problem.tire.band_mass() / problem.tire.density;
    problem.mesh = mesh::build(mesh::TwoNode{.area = problem.tire.outer_area(),
                                             .surface_volume = 0.15 * volume,
                                             .bulk_volume = 0.85 * volume,
                                             .bulk_depth = 0.010});
    problem.materials.assign(2, material(physics::Curve::constant(0.29)));
    problem.link_laws = {physics::Curve::quadratic_about(293.15, 0.29, 0.00943, 0.0)};
    for (const char* id : {"conduction", "strain_energy_loss", "sliding_friction", "air_convection", "road_contact"}) {
        act(problem, id);
    }
    hold(problem, "speed", 100.0 / 3.6);
    hold(problem, "vertical_load", 4000.0);
    hold(problem, "air_temperature", 296.15);
    hold(problem, "road_temperature", 296.15);
    problem.initial.assign(2, 296.15);
    problem.settings.end = 600.0;
    problem.channels = {{.name = "surface_temperature", .meaning = "", .where = problem.mesh.regions[0].mean},
                        {.name = "bulk_temperature", .meaning = "", .where = problem.mesh.regions[1].mean}};
    return problem;
}

}  // namespace tiretherm::solver
