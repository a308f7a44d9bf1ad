// SPDX-License-Identifier: BSD-3-Clause
// A 225/50 R17 tire section of five zones at any refinement, rolling with the thesis's effects, and its mirror image.
#pragma once

#include <numbers>

#include "mesh/builders.hpp"
#include "tests/support/problem.hpp"

namespace tiretherm::support {

inline constexpr double deg = std::numbers::pi / 180.0;

/// A 225/50 R17 as a section of five zones: tread 8 mm, belt 2 mm, carcass 1.2 mm, liner 0.8 mm; 7 mm of sidewall rubber
/// outside of the last two. Every length is divided by `refinement` times the coarsest number of cells.
inline mesh::Section tire_section(const physics::Tire& tire, int refinement) {
    const double shoulder = 0.2 * tire.width;
    const double crown = tire.width - 2.0 * shoulder;
    const double sidewall = 0.105;
    const double turn = 0.5 * crown;  // rad, of a crown of 1 m radius
    mesh::Section section;
    section.meridian = mesh::Meridian(
        tire.unloaded_radius,
        {{0.5 * crown, 1.0}, {shoulder, (45.0 * deg - turn) / shoulder}, {sidewall, 75.0 * deg / sidewall}});
    section.layers = {{"tread", 0.008, 3 * refinement},
                      {"belt", 0.002, refinement},
                      {"sidewall", 0.007, 3 * refinement},
                      {"carcass", 0.0012, refinement},
                      {"liner", 0.0008, refinement}};
    const std::vector<int> under_tread{0, 1, 3, 4};
    const std::vector<int> beside{2, 3, 4};
    section.zones = {{"outside_sidewall", sidewall, 2 * refinement, 1.0, beside, false},
                     {"outside_shoulder", shoulder, 2 * refinement, 1.0, under_tread},
                     {"crown", crown, 4 * refinement, 1.0, under_tread},
                     {"inside_shoulder", shoulder, 2 * refinement, 1.0, under_tread},
                     {"inside_sidewall", sidewall, 2 * refinement, 1.0, beside, false}};
    return section;
}

/// The thesis's effects and those of a whole tire on that section, rolling at 100 km/h under 4000 N, all at 23 degC.
inline solver::Problem tire_problem(int refinement) {
    solver::Problem problem;
    problem.title = "tire section";
    problem.mesh = mesh::build(tire_section(problem.tire, refinement));
    const physics::Material rubber = material(0.29, 1100.0, 1800.0);
    const physics::Material below = material(0.2, 1150.0, 1600.0);
    problem.materials = {rubber, below, rubber, below, below};
    for (const char* id : {"conduction", "strain_energy_loss", "sliding_friction", "air_convection", "road_contact",
                           "sidewall_convection", "rim_conduction", "inner_gas"}) {
        switch_on(problem, id);
    }
    hold(problem, "speed", 100.0 / 3.6);
    hold(problem, "vertical_load", 4000.0);
    hold(problem, "air_temperature", 296.15);
    hold(problem, "road_temperature", 296.15);
    start_at(problem, 296.15);
    problem.settings.end = 600.0;
    return problem;
}

/// A field as it would look in a mirror in the centre plane: of columns, their surface nodes and the beads.
/// @param T [n_nodes]
inline std::vector<double> mirrored(const mesh::Mesh& mesh, const std::vector<double>& T) {
    std::vector<double> result = T;
    const std::size_t n = mesh.columns.size();
    const auto at = [](int node) { return static_cast<std::size_t>(node); };
    for (std::size_t i = 0; i < n; ++i) {
        const mesh::Column& here = mesh.columns[i];
        const mesh::Column& there = mesh.columns[n - 1 - i];
        result[at(here.outer)] = T[at(there.outer)];
        result[at(here.inner)] = T[at(there.inner)];
        for (int k = 0; k < here.cells(); ++k) {
            result[at(here.first_cell + k)] = T[at(there.first_cell + k)];
        }
    }
    const std::vector<mesh::PatchFace>& beads = mesh.patches[at(mesh.find_patch("beads"))].faces;
    for (std::size_t i = 0; i < beads.size(); ++i) {
        result[at(beads[i].node)] = T[at(beads[(i + beads.size() / 2) % beads.size()].node)];
    }
    return result;
}

}  // namespace tiretherm::support
