// SPDX-License-Identifier: BSD-3-Clause
// Small meshes, materials and operating points on which tests evaluate single effects.
#pragma once

#include <cassert>
#include <string_view>
#include <utility>
#include <vector>

#include "mesh/builders.hpp"
#include "physics/effect.hpp"
#include "solver/system.hpp"

namespace tiretherm::physics {

/// A mesh, materials and a moment on it, for asking one effect what it says.
struct Bench {
    mesh::Mesh mesh;
    std::vector<Material> materials;
    std::vector<Curve> link_laws;
    Tire tire;
    std::vector<double> T;

    [[nodiscard]] std::vector<double> means(const std::vector<double>& temperature) const {
        std::vector<double> values;
        for (const mesh::Region& region : mesh.regions) {
            values.push_back(region.mean(temperature));
        }
        return values;
    }

    [[nodiscard]] ActiveEffect active(std::string_view id) const {
        ActiveEffect effect = activate(*find_effect(id), mesh);
        place(effect);
        return effect;
    }

    [[nodiscard]] MaterialModel material_model() const {
        return {.materials = materials, .link_laws = link_laws, .tire = tire};
    }

    void place(ActiveEffect& effect) const {
        const MaterialModel material_model = this->material_model();
        effect.effect->place({.mesh = mesh, .material_model = material_model, .effects = {&effect, 1}}, effect);
    }

    /// What the effect says at `temperature` under `inputs`. The terms keep a view of `temperature`.
    [[nodiscard]] Terms said(const ActiveEffect& effect, const Inputs& inputs,
                             const std::vector<double>& temperature) const {
        const HeatEffect& heat = *effect.effect->heat_effect();
        std::vector<double> coefficients(static_cast<std::size_t>(heat.n_coefficients));
        if (heat.evaluate_coefficients != nullptr) {
            heat.evaluate_coefficients(effect, {.tire = tire, .inputs = inputs, .laws = {}}, coefficients);
        }
        Terms terms(mesh, 1);
        terms.begin(temperature);
        const std::vector<double> region_mean = means(temperature);
        const MaterialModel material_model = this->material_model();
        heat.add_terms({.mesh = mesh,
                        .material_model = material_model,
                        .temperature = temperature,
                        .region_mean = region_mean,
                        .active = effect,
                        .coefficients = coefficients},
                       terms);
        return terms;
    }

    [[nodiscard]] double watts(const ActiveEffect& effect, const Inputs& inputs) const {
        return said(effect, inputs, T).watts[0];
    }
};

inline Material rubber() {
    const Curve k = Curve::constant(0.29);
    return {.name = "rubber", .density = 1100.0, .heat_capacity = Curve::constant(1800.0), .conductivity = {k, k, k}};
}

/// The thesis's two nodes, surface at 35 C and bulk at 55 C.
inline Bench two_nodes() {
    Bench bench;
    const double volume = bench.tire.band_mass() / bench.tire.density;
    bench.mesh = mesh::build(mesh::TwoNode{.area = bench.tire.outer_area(),
                                           .surface_volume = 0.15 * volume,
                                           .bulk_volume = 0.85 * volume,
                                           .bulk_depth = 0.010});
    bench.materials.assign(2, rubber());
    bench.link_laws = {Curve::quadratic_about(293.15, 0.29, 0.00943, 0.0)};
    bench.T = {308.15, 328.15};
    return bench;
}

/// A quarter of a specimen of two layers under a laser, at 300 K.
inline Bench specimen() {
    Bench bench;
    bench.mesh = mesh::build(mesh::Block{.x = {{.to = 0.03, .cells = 6}},
                                         .y = {{.to = 0.03, .cells = 5}},
                                         .stack = {{.name = "tread", .thickness = 0.003, .cells = 2},
                                                   {.name = "bulk", .thickness = 0.012, .cells = 3}}});
    bench.materials.assign(2, rubber());
    bench.T.assign(static_cast<std::size_t>(bench.mesh.n_nodes), 300.0);
    return bench;
}

/// A cross-section in five zones: tread, belt, carcass and liner between the shoulders, carcass and liner in the
/// sidewalls. Warmer inside.
inline Bench section() {
    Bench bench;
    const std::vector<int> crown{0, 1, 2, 3};
    const std::vector<int> wall{2, 3};
    bench.mesh = mesh::build(mesh::Section{
        .meridian = mesh::Meridian{0.3308, {{.length = 0.07, .curvature = 1.0}, {.length = 0.04, .curvature = 20.0}}},
        .layers = {{.name = "tread", .thickness = 0.008, .cells = 2},
                   {.name = "belt", .thickness = 0.003},
                   {.name = "carcass", .thickness = 0.002},
                   {.name = "liner", .thickness = 0.002}},
        .zones = {{.name = "outside_sidewall", .length = 0.07, .cells = 2, .stack = wall, .tread = false},
                  {.name = "outside_shoulder", .length = 0.045, .cells = 2, .stack = crown},
                  {.name = "crown", .length = 0.135, .cells = 3, .stack = crown},
                  {.name = "inside_shoulder", .length = 0.045, .cells = 2, .stack = crown},
                  {.name = "inside_sidewall", .length = 0.07, .cells = 2, .stack = wall, .tread = false}}});
    bench.materials.assign(4, rubber());
    for (int node = 0; node < bench.mesh.n_nodes; ++node) {
        bench.T.push_back(308.15 + 1000.0 * bench.mesh.centre[static_cast<std::size_t>(node)][2]);
    }
    return bench;
}

/// 100 km/h, 4000 N, 2 degrees of slip angle, everything else at 23 C.
inline Inputs rolling() {
    return {.speed = 100.0 / 3.6,
            .vertical_load = 4000.0,
            .slip_angle = 0.0349065850398866,
            .lateral_force = 2000.0,
            .longitudinal_force = 500.0,
            .camber = -0.05,
            .inflation_pressure = 2.3e5,
            .air_temperature = 296.15,
            .road_temperature = 296.15,
            .wet = 1.0,
            .laser_power = 1.0,
            .brake_temperature = 573.15};
}
/// The same, driven: the wheel turns faster by a hundredth.
inline Inputs driven() {
    Inputs inputs = rolling();
    inputs.slip_ratio = 0.01;
    return inputs;
}

/// An effect to switch on, with the numbers and choices that are not standard.
struct Part {
    std::string_view id;
    std::vector<std::pair<std::string_view, double>> numbers{};
    std::vector<std::pair<std::string_view, int>> choices{};  ///< key and index of the option
};

/// Several effects on a bench, asked as the solver asks them; nodes that they append start at 23 C. Two channels: the
/// means of surface and bulk.
class Whole {
public:
    Whole(const Bench& bench, const std::vector<Part>& parts) : problem_(problem_of(bench, parts)), system_(problem_) {}
    Whole(const Whole&) = delete;
    Whole& operator=(const Whole&) = delete;
    ~Whole() = default;

