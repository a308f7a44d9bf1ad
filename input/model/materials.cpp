// SPDX-License-Identifier: BSD-3-Clause
// Reads [[material]]: density, heat capacity and conductivity, which may differ along meridian and circumference, or
// cords and rubber from which they follow.

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

std::vector<std::string> names_of_materials(const ProblemBuilder& builder) {
    std::vector<std::string> names;
    for (const Stock& stock : builder.stock) {
        names.push_back(stock.material.name);
    }
    return names;
}

Stock* find(ProblemBuilder& builder, std::string_view name) {
    const auto found =
        std::ranges::find_if(builder.stock, [&](const Stock& stock) { return stock.material.name == name; });
    return found == builder.stock.end() ? nullptr : &*found;
}

/// Plies of cords, when all materials are known: their rubber may stand behind them. Its name is checked even where the
/// rest of the plies is wrong.
void mix_with_rubber(Stock& stock, ProblemBuilder& builder, InputErrors& errors) {
    const TomlValue* table = stock.table->find("cord_rubber");
    const TomlValue* name = table == nullptr ? nullptr : table->find("rubber");
    if (name == nullptr || name->kind != TomlValue::Kind::text) {
        return;
    }
    const Stock* rubber = find(builder, name->text);
    if (rubber == nullptr) {
        errors.add(name->place, fmt::format("there is no material \"{}\"", name->text),
                   suggest(name->text, names_of_materials(builder), "materials"));
    } else if (rubber->table->find("cord_rubber") != nullptr) {
        errors.add(name->place, fmt::format("\"{}\" is itself of cords and rubber", name->text),
                   "name the rubber between the cords");
    } else if (stock.ply) {
        mix(*stock.ply, rubber->material, stock.material);
    }
}

}  // namespace

void read_materials(TomlTable& root, ProblemBuilder& builder) {
    root.each(
        "material",
        [&](TomlTable& table) {
            Stock stock{.material = {}, .table = &table.content()};
            physics::Material& material = stock.material;
            material.name = table.name("name", Need::required).value_or("");
            const bool is_mixed = table.has("cord_rubber");
            const bool has_capacity = !is_mixed || table.has("density") || table.has("heat_capacity");
            const Need capacity = has_capacity ? Need::required : Need::optional;
            const Need conductivity = is_mixed ? Need::optional : Need::required;
            material.density = table.quantity("density", capacity).value_or(material.density);
            const Curve none = Curve::constant(1.0);
            material.heat_capacity =
                read_law(table, "heat_capacity", quantity_specs::heat_capacity, capacity).value_or(none);
            const Curve through =
                read_law(table, "conductivity", quantity_specs::conductivity, conductivity).value_or(none);
            material.conductivity[index(mesh::Axis::through)] = through;
            material.conductivity[index(mesh::Axis::meridian)] =
                read_law(table, "conductivity_meridian", quantity_specs::conductivity, Need::optional)
                    .value_or(through);
            material.conductivity[index(mesh::Axis::circumference)] =
                read_law(table, "conductivity_circumference", quantity_specs::conductivity, Need::optional)
                    .value_or(through);
            stock.ply = read_cord_rubber(table);
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
    for (Stock& stock : builder.stock) {
        mix_with_rubber(stock, builder, root.errors());
    }
}

const physics::Material* read_material(TomlTable& table, std::string_view key, ProblemBuilder& builder) {
    const std::optional<std::string> name = table.text(key, Need::required);
    if (!name) {
        return nullptr;
    }
    if (Stock* stock = find(builder, *name)) {
        stock->used = true;
        Stock* rubber = stock->ply ? find(builder, stock->ply->rubber) : nullptr;
        if (rubber != nullptr) {
            rubber->used = true;
        }
        return &stock->material;
    }
    table.add_error(key, fmt::format("there is no material \"{}\"", *name),
                    suggest(*name, names_of_materials(builder), "materials"));
    return nullptr;
}

}  // namespace tiretherm::input
