// SPDX-License-Identifier: BSD-3-Clause
// Reads [mesh] by its kind; the kinds "two_node" (surface and bulk of the crown), "layers" (one column through the
// thickness) and "cylinder" (layers about an axis) are here.

#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "input/model/law.hpp"
#include "input/model/mesh.hpp"
#include "input/text/quantity_specs.hpp"
#include "input/text/word_lists.hpp"

namespace tiretherm::input {

namespace {

struct MeshKind {
    std::string_view name;
    bool (*read)(TomlTable& mesh, const MeshSource& from, MeshTable& into);
};

constexpr std::array mesh_kinds{MeshKind{"two_node", read_two_node}, MeshKind{"layers", read_layers},
                                MeshKind{"cylinder", read_cylinder}, MeshKind{"section", read_section},
                                MeshKind{"block", read_block},       MeshKind{"axisymmetric", read_axisymmetric}};

}  // namespace

MeshTable read_mesh(TomlTable& root, const MeshSource& from) {
    TomlTable mesh = root.subtable("mesh");
    MeshTable read;
    std::array<std::string_view, mesh_kinds.size()> names;
    std::transform(mesh_kinds.begin(), mesh_kinds.end(), names.begin(), [](const MeshKind& kind) { return kind.name; });
    const std::optional<std::size_t> kind = mesh.choice("kind", names);
    if (!kind) {
        mesh.allow_unknown_keys();
        return read;
    }
    const std::size_t before = mesh.errors().count();
    if (!mesh_kinds[*kind].read(mesh, from, read) || mesh.errors().count() > before) {
        // With an error in any key, names of layers and patches may be wrong: readers of later tables then ask for none.
        read.mesh = {};
    }
    return read;
}

bool read_two_node(TomlTable& mesh, const MeshSource& from, MeshTable& into) {
    const double surface_share = mesh.quantity("surface_mass_share").value_or(0.5);
    const double bulk_depth = mesh.quantity("bulk_depth").value_or(0.01);
    const Stock* stock = read_material(mesh, "material", from.stock);
    const std::optional<physics::Curve> link =
        read_law(mesh, "link_conductivity", quantity_specs::conductivity, Need::optional);
    if (!from.tire.given) {
        mesh.add_error("kind", "two_node lumps the crown of a tire, and there is no tire",
                       "add [tire] with size = \"225/50 R17\"");
    }
    if (stock == nullptr || !from.tire.given) {
        return false;
    }
    const physics::Material& material = stock->material;
    physics::Tire& tire = from.tire.tire;
    // The law of the loss takes the mass of the crown from the density of [tire], the cells from that of their material: they
    // must be one.
    if (from.tire.has_density && std::abs(tire.density / material.density - 1.0) > 1e-9) {
        mesh.add_error("material",
                       fmt::format("{} has {} kg/m3, but [tire] density is {} kg/m3", material.name, material.density,
                                   tire.density),
                       "leave density out of [tire]: here it is the material's");
        return false;
    }
    tire.density = material.density;
    const double volume = tire.band_mass() / tire.density;
    into.mesh = build(mesh::TwoNode{.area = tire.outer_area(),
                                    .surface_volume = volume * surface_share,
                                    .bulk_volume = volume * (1.0 - surface_share),
                                    .bulk_depth = bulk_depth});
    into.materials = {material, material};
    into.link_laws = {link.value_or(material.along(mesh::Axis::through))};
    return true;
}

bool read_layers(TomlTable& mesh, const MeshSource& from, MeshTable& into) {
    mesh::Layers layers;
    const bool needs_area = !from.tire.given;
    layers.area =
        mesh.quantity("area", needs_area ? Need::required : Need::optional).value_or(from.tire.tire.outer_area());
    layers.stack = read_stack(mesh, from, into);
    const std::optional<std::string> below = mesh.text("link_below");
    const Need with_link = below ? Need::required : Need::optional;
    layers.link_length = mesh.quantity("link_length", with_link).value_or(0.0);
    const std::optional<physics::Curve> law =
        read_law(mesh, "link_conductivity", quantity_specs::conductivity, with_link);
    if (!below && (mesh.has("link_length") || mesh.has("link_conductivity"))) {
        mesh.add_error(mesh.has("link_length") ? "link_length" : "link_conductivity", "there is no link",
                       "say where it is: link_below = \"name of a layer\"");
    }
    if (below) {
        const std::vector<std::string> names = names_of(layers.stack);
        const auto found =
            find_name({*below, mesh.place("link_below")}, names, "there is no layer", "layers", mesh.errors());
        if (!found) {
            return false;
        }
        if (*found + 1 == names.size()) {
            mesh.add_error("link_below",
                           fmt::format("\"{}\" is the innermost layer: nothing lies below the link", *below),
                           "name a layer further out");
            return false;
        }
        layers.link_below = static_cast<int>(*found);
    }
    if (layers.stack.empty() || (below && !law)) {
        return false;
    }
    if (law) {
        into.link_laws = {*law};
    }
    into.mesh = build(layers);
    return true;
}

/// Layers with their true radii; with a tire its radius and its outer area are the standard ones.
bool read_cylinder(TomlTable& mesh, const MeshSource& from, MeshTable& into) {
    const Need need = from.tire.given ? Need::optional : Need::required;
    const std::optional<double> inner_radius = mesh.quantity("inner_radius", need);
    const std::optional<double> length = mesh.quantity("length", need);
    mesh::Cylinder cylinder;
    cylinder.stack = read_stack(mesh, from, into);
    if (cylinder.stack.empty() || (!from.tire.given && (!inner_radius || !length))) {
        return false;
    }
    double thickness = 0.0;
    for (const mesh::Layer& layer : cylinder.stack) {
        thickness += layer.thickness;
    }
    const physics::Tire& tire = from.tire.tire;
    cylinder.inner_radius = inner_radius.value_or(tire.unloaded_radius - thickness);
    if (!(cylinder.inner_radius > 0.0)) {
        mesh.add_error("layer",
                       fmt::format("the layers are {:.6g} mm thick, and the tire's radius is {:.6g} mm",
                                   thickness * 1e3, tire.unloaded_radius * 1e3),
                       "take thinner layers");
        return false;
    }
    cylinder.length =
        length.value_or(tire.outer_area() / (2.0 * std::numbers::pi * (cylinder.inner_radius + thickness)));
    into.mesh = build(cylinder);
    return true;
}

}  // namespace tiretherm::input
