// SPDX-License-Identifier: BSD-3-Clause
// Reads [mesh] kind = "block" and "axisymmetric" (specimens), and the list [[mesh.layer]] that all layered kinds share.

#include <cmath>

#include <fmt/format.h>

#include "input/model/mesh.hpp"
#include "input/text/quantity_specs.hpp"

namespace tiretherm::input {

namespace {

/// Neighbours that differ much in size cost accuracy.
void check_growth(const TomlTable& table, int cells, double total_ratio) {
    const double step = cells > 1 ? std::pow(std::max(total_ratio, 1.0 / total_ratio), 1.0 / (cells - 1)) : 1.0;
    if (step > 2.0) {
        table.errors().warn(table.place("ratio"),
                            "neighbouring cells differ by a factor of {:.3g}; accuracy suffers above about 1.5", step);
    }
}

/// The list x, y or radius. @param centred its first cell starts at minus the last `to`
std::vector<mesh::Segment> read_segments(TomlTable& mesh, std::string_view key, bool centred) {
    std::vector<mesh::Segment> segments;
    std::vector<SourceLocation> places;
    mesh.each(
        key,
        [&](TomlTable& table) {
            mesh::Segment segment;
            segment.to = std::nan("");
            table.read_into(segment);
            check_growth(table, segment.cells, segment.ratio);
            segments.push_back(segment);
            places.push_back(table.place("to"));
        },
        Need::required, fmt::format("{} = [{{ to = \"30 mm\", cells = 8 }}]", key));
    double before = segments.empty() || !centred ? 0.0 : -segments.back().to;
    for (std::size_t i = 0; i < segments.size(); ++i) {
        if (segments[i].to <= before) {
            mesh.errors().add(
                places[i], fmt::format("{} goes from {:.6g} mm to {:.6g} mm", key, before * 1e3, segments[i].to * 1e3),
                "let `to` ascend from segment to segment");
            return {};
        }
        before = segments[i].to;
    }
    return segments;
}

/// Of segments or layers.
double cells(const auto& parts) {
    double sum = 0.0;
    for (const auto& part : parts) {
        sum += part.cells;
    }
    return sum;
}

}  // namespace

std::vector<mesh::Layer> read_stack(TomlTable& mesh, const MeshSource& from, MeshTable& into,
                                    std::vector<std::vector<LocatedString>>* zones) {
    std::vector<mesh::Layer> stack;
    bool complete = true;
    mesh.each(
        "layer",
        [&](TomlTable& table) {
            mesh::Layer layer;
            layer.thickness = 0.001;  // where the key is wrong: what follows from it stays sound
            table.read_into(layer);
            check_growth(table, layer.cells, layer.ratio);
            if (zones != nullptr) {
                zones->push_back(table.texts("zones"));
            }
            const Stock* stock = read_material(table, "material", from.stock);
            complete = complete && stock != nullptr;
            if (stock != nullptr && stock->ply && table.has("thickness")) {
                check_thickness(*stock->ply, layer.thickness, table);
            }
            into.materials.push_back(stock != nullptr ? stock->material : physics::Material{});
            for (const mesh::Layer& other : stack) {
                if (other.name == layer.name && !layer.name.empty()) {
                    table.add_error("name", fmt::format("a second layer is called \"{}\"", layer.name), "rename one");
                }
            }
            stack.push_back(std::move(layer));
        },
        Need::required);
    return complete && is_affordable(mesh, cells(stack), from.limits) ? stack : std::vector<mesh::Layer>{};
}

bool read_block(TomlTable& mesh, const MeshSource& from, MeshTable& into) {
    mesh::Block block;
    mesh.read_into(block);
    block.x = read_segments(mesh, "x", !block.quarter);
    block.y = read_segments(mesh, "y", !block.quarter);
    block.stack = read_stack(mesh, from, into);
    if (block.x.empty() || block.y.empty() || block.stack.empty() ||
        !is_affordable(mesh, cells(block.x) * cells(block.y) * cells(block.stack), from.limits)) {
        return false;
    }
    into.symmetry = block.quarter ? 4.0 : 1.0;
    into.mesh = build(block);
    return true;
}

bool read_axisymmetric(TomlTable& mesh, const MeshSource& from, MeshTable& into) {
    mesh::Axisymmetric disc;
    mesh.read_into(disc);
    disc.radius = read_segments(mesh, "radius", false);
    disc.stack = read_stack(mesh, from, into);
    if (disc.radius.empty() || disc.stack.empty() ||
        !is_affordable(mesh, cells(disc.radius) * cells(disc.stack), from.limits)) {
        return false;
    }
    into.mesh = build(disc);
    return true;
}

}  // namespace tiretherm::input
