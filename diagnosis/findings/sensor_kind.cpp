// SPDX-License-Identifier: BSD-3-Clause
// Finds the kind of a sensor from the nodes that its channel reads and the quantity that it gives.
#include "diagnosis/findings/sensor_kind.hpp"

#include <algorithm>

namespace tiretherm::diagnosis {

namespace {

using physics::SensorKind;

bool is_on_outer_surface(const mesh::Mesh& mesh, int node) {
    return std::ranges::any_of(mesh.patches, [&](const mesh::Patch& patch) {
        return patch.name != "inside" &&
               std::ranges::any_of(patch.faces, [&](const mesh::PatchFace& face) { return face.node == node; });
    });
}

/// Whether all nodes that a channel reads with some weight are of this kind.
template <typename IsOfKind>
bool reads_only(const mesh::Functional& where, IsOfKind is_of_kind) {
    bool reads_any = false;
    for (std::size_t i = 0; i < where.nodes.size(); ++i) {
        if (where.weights[i] != 0.0) {
            if (!is_of_kind(where.nodes[i])) {
                return false;
            }
            reads_any = true;
        }
    }
    return reads_any;
}

}  // namespace

SensorKind sensor_kind(const solver::Problem& problem, std::size_t channel) {
    const solver::Channel& read = problem.channels[channel];
    if (problem.camera_of(static_cast<int>(channel)) != nullptr) {
        return SensorKind::infrared;
    }
    switch (read.quantity) {
        case solver::Quantity::surface_at_entry:
        case solver::Quantity::surface_at_exit:
            return SensorKind::infrared;
        case solver::Quantity::gas_pressure:
            return SensorKind::gas;
        case solver::Quantity::temperature:
            break;
        default:
            return SensorKind::any;
    }
    const mesh::Mesh& mesh = problem.mesh;
    const auto is_gas = [&](int node) {
        return std::ranges::any_of(mesh.lumped_nodes, [&](const mesh::LumpedNode& lumped) {
            return lumped.node == node && lumped.name == "gas";
        });
    };
    if (reads_only(read.where, is_gas)) {
        return SensorKind::gas;
    }
    return reads_only(read.where, [&](int node) { return is_on_outer_surface(mesh, node); }) ? SensorKind::infrared
                                                                                             : SensorKind::probe;
}

SensorKind sensor_kind(const solver::Problem& problem, const solver::FreeParameter& parameter) {
    if (parameter.kind != solver::FreeParameter::Kind::effect) {
        return SensorKind::any;
    }
    const physics::ActiveEffect& active = problem.effects[parameter.effect];
    if (active.effect->sensor_model() == nullptr) {
        return SensorKind::any;
    }
    if (!parameter.everywhere && parameter.scope == physics::Scope::channel && parameter.place >= 0) {
        return sensor_kind(problem, static_cast<std::size_t>(parameter.place));
    }
    SensorKind common = SensorKind::any;
    for (const int channel : active.channels) {
        const SensorKind one = sensor_kind(problem, static_cast<std::size_t>(channel));
        if (common != SensorKind::any && one != common) {
            return SensorKind::any;
        }
        common = one;
    }
    return common;
}

}  // namespace tiretherm::diagnosis
