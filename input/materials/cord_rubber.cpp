// SPDX-License-Identifier: BSD-3-Clause
// Reads [material.cord_rubber], applies the mixing rules, and checks that cords fit and that the mesh can show them.

#include "input/materials/cord_rubber.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "input/text/quantity_specs.hpp"

namespace tiretherm::input {

namespace {

using mesh::Axis;

constexpr double pi = std::numbers::pi;

/// Cords side by side in a ply: round, not overlapping and no thicker than the ply, so that V <= pi/4.
bool fit(TomlTable& table, double diameter, double ends, double thickness) {
    // Cords that just touch do fit, whatever the last digit of the product.
    constexpr double round_off = 1e-9;
    const std::size_t before = table.errors().count();
    if (diameter * ends > 1.0 + round_off) {
        table.add_error(
            "ends",
            fmt::format("{:.6g} cords of {:.6g} mm are {:.6g} mm wide and overlap in a metre", ends, diameter * 1e3,
                        diameter * ends * 1e3),
            fmt::format("at most {:.6g} fit in; write the number of cords per length across them", 1.0 / diameter));
    }
    if (diameter > thickness * (1.0 + round_off)) {
        table.add_error(
            "cord_diameter",
            fmt::format("cords of {:.6g} mm do not fit into a ply of {:.6g} mm", diameter * 1e3, thickness * 1e3),
            "thickness is that of one ply with the rubber above and below its cords");
    }
    return table.errors().count() == before;
}

/// Density and heat capacity are the material's own, or follow from the cords': both of one kind.
std::optional<CordCapacity> read_capacity(TomlTable& table, bool is_given_by_material) {
    const Need need = is_given_by_material ? Need::optional : Need::required;
    const auto density = table.quantity("cord_density", need);
    const auto capacity = table.quantity("cord_heat_capacity", need);
    if (is_given_by_material) {
        for (const std::string_view key : {"cord_density", "cord_heat_capacity"}) {
            if (table.has(key)) {
                table.add_error(key,
                                fmt::format("{} is ignored: the material gives its density and heat_capacity", key),
                                "remove it, or density and heat_capacity of the material");
            }
        }
        return std::nullopt;
    }
    return density && capacity ? std::optional(CordCapacity{*density, *capacity}) : std::nullopt;
}

/// All four moduli, or none.
std::optional<PlyElasticity> read_elasticity(TomlTable& table) {
    const bool any = table.has("cord_modulus") || table.has("rubber_modulus") || table.has("cord_poisson") ||
                     table.has("rubber_poisson");
    const Need need = any ? Need::required : Need::optional;
    const auto E_c = table.quantity("cord_modulus", need);
    const auto nu_c = table.quantity("cord_poisson", need);
    const auto E_r = table.quantity("rubber_modulus", need);
    const auto nu_r = table.quantity("rubber_poisson", need);
    if (!E_c || !nu_c || !E_r || !nu_r) {
        return std::nullopt;
    }
    return PlyElasticity{.cord = {.modulus = *E_c, .poisson = *nu_c}, .rubber = {.modulus = *E_r, .poisson = *nu_r}};
}

/// @pre it has moduli
physics::Lamina lamina_of(const CordRubberPly& ply) {
    return physics::lamina(
        {.cord = ply.elasticity->cord, .rubber = ply.elasticity->rubber, .cord_share = ply.cords.share});
}

bool resolves(const mesh::Mesh& mesh, Axis axis) {
    return std::ranges::any_of(
        mesh.faces, [&](const mesh::Face& face) { return !face.is_coupling && face.link < 0 && face.axis == axis; });
}

}  // namespace

bool CordRubberPly::is_unbalanced() const { return plies % 2 != 0 && std::abs(std::sin(2.0 * angle)) > 1e-9; }

std::optional<CordRubberPly> read_cord_rubber(TomlTable& material) {
    const bool has_capacity = material.has("density") || material.has("heat_capacity");
    for (const std::string_view key : {"conductivity", "conductivity_meridian", "conductivity_circumference"}) {
        if (material.has("cord_rubber") && material.has(key)) {
            material.add_error(key, fmt::format("{} follows from cord_rubber: it is given twice", key),
                               fmt::format("remove {} or cord_rubber", key));
        }
    }
    TomlTable table = material.subtable("cord_rubber");
    if (!table.exists()) {
        return std::nullopt;
    }
    const std::size_t before = table.errors().count();
    CordRubberPly ply{.rubber = table.text("rubber").value_or(""), .place = table.place(), .cords = {}};
    const auto diameter = table.quantity("cord_diameter");
    const auto ends = table.quantity("ends");
    const auto thickness = table.quantity("thickness");
    const auto along = table.quantity("cord_conductivity");
    const auto across = table.quantity("cord_conductivity_across");
    const auto angle = table.quantity("angle", Need::required);
    ply.plies = table.count("plies").value_or(2);
    ply.capacity = read_capacity(table, has_capacity);
    ply.elasticity = read_elasticity(table);
    if (!diameter || !ends || !thickness || !fit(table, *diameter, *ends, *thickness) ||
        table.errors().count() > before) {
        return std::nullopt;
    }
    ply.cords = {.share = physics::CordRubber::share(*diameter, *ends, *thickness, 1.0),
                 .conductivity_along = *along,
                 .conductivity_across = across.value_or(*along)};
    ply.angle = std::clamp(*angle, -pi / 2.0, pi / 2.0);
    ply.thickness = *thickness;
    return ply;
}

void mix(const CordRubberPly& ply, const physics::Material& rubber, physics::Material& material) {
    material.conductivity = physics::ply_conductivity(ply.cords, rubber.along(Axis::through), ply.angle);
    if (ply.capacity) {
        material.density = physics::ply_density(ply.cords.share, ply.capacity->density, rubber.density);
        material.heat_capacity = physics::ply_heat_capacity(
            ply.cords.share, {ply.capacity->density, physics::Curve::constant(ply.capacity->heat_capacity)},
            {rubber.density, rubber.heat_capacity});
    }
}

void check_cord_rubber(const CordRubberPly& ply, const std::string& name, const mesh::Mesh& mesh, InputErrors& errors) {
    const bool both = resolves(mesh, Axis::meridian) && resolves(mesh, Axis::circumference);
    if (both && ply.is_unbalanced()) {
        errors.add(ply.place,
                   fmt::format("{} of {} at {:.6g} degrees to the circumference conduct{} heat obliquely, which a mesh "
                               "along meridian and circumference cannot show",
                               ply.plies == 1 ? "the ply" : fmt::format("{} plies", ply.plies), name,
                               ply.angle * 180.0 / pi, ply.plies == 1 ? "s" : ""),
                   "plies in pairs at +-angle cancel it: take an even number of plies; or a mesh that is even around "
                   "the circumference");
    }
    const bool is_disc = mesh.is_axisymmetric();
    if (is_disc && (ply.is_unbalanced() || std::abs(std::cos(2.0 * ply.angle)) > 1e-9)) {
        errors.add(
            ply.place,
            fmt::format("{} conducts along its cords otherwise than across them, but a disc has one conductivity "
                        "in its plane",
                        name),
            "take the mesh kind block");
    }
}

void check_thickness(const CordRubberPly& ply, double thickness, const TomlTable& layer) {
    const double plies = ply.plies * ply.thickness;
    if (std::abs(thickness / plies - 1.0) > 0.01) {
        layer.errors().warn(layer.place("thickness"),
                            "the layer is {:.6g} mm thick, but its {} of {:.6g} mm: {:.6g} mm", thickness * 1e3,
                            ply.plies == 1 ? "ply is one" : fmt::format("{} plies are", ply.plies), ply.thickness * 1e3,
                            plies * 1e3);
    }
}

physics::Sheet laminate_of(const CordRubberPly& ply) { return physics::laminate(lamina_of(ply), ply.angle, ply.plies); }

PlySummary summary_of(const CordRubberPly& ply, const physics::Material& material) {
    constexpr double room = 293.15;
    PlySummary summary{.material = material.name,
                       .cord_share = ply.cords.share,
                       .temperature = room,
                       .meridian = material.along(Axis::meridian).value(room),
                       .circumference = material.along(Axis::circumference).value(room),
                       .through = material.along(Axis::through).value(room)};
    if (ply.elasticity) {
        summary.elastic = {.lamina = lamina_of(ply),
                           .ply = physics::laminate(lamina_of(ply), ply.angle, 1),
                           .layer = laminate_of(ply),
                           .plies = ply.plies};
    }
    return summary;
}

}  // namespace tiretherm::input
