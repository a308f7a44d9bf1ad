// SPDX-License-Identifier: BSD-3-Clause
// Weights by area, by mass and by a profile along the meridian, normalised to 1; coupling faces between patches and
// lumped nodes such as gas and rim.

#include "physics/spread.hpp"

#include <algorithm>
#include <numeric>

namespace tiretherm::physics {

namespace {

/// Middle of a zone along the meridian. @returns m; nothing when the mesh has no such zone
std::optional<double> middle_of(const mesh::Mesh& mesh, std::string_view name) {
    const int zone = mesh.find_zone(name);
    double low = 0.0;
    double high = 0.0;
    bool found = false;
    for (const mesh::Column& column : mesh.columns) {
        if (column.zone == zone) {
            low = found ? std::min(low, column.from) : column.from;
            high = found ? std::max(high, column.to) : column.to;
            found = true;
        }
    }
    return found ? std::optional(0.5 * (low + high)) : std::nullopt;
}

}  // namespace

double along_meridian(const mesh::Mesh& mesh, int node) {
    return mesh.is_section() ? mesh.centre[static_cast<std::size_t>(node)][0] : 0.0;
}

double towards_outside(const mesh::Mesh& mesh, int node) {
    const std::optional<double> outside = middle_of(mesh, "outside_shoulder");
    const std::optional<double> inside = middle_of(mesh, "inside_shoulder");
    if (!outside || !inside) {
        return 0.0;
    }
    const double half = 0.5 * (*inside - *outside);
    const double centre = 0.5 * (*inside + *outside);
    return std::clamp((centre - along_meridian(mesh, node)) / half, -1.0, 1.0);
}

double half_tread(const mesh::Mesh& mesh) {
    double reach = 0.0;
    for (const mesh::PatchFace& face : mesh.patches[static_cast<std::size_t>(mesh.find_patch("outside"))].faces) {
        reach = std::max({reach, std::abs(face.extent[0]), std::abs(face.extent[1])});
    }
    return reach;
}

void normalise(ActiveEffect& active) {
    const double total = std::accumulate(active.weights.begin(), active.weights.end(), 0.0);
    for (double& weight : active.weights) {
        weight /= total;
    }
}

void exchange_by_weights(const EvaluationState& state, Terms& terms) {
    const double G = state.coefficients[0];
    if (G <= 0.0) {
        return;
    }
    const double T_around = state.coefficients[1] / G;
    for (std::size_t i = 0; i < state.active.nodes.size(); ++i) {
        terms.exchange(state.active.nodes[i], G * state.active.weights[i], T_around);
    }
}

void spread_over_patches(const PlacementContext& context, ActiveEffect& active, const std::optional<Curve>& profile) {
    if (active.field) {
        active.nodes = active.field->nodes;
        active.weights = active.field->weights.front();
        return;
    }
    active.nodes.clear();
    active.weights.clear();
    for (const int patch : active.patches) {
        for (const mesh::PatchFace& face : context.mesh.patches[static_cast<std::size_t>(patch)].faces) {
            double weight = face.area;
            if (profile && context.mesh.is_section()) {
                weight *= profile->value(along_meridian(context.mesh, face.cell));
            }
            active.nodes.push_back(face.node);
            active.weights.push_back(weight);
        }
    }
    normalise(active);
}

void spread_over_bulk(const PlacementContext& context, ActiveEffect& active) {
    active.nodes.clear();
    active.weights.clear();
    const mesh::Functional& bulk =
        context.mesh.regions[static_cast<std::size_t>(context.mesh.find_region("bulk"))].mean;
    for (const int cell : bulk.nodes) {
        const auto c = static_cast<std::size_t>(cell);
        const auto layer = static_cast<std::size_t>(context.mesh.layer[c]);
        active.nodes.push_back(cell);
        active.weights.push_back(context.mesh.volume[c] * context.material_model.materials[layer].density);
    }
    normalise(active);
}

std::vector<int> couple_patches(mesh::Mesh& mesh, const ActiveEffect& active, int lumped_node) {
    std::vector<int> coupling_faces;
    for (const int patch : active.patches) {
        for (const mesh::PatchFace& face : mesh.patches[static_cast<std::size_t>(patch)].faces) {
            coupling_faces.push_back(mesh.add_coupling_face(face.node, lumped_node, face.area));
        }
    }
    return coupling_faces;
}

double coupling_area(const mesh::Mesh& mesh, const ActiveEffect& active) {
    return std::accumulate(active.coupling_faces.begin(), active.coupling_faces.end(), 0.0,
                           [&](double sum, int face) { return sum + mesh.faces[static_cast<std::size_t>(face)].area; });
}

void couple_gas_and_rim(mesh::Mesh& mesh) {
    const int gas = mesh.find_lumped_node("gas");
    const int rim = mesh.find_lumped_node("rim");
    if (gas >= 0 && rim >= 0 && face_between_gas_and_rim(mesh) < 0) {
        mesh.add_coupling_face(rim, gas, 1.0);
    }
}

int face_between_gas_and_rim(const mesh::Mesh& mesh) {
    const int gas = mesh.find_lumped_node("gas");
    const int rim = mesh.find_lumped_node("rim");
    const auto found = std::find_if(mesh.faces.begin(), mesh.faces.end(), [&](const mesh::Face& face) {
        return gas >= 0 && rim >= 0 && face.a == rim && face.b == gas;
    });
    return found == mesh.faces.end() ? -1 : static_cast<int>(found - mesh.faces.begin());
}

}  // namespace tiretherm::physics
