// SPDX-License-Identifier: BSD-3-Clause
// Adds cells, patches, surface nodes and lumped nodes, finds parts by name, and checks the graph for defects.

#include "mesh/mesh.hpp"

#include <algorithm>
#include <functional>
#include <numeric>

#include <fmt/format.h>

#include "mesh/index.hpp"
#include "mesh/parallel.hpp"

namespace tiretherm::mesh {

namespace {

template <typename Items>
int find_named(const Items& items, std::string_view name) {
    const auto found = std::find_if(items.begin(), items.end(), [&](const auto& item) { return item.name == name; });
    return found == items.end() ? -1 : static_cast<int>(found - items.begin());
}

int find_word(const std::vector<std::string>& words, std::string_view word) {
    const auto found = std::find(words.begin(), words.end(), word);
    return found == words.end() ? -1 : static_cast<int>(found - words.begin());
}

}  // namespace

void Functional::add(int node, double weight) {
    if (const auto found = std::find(nodes.begin(), nodes.end(), node); found != nodes.end()) {
        weights[static_cast<std::size_t>(found - nodes.begin())] += weight;
        return;
    }
    nodes.push_back(node);
    weights.push_back(weight);
}

void Functional::normalise() {
    const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
    for (double& weight : weights) {
        weight /= sum;
    }
}

double Functional::operator()(std::span<const double> temperature) const {
    const auto add = [&](double sum, std::size_t i) { return sum + weights[i] * temperature[at(nodes[i])]; };
    return sum_over_ranges(nodes.size(), [&](std::size_t begin, std::size_t end) {
        return fold_side_by_side(begin, end, 0.0, add, std::plus<>());
    });
}

double Patch::area() const {
    return std::accumulate(faces.begin(), faces.end(), 0.0,
                           [](double sum, const PatchFace& face) { return sum + face.area; });
}

int Mesh::add_cell(double cell_volume, const Point& place, int cell_layer, int cell_zone) {
    volume.push_back(cell_volume);
    centre.push_back(place);
    layer.push_back(cell_layer);
    zone.push_back(cell_zone);
    ++n_cells;
    return n_nodes++;
}

int Mesh::add_patch(std::string_view name) {
    patches.push_back({.name = std::string(name), .faces = {}});
    return static_cast<int>(patches.size()) - 1;
}

int Mesh::add_patch_face(int patch, int cell, double area, double half_distance, const Point& place, Axis axis) {
    int node = cell;
    if (half_distance > 0.0) {
        node = n_nodes++;
        volume.push_back(0.0);
        centre.push_back(place);
        layer.push_back(layer[static_cast<std::size_t>(cell)]);
        zone.push_back(zone[static_cast<std::size_t>(cell)]);
        faces.push_back({.a = cell, .b = node, .area = area, .half_a = half_distance, .half_b = 0.0, .axis = axis});
    }
    patches[static_cast<std::size_t>(patch)].faces.push_back(
        {.node = node, .cell = cell, .area = area, .centre = place, .extent = {}});
    return node;
}

int Mesh::add_lumped_node(std::string_view name) {
    if (const int there = find_lumped_node(name); there >= 0) {
        return there;
    }
    volume.push_back(0.0);
    centre.push_back({});
    layer.push_back(-1);
    zone.push_back(-1);
    lumped_nodes.push_back({.name = std::string(name), .node = n_nodes});
    regions.push_back({.name = std::string(name), .mean = {{n_nodes}, {1.0}}});
    return n_nodes++;
}

int Mesh::add_coupling_face(int node, int lumped_node, double area) {
    faces.push_back({.a = node, .b = lumped_node, .area = area, .is_coupling = true});
    return static_cast<int>(faces.size()) - 1;
}

int Mesh::find_patch(std::string_view name) const { return find_named(patches, name); }
int Mesh::find_region(std::string_view name) const { return find_named(regions, name); }
int Mesh::find_zone(std::string_view name) const { return find_word(zones, name); }
int Mesh::find_layer(std::string_view name) const { return find_word(layers, name); }

int Mesh::find_lumped_node(std::string_view name) const {
    const int index = find_named(lumped_nodes, name);
    return index < 0 ? -1 : lumped_nodes[static_cast<std::size_t>(index)].node;
}

double Mesh::total_volume() const { return std::accumulate(volume.begin(), volume.begin() + n_cells, 0.0); }

std::vector<std::string> defects(const Mesh& mesh) {
    std::vector<std::string> found;
    for (int cell = 0; cell < mesh.n_cells; ++cell) {
        if (const double v = mesh.volume[static_cast<std::size_t>(cell)]; !(v > 0.0)) {
            found.push_back(fmt::format("cell {} has volume {} m3", cell, v));
        }
    }
    std::vector<bool> joined(static_cast<std::size_t>(mesh.n_nodes), mesh.n_nodes == 1);
    for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
        const Face& face = mesh.faces[i];
        if (face.a == face.b) {
            found.push_back(fmt::format("face {} joins node {} to itself", i, face.a));
        }
        if (!(face.area > 0.0) || face.half_a < 0.0 || face.half_b < 0.0) {
            found.push_back(fmt::format("face {} has area {} m2 and half distances {} and {} m", i, face.area,
                                        face.half_a, face.half_b));
        }
        if (face.half_a + face.half_b == 0.0 && face.link < 0 && !face.is_coupling) {
            found.push_back(fmt::format("face {} joins two lumps without a link: infinite conductance", i));
        }
        joined[static_cast<std::size_t>(face.a)] = true;
        joined[static_cast<std::size_t>(face.b)] = true;
    }
    for (int node = 0; node < mesh.n_nodes; ++node) {
        if (!joined[static_cast<std::size_t>(node)]) {
            found.push_back(fmt::format("node {} is joined to no other", node));
        }
    }
    return found;
}

}  // namespace tiretherm::mesh