    /// Lets every effect add its terms; they stay until the next call.
    const Whole& ask(const Inputs& inputs, const std::vector<double>& T) {
        std::vector<double> coefficients(system_.n_coefficients());
        system_.evaluate_coefficients(inputs, coefficients);
        temperature_ = T;
        system_.evaluate(temperature_, coefficients);
        return *this;
    }
    const Whole& ask(const Inputs& inputs) { return ask(inputs, problem_.initial); }

    [[nodiscard]] std::size_t index(std::string_view id) const {
        for (std::size_t e = 0; e < problem_.effects.size(); ++e) {
            if (problem_.effects[e].effect->id == id) {
                return e;
            }
        }
        assert(false);
        return 0;
    }
    [[nodiscard]] double watts(std::string_view id) const { return system_.terms().watts[index(id)]; }
    /// Heat flow into a node. W
    [[nodiscard]] double flow(int node) const { return system_.heat_flow()[static_cast<std::size_t>(node)]; }
    [[nodiscard]] int node(std::string_view lumped_node) const { return problem_.mesh.find_lumped_node(lumped_node); }
    [[nodiscard]] const solver::Problem& problem() const { return problem_; }
    [[nodiscard]] const solver::System& system() const { return system_; }

    static solver::Problem problem_of(const Bench& bench, const std::vector<Part>& parts) {
        solver::Problem problem;
        problem.mesh = bench.mesh;
        problem.materials = bench.materials;
        problem.link_laws = bench.link_laws;
        problem.tire = bench.tire;
        problem.initial = bench.T;
        problem.channels = {{.name = "surface", .meaning = "", .where = bench.mesh.regions[0].mean},
                            {.name = "bulk", .meaning = "", .where = bench.mesh.regions[1].mean}};
        for (const Part& part : parts) {
            ActiveEffect active = activate(*find_effect(part.id), problem.mesh);
            for (const auto& [key, value] : part.numbers) {
                assert(find_parameter(*active.effect, key) >= 0);
                active.parameters[static_cast<std::size_t>(find_parameter(*active.effect, key))] = value;
            }
            for (const auto& [key, option] : part.choices) {
                assert(find_choice(*active.effect, key) >= 0);
                active.choices[static_cast<std::size_t>(find_choice(*active.effect, key))] = option;
            }
            if (active.effect->sensor_model() != nullptr) {
                active.channels = {0, 1};
            }
            if (part.id.starts_with(
                    "own_")) {  // follows a signal that grows from 0.5 to 1.5 in an hour, on the surface
                active.tables.front() = Curve::table({0.0, 3600.0}, {0.5, 1.5});
                active.nodes = bench.mesh.regions[0].mean.nodes;
            }
            solver::switch_on(problem, std::move(active), 296.15);
        }
        return problem;
    }

private:
    solver::Problem problem_;
    solver::System system_;
    std::vector<double> temperature_;
};

}  // namespace tiretherm::physics
