// SPDX-License-Identifier: BSD-3-Clause
// Property modifier: worn outer layer on an unchanged mesh, w = 1 - depth/thickness: mass times w, conductance across
// times w, through the layer times 1/w.

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "physics/effect.hpp"

namespace tiretherm::physics::effects {

namespace {

enum : std::size_t { depth };

constexpr std::array parameters{
    ParameterSpec{"depth", "m", 0.003, 0.0, 0.05, "rubber worn off the outer layer; 8 mm of tread end at 1.6 mm", false,
                  0.0},
};
constexpr std::array plausible{
    PlausibleRange{"depth", 0.0, 0.0065, "definition: 8 mm of tread that end at 1.6 mm", "more tread is not there"},
};
double thickness_of_outer_layer(const mesh::Mesh& mesh) {
    double thickness = 0.0;
    if (mesh.grid) {
        for (int k = 0; k < mesh.grid->size(2); ++k) {
            const auto z = static_cast<std::size_t>(k);
            const int layer = mesh.layer[static_cast<std::size_t>(mesh.grid->cell(0, 0, k))];
            thickness += layer == 0 ? mesh.grid->edge[2][z + 1] - mesh.grid->edge[2][z] : 0.0;
        }
    }
    for (const mesh::Column& column : mesh.columns) {
        double here = 0.0;
        for (std::size_t k = 0; k + 1 < column.edge.size(); ++k) {
            const int layer = mesh.layer[static_cast<std::size_t>(column.first_cell) + k];
            here += layer == 0 ? column.edge[k + 1] - column.edge[k] : 0.0;
        }
        thickness = std::max(thickness, here);
    }
    return thickness;
}

/// A cell of the share w of its thickness has w of the mass, w of the section across it and 1/w of the resistance
/// through it: the mesh stays and the material says so.
void modify_properties(const ActiveEffect& active, const mesh::Mesh& mesh, MaterialModel& material_model) {
    const double thickness = thickness_of_outer_layer(mesh);
    if (thickness <= 0.0 || active[depth] >= thickness) {
        return;  // the case has been refused
    }
    const double w = 1.0 - active[depth] / thickness;
    Material& outer = material_model.materials.front();
    outer.density *= w;
    for (const mesh::Axis axis : {mesh::Axis::meridian, mesh::Axis::circumference, mesh::Axis::through}) {
        Curve& k = outer.conductivity[static_cast<std::size_t>(axis)];
        k = k.scaled(axis == mesh::Axis::through ? 1.0 / w : w);
    }
}

std::string invalid_on_mesh(const ActiveEffect& active, const mesh::Mesh& mesh) {
    const double thickness = thickness_of_outer_layer(mesh);
    return active[depth] < thickness ? std::string()
                                     : fmt::format("{:.4g} mm are worn off an outer layer of {:.4g} mm",
                                                   1e3 * active[depth], 1e3 * thickness);
}

}  // namespace

extern const Effect tread_wear;
const Effect tread_wear{
    .id = "tread_wear",
    .kind = EffectKind::property,
    .equation = "w = 1 - depth/thickness of the outer layer: mass w, conductance across w, through 1/w",
    .source = "geometry; time constants of conduction shrink as w^2",
    .valid = "wear that is even; up to the depth of the grooves, some 8 mm",
    .meaning =
        "A tread that has lost rubber, spread evenly over the outer layer, the same during the whole run. The layer "
        "takes its smaller share of the strain-energy loss by mass; the law of the total is that of the new tire.",
    .parameters = parameters,
    .plausible = plausible,
    .needs_grid = true,
    .invalid_on_mesh = invalid_on_mesh,
    .model = PropertyModifier{.modify_properties = modify_properties},
};

}  // namespace tiretherm::physics::effects
