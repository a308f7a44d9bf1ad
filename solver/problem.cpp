// SPDX-License-Identifier: BSD-3-Clause
// Switches effects on together with their lumped nodes, and checks everything that a run needs.

#include "solver/problem.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace tiretherm::solver {

const CameraChannels* Problem::camera_of(int channel) const {
    const auto found =
        std::ranges::find_if(cameras, [&](const CameraChannels& camera) { return camera.contains(channel); });
    return found == cameras.end() ? nullptr : &*found;
}

std::size_t switch_on(Problem& problem, physics::ActiveEffect active, double start) {
    if (const physics::HeatEffect* heat = active.effect->heat_effect(); heat != nullptr && heat->extend != nullptr) {
        heat->extend(problem.mesh, active);
        if (!problem.initial.empty()) {
            problem.initial.resize(static_cast<std::size_t>(problem.mesh.n_nodes), start);
        }
    }
    problem.effects.push_back(std::move(active));
    return problem.effects.size() - 1;
}

std::vector<std::string> defects(const Problem& problem) {
    std::vector<std::string> found = mesh::defects(problem.mesh);
    const auto expect = [&](bool holds, std::string_view sentence) {
        if (!holds) {
            found.emplace_back(sentence);
        }
    };
    const auto n = static_cast<std::size_t>(problem.mesh.n_nodes);
    expect(problem.materials.size() == problem.mesh.layers.size(), "every layer of the mesh needs a material");
    expect(problem.link_laws.size() == problem.mesh.links.size(), "every link of the mesh needs a conductivity");
    expect(problem.initial.size() == n, "every node needs an initial temperature");
    expect(problem.settings.steady || problem.settings.end > problem.settings.start,
           "the run must end after it starts");
    expect(problem.settings.tolerance > 0.0, "the tolerance of a step must be positive");
    expect(!problem.settings.fixed_step || *problem.settings.fixed_step > 0.0, "a fixed step must be positive");
    expect(!problem.settings.largest_step || *problem.settings.largest_step > 0.0, "the largest step must be positive");
    for (const double T : problem.initial) {
        if (!(T > 0.0) || !std::isfinite(T)) {
            found.push_back(fmt::format("an initial temperature is {} K", T));
            break;
        }
    }
    return found;
}

}  // namespace tiretherm::solver
