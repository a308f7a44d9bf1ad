// SPDX-License-Identifier: BSD-3-Clause
// Multiplies cell counts, or writes two layers of cells in the place of two nodes.

#include "input/parameters/mesh_change.hpp"

#include "input/toml/toml_text.hpp"

namespace tiretherm::input {

namespace {

/// Multiplies every number of cells in a table and in the lists within it.
void refine(TomlValue& table, int finer) {
    for (Entry& entry : table.entries) {
        // Ratios stay: they are those of the whole row of cells, and finer cells only pass through more steps of it.
        if (entry.key.ends_with("cells") && entry.value.kind == TomlValue::Kind::integer) {
            entry.value.number *= finer;
        }
        refine(entry.value, finer);
    }
    for (TomlValue& item : table.items) {
        refine(item, finer);
    }
}

/// Cells of the two lumps' rubber: in a crown of 12 mm with 15 % in the surface lump the outermost is 0.1 mm thick, what half
/// a second of warming reaches.
struct Cells {
    int count;
    double ratio;  ///< of the innermost to the outermost
};
constexpr Cells of_surface{.count = 8, .ratio = 4.0};
constexpr Cells of_bulk{.count = 14, .ratio = 2.0};

TomlValue layer(std::string name, double thickness, const Cells& cells, const TomlValue* material) {
    TomlValue count = toml_text::quantity_value(cells.count, "1");
    count.kind = TomlValue::Kind::integer;
    TomlValue table = toml_text::table_value({{"name", toml_text::text_value(std::move(name))},
                                              {"thickness", toml_text::quantity_value(thickness, "m")},
                                              {"cells", std::move(count)},
                                              {"ratio", toml_text::quantity_value(cells.ratio, "1")}});
    if (material != nullptr) {
        table.set("material", *material);
    }
    return table;
}

}  // namespace

void change_mesh(TomlValue& mesh, const MeshChange& change) {
    const TomlValue* kind = mesh.find("kind");
    if (change.layers > 0.0 && kind != nullptr && kind->text == "two_node") {
        const TomlValue* material = mesh.find("material");
        const TomlValue* share = mesh.find("surface_mass_share");
        const double outer = change.layers * (share != nullptr ? share->number : 0.5);
        TomlValue layers = toml_text::table_value({{"kind", toml_text::text_value("layers")}});
        layers.set("layer", toml_text::list_value({layer("surface", outer, of_surface, material),
                                                   layer("bulk", change.layers - outer, of_bulk, material)}));
        layers.in_braces = false;
        layers.place = mesh.place;
        mesh = std::move(layers);
    }
    if (change.finer > 1) {
        refine(mesh, change.finer);
    }
}

std::optional<double> thickness_as_layers(const solver::Problem& problem) {
    const bool two_nodes = problem.mesh.is_lumped() && problem.mesh.layers.size() == 2;
    const double area = problem.tire.outer_area();
    if (!two_nodes || !(area > 0.0) || !(problem.tire.density > 0.0)) {
        return std::nullopt;
    }
    return problem.tire.band_mass() / problem.tire.density / area;
}

}  // namespace tiretherm::input
