// SPDX-License-Identifier: BSD-3-Clause
// Reads [[material]]: density, heat capacity and conductivity, which may differ along meridian and circumference, or
// cords and rubber from which they follow.

#include <algorithm>

#include <fmt/format.h>

#include "input/model/law.hpp"
#include "input/model/materials.hpp"
#include "input/text/quantity_specs.hpp"
#include "input/text/word_lists.hpp"

namespace tiretherm::input {

namespace {

using physics::Curve;

std::size_t index(mesh::Axis axis) { return static_cast<std::size_t>(axis); }

Stock* find(std::vector<Stock>& all, std::string_view name) {
    const auto found = std::ranges::find_if(all, [&](const Stock& stock) { return stock.material.name == name; });
    return found == all.end() ? nullptr : &*found;
}

/// Plies of cords, when all materials are known: their rubber may stand behind them. Its name is checked even where the
/// rest of the plies is wrong.
void mix_with_rubber(Stock& stock, std::vector<Stock>& all, InputErrors& errors) {
    const TomlValue* name = stock.table->find({"cord_rubber", "rubber"});
    if (name == nullptr || name->kind != TomlValue::Kind::text) {
        return;
    }
    const auto found =
        find_name({name->text, name->place}, names_of_materials(all), "there is no material", "materials", errors);
    if (!found) {
        return;
    }
    const Stock* rubber = &all[*found];
    if (rubber->table->find("cord_rubber") != nullptr) {
        errors.add(name->place, fmt::format("\"{}\" is itself of cords and rubber", name->text),
                   "name the rubber between the cords");
    } else if (stock.ply) {
        mix(*stock.ply, rubber->material, stock.material);
    }
}

}  // namespace

std::vector<std::string> names_of_materials(const std::vector<Stock>& all) {
    return names_of(all, [](const Stock& stock) { return stock.material.name; });
}

std::vector<Stock> read_materials(TomlTable& root) {
    std::vector<Stock> all;
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
            const Stock* same = find(all, material.name);
            if (same != nullptr && !material.name.empty()) {
                table.add_error("name",
                                fmt::format("a second material is called \"{}\"; the first is at {}", material.name,
                                            table.errors().spell(same->table->place)),
                                "rename or remove one");
                return;
            }
            all.push_back(std::move(stock));
        },
        Need::required);
    for (Stock& stock : all) {
        mix_with_rubber(stock, all, root.errors());
    }
    return all;
}

const Stock* use_material(const LocatedString& name, std::vector<Stock>& all, InputErrors& errors) {
    if (Stock* stock = find(all, name.text)) {
        stock->used = true;
        Stock* rubber = stock->ply ? find(all, stock->ply->rubber) : nullptr;
        if (rubber != nullptr) {
            rubber->used = true;
        }
        return stock;
    }
    static_cast<void>(find_name(name, names_of_materials(all), "there is no material", "materials", errors));
    return nullptr;
}

const Stock* read_material(TomlTable& table, std::string_view key, std::vector<Stock>& all) {
    const std::optional<std::string> name = table.text(key, Need::required);
    return name ? use_material({*name, table.place(key)}, all, table.errors()) : nullptr;
}

}  // namespace tiretherm::input
