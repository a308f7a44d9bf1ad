// SPDX-License-Identifier: BSD-3-Clause
// Random blocks by seed, far into the corners of what a case may ask: cells, layers, laws, films, inputs, steps; and their
// mirror images.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "mesh/tensor.hpp"
#include "tests/support/ended_run.hpp"

namespace tiretherm::support {

/// What may be drawn.
struct Ground {
    int most_cells = 300;
    bool linear = false;            ///< constant k and c, films alone
    bool sources = true;            ///< heat is made
    bool logs = true;               ///< the air's temperature may be a log, or else a schedule of jumps
    double least_tolerance = 1e-3;  ///< K
};

/// A heat capacity that is `base` but for a triangle about `T`, as of something that melts. @param joules J/kg, its area
inline physics::Curve melting(double base, double T, double half_width, double joules) {
    return physics::Curve::table({T - half_width, T, T + half_width}, {base, base + joules / half_width, base});
}

/// A block of cells on three axes, each cell of a layer of its own, with a film on every side.
struct Block {
    std::array<std::vector<double>, 3> edge;
    std::vector<int> layer;  ///< [n_cells]
    std::vector<physics::Material> materials;
    std::array<double, 6> film{};    ///< W/m2K of each side
    std::array<bool, 6> radiates{};  ///< and has natural convection
    double power_density = 0.0;      ///< W/m3
    std::vector<double> initial;     ///< [n_cells] K
    std::vector<double> air_time;    ///< s
    std::vector<double> air;         ///< K
    bool logged = false;
    solver::Settings settings;

    static constexpr std::array<std::string_view, 6> sides{"left", "right", "front", "back", "top", "bottom"};

    [[nodiscard]] int size(std::size_t axis) const { return static_cast<int>(edge[axis].size()) - 1; }
    [[nodiscard]] int cells() const { return size(0) * size(1) * size(2); }
    [[nodiscard]] double coldest() const { return std::min(std::ranges::min(initial), std::ranges::min(air)); }
    [[nodiscard]] double hottest() const { return std::max(std::ranges::max(initial), std::ranges::max(air)); }

    [[nodiscard]] std::string title() const {
        return fmt::format("{} x {} x {} cells of {} materials, {:.2g} to {:.2g} mm deep, {:.3g} s{}{}{}", size(0),
                           size(1), size(2), materials.size(), 1e3 * (edge[2][1] - edge[2][0]), 1e3 * edge[2].back(),
                           settings.end, settings.steady ? ", steady" : "",
                           settings.fixed_step ? fmt::format(", steps of {:.2g} s", *settings.fixed_step) : "",
                           settings.method == solver::Method::backward_euler ? ", backward Euler" : "");
    }

    /// @param order of its effects; empty: as they come
    [[nodiscard]] solver::Problem problem(const std::vector<std::size_t>& order = {}) const {
        solver::Problem problem;
        problem.title = title();
        mesh::Tensor tensor{.kind = "block",
                            .edge = edge,
                            .layer_of_k = std::vector<int>(edge[2].size() - 1, 0),
                            .layers = {},
                            .mirror = {},
                            .patch = {}};
        for (std::size_t i = 0; i < materials.size(); ++i) {
            tensor.layers.push_back(fmt::format("layer_{}", i));
        }
        for (std::size_t side = 0; side < 6; ++side) {
            tensor.patch[side] = sides[side];
        }
        problem.mesh = mesh::build(tensor);
        std::ranges::copy(layer, problem.mesh.layer.begin());
        problem.initial.assign(static_cast<std::size_t>(problem.mesh.n_nodes), 0.0);
        std::ranges::copy(initial, problem.initial.begin());
        for (const mesh::Patch& patch : problem.mesh.patches) {
            for (const mesh::PatchFace& face : patch.faces) {
                problem.mesh.layer[static_cast<std::size_t>(face.node)] = layer[static_cast<std::size_t>(face.cell)];
                problem.initial[static_cast<std::size_t>(face.node)] = initial[static_cast<std::size_t>(face.cell)];
            }
        }
        problem.materials = materials;
        switch_on(problem, "conduction");
        for (std::size_t side = 0; side < 6; ++side) {
            if (film[side] > 0.0) {
                switch_on(problem, "still_air", {{"h", film[side]}}, {sides[side]});
            }
            if (radiates[side]) {
                switch_on(problem, "radiation", {}, {sides[side]});
                switch_on(problem, "natural_convection", {}, {sides[side]});
            }
        }
        if (power_density != 0.0) {
            switch_on(problem, "uniform_source", {{"power_density", power_density}});
        }
        std::vector<physics::ActiveEffect> ordered;
        ordered.reserve(order.size());
        for (const std::size_t i : order) {
            ordered.push_back(problem.effects[i]);
        }
        problem.effects = order.empty() ? problem.effects : ordered;
        if (air.size() == 1) {
            hold(problem, "air_temperature", air.front());
        } else if (logged) {
            log(problem, "air_temperature", air_time, air);
        } else {
            schedule(problem, "air_temperature", air_time, air);
        }
        problem.settings = settings;
        return problem;
    }

