// SPDX-License-Identifier: BSD-3-Clause
// Finds the kind of a sensor from the nodes that its channel reads and the quantity that it gives.
#include "diagnosis/findings/sensor_kind.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "input/text/column_names.hpp"

namespace tiretherm::diagnosis {

namespace {

using physics::SensorKind;

/// Whether a node is on one of these patches.
bool is_on(const mesh::Mesh& mesh, int node, bool (*is_meant)(std::string_view patch)) {
    return std::ranges::any_of(mesh.patches, [&](const mesh::Patch& patch) {
        return is_meant(patch.name) &&
               std::ranges::any_of(patch.faces, [&](const mesh::PatchFace& face) { return face.node == node; });
    });
}

/// Of a tire and of a specimen: what a camera looks at.
bool is_seen(std::string_view patch) {
    constexpr std::array<std::string_view, 4> seen{"outside", "sidewalls", "beads", "top"};
    return std::ranges::find(seen, patch) != seen.end();
}

/// The back and the sides of a specimen, which a camera may see or a thermocouple touch.
bool is_seen_or_touched(std::string_view patch) { return patch != "inside"; }

/// What the name or the description of a sensor says of its kind; any: nothing.
SensorKind kind_by_words(const solver::Channel& channel) {
    constexpr std::array<std::string_view, 6> touching{"thermocouple", "tc", "probe", "needle", "pt100", "wire"};
    constexpr std::array<std::string_view, 5> seeing{"ir", "infrared", "camera", "pyrometer", "thermography"};
    for (const std::string_view text : {std::string_view(channel.name), std::string_view(channel.meaning)}) {
        for (const std::string& word : input::words_of(text)) {
            if (std::ranges::find(touching, word) != touching.end()) {
                return SensorKind::probe;
            }
            if (std::ranges::find(seeing, word) != seeing.end()) {
                return SensorKind::infrared;
            }
        }
    }
    return SensorKind::any;
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
    const auto is_all_on = [&](bool (*is_meant)(std::string_view)) {
        return reads_only(read.where, [&](int node) { return is_on(mesh, node, is_meant); });
    };
    if (!is_all_on(is_seen_or_touched)) {
        return SensorKind::probe;
    }
    if (const SensorKind named = kind_by_words(read); named != SensorKind::any) {
        return named;
    }
    return is_all_on(is_seen) ? SensorKind::infrared : SensorKind::any;
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
