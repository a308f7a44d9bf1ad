#pragma once

#include <vector>

#include "mesh/builders.hpp"
#include "physics/effect.hpp"

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

    [[nodiscard]] Stock stock() const { return {.materials = materials, .link_laws = link_laws, .tire = tire}; }

    void place(ActiveEffect& effect) const {
        if (effect.effect->place != nullptr) {
            const Stock stock = this->stock();
            effect.effect->place({.mesh = mesh, .stock = stock, .effects = {&effect, 1}}, effect);
        }
    }

    /// What the effect says at `temperature` under `inputs`. The terms keep a view of `temperature`.
    [[nodiscard]] Terms said(const ActiveEffect& effect, const Inputs& inputs,
                             const std::vector<double>& temperature) const {
        std::vector<double> intensities(static_cast<std::size_t>(effect.effect->n_intensities));
        if (effect.effect->drive != nullptr) {
            effect.effect->drive(effect, {.tire = tire, .inputs = inputs, .laws = {}}, intensities);
        }
        Terms terms(mesh, 1);
        terms.begin(temperature);
        const std::vector<double> region_mean = means(temperature);
        const Stock stock = this->stock();
        effect.effect->speak({.mesh = mesh,
                              .stock = stock,
                              .temperature = temperature,
                              .region_mean = region_mean,
                              .active = effect,
                              .intensities = intensities},
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

/// 100 km/h, 4000 N, 2 degrees of slip, everything else at 23 C.
inline Inputs rolling() {
    return {.speed = 100.0 / 3.6,
            .vertical_load = 4000.0,
            .slip_angle = 0.0349065850398866,
            .slip_ratio = 0.01,
            .lateral_force = 2000.0,
            .longitudinal_force = 500.0,
            .air_temperature = 296.15,
            .road_temperature = 296.15,
            .laser_power = 1.0};
}

}  // namespace tiretherm::physics