    /// The same in a mirror across one axis.
    [[nodiscard]] Block mirrored(std::size_t axis) const {
        Block image = *this;
        std::ranges::reverse(image.edge[axis]);
        for (double& x : image.edge[axis]) {
            x = edge[axis].back() - x;
        }
        std::swap(image.film[2 * axis], image.film[2 * axis + 1]);
        std::swap(image.radiates[2 * axis], image.radiates[2 * axis + 1]);
        for (int cell = 0; cell < cells(); ++cell) {
            const auto there = static_cast<std::size_t>(opposite(axis, cell));
            image.layer[there] = layer[static_cast<std::size_t>(cell)];
            image.initial[there] = initial[static_cast<std::size_t>(cell)];
        }
        return image;
    }
    /// The cell that stands in the mirror where this one is.
    [[nodiscard]] int opposite(std::size_t axis, int cell) const {
        std::array<int, 3> index{cell % size(0), cell / size(0) % size(1), cell / (size(0) * size(1))};
        index[axis] = size(axis) - 1 - index[axis];
        return index[0] + size(0) * (index[1] + size(1) * index[2]);
    }
};

inline physics::Curve random_law(Dice& dice, double at_20_degC, const Ground& ground) {
    if (ground.linear || dice.chance(0.4)) {
        return physics::Curve::constant(at_20_degC);
    }
    if (dice.chance(0.5)) {  // a fifth to five times at the other end
        return physics::Curve::table(
            {coldest_kelvin, 293.15, hottest_kelvin},
            {at_20_degC * dice.decades(0.2, 5.0), at_20_degC, at_20_degC * dice.decades(0.2, 5.0)});
    }
    return physics::Curve::quadratic_about(293.15, at_20_degC, at_20_degC * dice.between(-1e-3, 3e-3),
                                           at_20_degC * dice.between(0.0, 1e-5));
}

inline physics::Material random_material(Dice& dice, const Ground& ground) {
    const double c = dice.decades(300.0, 4000.0);
    const double k = dice.decades(1e-3, 1e3);
    physics::Material material{
        .name = "drawn", .density = dice.decades(20.0, 8000.0), .heat_capacity = {}, .conductivity = {}};
    for (physics::Curve& along : material.conductivity) {
        along = random_law(dice, k * (dice.chance(0.5) ? 1.0 : dice.decades(0.1, 10.0)), ground);
    }
    material.heat_capacity =
        ground.linear || dice.chance(0.6)
            ? random_law(dice, c, ground)
            : melting(c, dice.between(250.0, 500.0), dice.decades(0.05, 20.0), dice.decades(1e3, 3e5));
    return material;
}

inline std::vector<double> random_edges(Dice& dice, int cells) {
    const double mean = dice.decades(5e-5, 5e-3);
    const double spread = dice.decades(1.0, 100.0);
    std::vector<double> edge{0.0};
    for (int i = 0; i < cells; ++i) {
        edge.push_back(edge.back() + mean * dice.decades(1.0, spread));
    }
    return edge;
}

/// Inputs and steps of the run: from 1e-6 s to a day, or the steady state.
inline void draw_time(Dice& dice, const Ground& ground, Block& block) {
    solver::Settings& settings = block.settings;
    settings.end = dice.decades(1e-6, 1e5);
    settings.tolerance = dice.decades(ground.least_tolerance, 0.1);
    settings.method = dice.chance(0.3) ? solver::Method::backward_euler : solver::Method::tr_bdf2;
    settings.steady = dice.chance(0.15);
    const int steps = dice.whole(1, 20);
    if (dice.chance(0.4)) {
        settings.fixed_step = settings.end / steps;
    }
    settings.output_interval = settings.end;
    settings.linear_solver =
        dice.chance(0.2) ? solver::LinearSolver::conjugate_gradient : solver::LinearSolver::automatic;
    block.air_time = {0.0};
    block.air = {dice.between(coldest_kelvin, hottest_kelvin)};
    if (dice.chance(0.5)) {
        return;
    }
    block.logged = ground.logs && dice.chance(0.5);
    const int points = dice.whole(2, 12);
    for (int i = 1; i <= points; ++i) {
        const double t = settings.end * i / points;
        if (!block.logged) {  // a jump: two points at one time
            block.air_time.push_back(t);
            block.air.push_back(block.air.back());
        }
        block.air_time.push_back(t);
        block.air.push_back(dice.between(coldest_kelvin, hottest_kelvin));
    }
}

inline Block random_block(Dice& dice, const Ground& ground) {
    Block block;
    const int cells = static_cast<int>(dice.decades(1.0, ground.most_cells));
    const int dimensions = dice.whole(1, 3);
    const int across = static_cast<int>(std::pow(cells, 1.0 / dimensions) + 1e-9);
    const int left = cells / (dimensions == 1 ? 1 : dimensions == 2 ? across : across * across);
    block.edge[0] = random_edges(dice, dimensions > 1 ? across : 1);
    block.edge[1] = random_edges(dice, dimensions > 2 ? across : 1);
    block.edge[2] = random_edges(dice, std::max(1, left));
    const int materials = dice.whole(1, 4);
    for (int i = 0; i < materials; ++i) {
        block.materials.push_back(random_material(dice, ground));
    }
    const bool even = dice.chance(0.5);
    const double start = dice.between(coldest_kelvin, hottest_kelvin);
    for (int i = 0; i < block.cells(); ++i) {
        block.layer.push_back(dice.whole(0, materials - 1));
        block.initial.push_back(even ? start : dice.between(coldest_kelvin, hottest_kelvin));
    }
    for (std::size_t side = 0; side < 6; ++side) {
        block.film[side] = dice.chance(0.6) ? dice.decades(0.1, 1e5) : 0.0;
        block.radiates[side] = !ground.linear && dice.chance(0.3);
    }
    block.film[4] = std::max(block.film[4], 1.0);  // a steady state must exist
    if (ground.sources) {                          // up to 30 K above the air, were the heat spread over all
        const double volume = block.edge[0].back() * block.edge[1].back() * block.edge[2].back();
        block.power_density =
            block.film[4] * block.edge[0].back() * block.edge[1].back() / volume * dice.between(0.0, 30.0);
    }
    draw_time(dice, ground, block);
    return block;
}

}  // namespace tiretherm::support
