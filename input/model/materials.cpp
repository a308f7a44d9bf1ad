// SPDX-License-Identifier: BSD-3-Clause
// Reads [[material]]: density, heat capacity and conductivity, which may differ along meridian and circumference.

#include <algorithm>

#include <fmt/format.h>

#include "input/model/law.hpp"
#include "input/model/problem_builder.hpp"
#include "input/text/quantity_specs.hpp"
#include "input/text/suggestions.hpp"

namespace tiretherm::input {

namespace {

using physics::Curve;

std::size_t index(mesh::Axis axis) { return static_cast<std::size_t>(axis); }

}  // namespace

void read_materials(TomlTable& root, ProblemBuilder& builder) {
    root.each(
        "material",
        [&](TomlTable& table) {
            Stock stock{.material = {}, .table = &table.content()};
            physics::Material& material = stock.material;
            material.name = table.name("name", Need::required).value_or("");
            material.density =
                table.quantity("density", quantity_specs::density, Need::required).value_or(material.density);
            const Curve none = Curve::constant(1.0);
            material.heat_capacity =
                read_law(table, "heat_capacity", quantity_specs::heat_capacity, Need::required).value_or(none);
            const Curve through =
                read_law(table, "conductivity", quantity_specs::conductivity, Need::required).value_or(none);
            material.conductivity[index(mesh::Axis::through)] = through;
            material.conductivity[index(mesh::Axis::meridian)] =
                read_law(table, "conductivity_meridian", quantity_specs::conductivity, Need::optional)
                    .value_or(through);
            material.conductivity[index(mesh::Axis::circumference)] =
                read_law(table, "conductivity_circumference", quantity_specs::conductivity, Need::optional)
                    .value_or(through);
            const auto same = std::find_if(builder.stock.begin(), builder.stock.end(),
                                           [&](const Stock& other) { return other.material.name == material.name; });
            if (same != builder.stock.end() && !material.name.empty()) {
                table.add_error("name",
                                fmt::format("a second material is called \"{}\"; the first is at {}", material.name,
                                            table.errors().spell(same->table->place)),
                                "rename or remove one");
                return;
            }
            builder.stock.push_back(std::move(stock));
        },
        Need::required);
}

const physics::Material* read_material(TomlTable& table, std::string_view key, ProblemBuilder& builder) {
    const std::optional<std::string> name = table.text(key, Need::required);
    if (!name) {
        return nullptr;
    }
    std::vector<std::string> known;
    for (Stock& stock : builder.stock) {
        if (stock.material.name == *name) {
            stock.used = true;
            return &stock.material;
        }
        known.push_back(stock.material.name);
    }
    table.add_error(key, fmt::format("there is no material \"{}\"", *name), suggest(*name, known, "materials"));
    return nullptr;
}

}  // namespace tiretherm::input
