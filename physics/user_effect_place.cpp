// SPDX-License-Identifier: BSD-3-Clause
// Finds nodes by the name of a region, layer, zone or patch. Cells share by heat capacity at 60 degC, surface nodes by
// area.

#include "physics/user_effect_place.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "mesh/index.hpp"
#include "physics/spread.hpp"

namespace tiretherm::physics {

namespace {

/// Where heat capacities are compared: rubber's c(T) of 60 degC. K
constexpr double usual_temperature = 333.15;

/// Area of the boundary that belongs to a node. @returns m2, 0 of a node inside
double area_of(const mesh::Mesh& mesh, int node) {
    for (const mesh::Patch& patch : mesh.patches) {
        for (const mesh::PatchFace& face : patch.faces) {
            if (face.node == node) {
                return face.area;
            }
        }
    }
    return 0.0;
}

std::vector<int> cells_in(const mesh::Mesh& mesh, const std::vector<int>& part_of, int part) {
    std::vector<int> cells;
    for (int cell = 0; part >= 0 && cell < mesh.n_cells; ++cell) {
        if (part_of[at(cell)] == part) {
            cells.push_back(cell);
        }
    }
    return cells;
}

}  // namespace

bool is_user_effect(const Effect& effect) { return effect.id == "own_source" || effect.id == "own_exchange"; }

std::vector<int> nodes_of_place(const mesh::Mesh& mesh, std::string_view name) {
    if (const int region = mesh.find_region(name); region >= 0) {
        return mesh.regions[at(region)].mean.nodes;
    }
    if (const int layer = mesh.find_layer(name); layer >= 0) {
        return cells_in(mesh, mesh.layer, layer);
    }
    if (const int zone = mesh.find_zone(name); zone >= 0) {
        return cells_in(mesh, mesh.zone, zone);
    }
    std::vector<int> nodes;
    if (const int patch = mesh.find_patch(name); patch >= 0) {
        for (const mesh::PatchFace& face : mesh.patches[at(patch)].faces) {
            nodes.push_back(face.node);
        }
    }
    return nodes;
}

std::vector<std::string> names_of_places(const mesh::Mesh& mesh) {
    std::vector<std::string> names;
    const auto add = [&](const std::string& name) {
        if (std::ranges::find(names, name) == names.end()) {
            names.push_back(name);
        }
    };
    for (const mesh::Region& region : mesh.regions) {
        add(region.name);
    }
    std::ranges::for_each(mesh.layers, add);
    std::ranges::for_each(mesh.zones, add);
    for (const mesh::Patch& patch : mesh.patches) {
        add(patch.name);
    }
    return names;
}

std::vector<double> shares_of_nodes(const mesh::Mesh& mesh, std::span<const Material> materials,
                                    std::span<const int> nodes) {
    std::vector<double> by_capacity;
    std::vector<double> by_area;
    for (const int node : nodes) {
        if (node < mesh.n_cells) {
            const Material& material = materials[at(mesh.layer[at(node)])];
            by_capacity.push_back(mesh.volume[at(node)] * material.density *
                                  material.heat_capacity.value(usual_temperature));
        } else if (const double area = area_of(mesh, node); area > 0.0) {
            by_area.push_back(area);
        }
    }
    if (nodes.size() == 1) {
        return {1.0};
    }
    if (by_capacity.size() == nodes.size()) {
        return by_capacity;
    }
    return by_area.size() == nodes.size() ? by_area : std::vector<double>{};
}

void place_user_effect(const PlacementContext& context, ActiveEffect& active) {
    active.weights = shares_of_nodes(context.mesh, context.material_model.materials, active.nodes);
    if (active.weights.empty()) {
        active.nodes.clear();  // the case has been refused
        return;
    }
    normalise(active);
}

std::string user_effect_invalid_on_mesh(const ActiveEffect& active, const mesh::Mesh& /*mesh*/) {
    if (!active.tables.front() || active.nodes.empty()) {
        return fmt::format("{} needs a signal to follow and a place: it is written as a table of its own, [[{}]]",
                           active.effect->id, active.effect->id.substr(4));
    }
    return {};
}

}  // namespace tiretherm::physics
