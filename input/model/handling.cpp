// SPDX-License-Identifier: BSD-3-Clause
// Each table of [tire] in turn; a stiffness is a file or a table of the case, with columns known by their names.

#include "input/model/handling.hpp"

#include <array>

#include <fmt/format.h>

#include "input/columns/grid_rows.hpp"
#include "input/model/law.hpp"
#include "input/model/tire.hpp"
#include "input/tables/data_file.hpp"
#include "input/text/quantity_specs.hpp"
#include "input/tire_property_file/tir_file.hpp"

namespace tiretherm::input {

namespace {

using physics::Handling;

/// The Magic Formula's coefficients: property_file, beside the file that names it.
void read_property_file(TomlTable& tire, Handling& into) {
    if (const std::optional<std::string> path = tire.text("property_file")) {
        const SourceLocation mentioned = tire.place("property_file");
        if (const auto file = read_tir_file(tire.errors().beside(mentioned, *path), mentioned, tire.errors())) {
            into.magic_formula = file->law_on_the_right();
            if (file->is_left) {
                tire.errors().warn(mentioned,
                                   "TYRESIDE of the property file is LEFT: its mirror image counts, as the inputs are "
                                   "those of a tire on the right");
            }
        }
    }
}

constexpr std::string_view stiffness = "cornering_stiffness";

/// The rows of `cornering_stiffness`, in a file or in the case; nothing where it is absent or wrong.
std::optional<GridRows> read_stiffness(TomlTable& table) {
    // A table without one of the first three did not vary it.
    const std::array known{grid_column_of("vertical_load"), grid_column_of("inflation_pressure"), grid_column_of_bulk(),
                           GridColumn{stiffness, {.unit = "N/rad", .low = 0.0, .high = 1e7, .above = true}, true}};
    constexpr std::string_view lacks = "a table of the cornering stiffness has no column";
    const TomlValue* given = table.value(stiffness);
    if (given == nullptr) {
        return std::nullopt;
    }
    InputErrors& errors = table.errors();
    const std::size_t before = errors.count();
    GridRows rows;
    if (given->kind == TomlValue::Kind::text) {
        const auto file = DataFile::open(errors.beside(given->place, given->text), given->place, errors);
        if (!file) {
            return std::nullopt;
        }
        rows = read_grid_rows(*file, known, lacks, errors);
    } else if (given->kind == TomlValue::Kind::table) {
        TomlTable inner = table.subtable(stiffness);
        rows = read_grid_rows(inner, known, lacks);
    } else {
        return table.add_error(stiffness, "cornering_stiffness is the name of a file or a table of columns and rows",
                               "write cornering_stiffness = \"stiffness.csv\"");
    }
    for (const std::string_view name : {std::string_view("vertical_load"), stiffness}) {
        if (errors.count() == before && !rows.has(name)) {
            errors.add(rows.top, fmt::format("the table has no {}", name),
                       "its columns are vertical_load, bulk_temperature and cornering_stiffness, each with a unit");
        }
    }
    return errors.count() == before && !rows.values.empty() ? std::optional(std::move(rows)) : std::nullopt;
}

/// How friction follows the temperature of the surface: [tire.grip].
void read_grip(TomlTable& tire, Handling& into) {
    TomlTable table = tire.subtable("grip");
    if (!table.exists()) {
        return;
    }
    physics::Grip grip;
    table.read_into(grip);
    const QuantitySpec friction{.unit = "1", .low = 0.0, .high = 10.0};
    grip.adhesion = read_law(table, "adhesion", friction, Need::optional).value_or(physics::Curve());
    if (!(grip.adhesion.value(grip.reference_temperature) + grip.hysteresis + grip.wear > 0.0)) {
        table.add_error("adhesion", "there is no friction at the reference temperature",
                        "give adhesion, hysteresis or both: hysteresis = 0.6");
    }
    into.grip = std::move(grip);
}

/// The curve of the lateral force without a property file: [tire.lateral_peak].
void read_lateral_peak(TomlTable& tire, Handling& into) {
    TomlTable table = tire.subtable("lateral_peak");
    if (!table.exists()) {
        return;
    }
    into.peak_curve.emplace();
    table.read_into(*into.peak_curve);
    if (tire.has("property_file")) {
        tire.add_error("lateral_peak", "the lateral force is that of property_file already",
                       "remove lateral_peak or property_file");
    }
}

/// What was measured to stand beside the laws: [tire.measured].
void read_measured_laws(TomlTable& tire, Handling& into) {
    TomlTable table = tire.subtable("measured");
    if (!table.exists()) {
        return;
    }
    physics::MeasuredLaws& measured = into.measured;
    for (const LoadLaw& law : load_laws()) {
        measured.*law.measured = read_curve(table, law.name, quantity_specs::load, law.value);
    }
    if (const std::optional<GridRows> rows = read_stiffness(table)) {
        for (const std::string_view name : {"bulk_temperature", "inflation_pressure"}) {
            if (rows->has(name) != (name == "bulk_temperature")) {
                table.errors().add(rows->top,
                                   rows->has(name) ? "measured stiffnesses stand at the pressure of the laws, and the "
                                                     "table has a column inflation_pressure"
                                                   : "the table has no bulk_temperature",
                                   rows->has(name) ? "remove the column" : "add the column");
                return;
            }
        }
        // Not a grid: each row is a test of its own.
        for (std::size_t i = 0; i < rows->of(stiffness).size(); ++i) {
            measured.cornering_stiffness.push_back({.load = rows->of("vertical_load")[i],
                                                    .temperature = rows->of("bulk_temperature")[i],
                                                    .stiffness = rows->of(stiffness)[i]});
        }
    }
}

}  // namespace

Handling read_handling(TomlTable& tire) {
    Handling read;
    {
        TomlTable modulus = tire.subtable("modulus");
        modulus.read_into(read.modulus);
        modulus.read_into(read);
        modulus.text("belt_material");  // its plies are known later
    }
    read_property_file(tire, read);
    if (const std::optional<GridRows> rows = read_stiffness(tire)) {
        if (std::optional<GridFile> grid = full_grid(*rows, rows->of(stiffness), tire.errors())) {
            read.stiffness_table = std::move(grid->table);
        }
    }
    read_lateral_peak(tire, read);
    read_grip(tire, read);
    read_measured_laws(tire, read);
    // What a case says of friction alone is no reason to show a stiffness of assumed moduli.
    for (const std::string_view key : {"modulus", "property_file", "cornering_stiffness", "lateral_peak"}) {
        read.is_given = read.is_given || tire.has(key);
    }
    read.is_given = read.is_given || !read.measured.cornering_stiffness.empty();
    return read;
}

void settle_belt(TomlTable& root, std::vector<Stock>& stock, Handling& handling) {
    InputErrors& errors = root.errors();
    const auto given = [&](std::string_view key) { return root.content().find({"tire", "modulus", key}); };
    physics::EquivalentModulus& modulus = handling.modulus;
    const TomlValue* belt = given("belt_material");
    if (belt != nullptr && belt->kind == TomlValue::Kind::text) {
        const Stock* material = use_material({belt->text, belt->place}, stock, errors);
        const bool has_moduli = material != nullptr && material->ply && material->ply->elasticity;
        if (has_moduli) {
            // The belt of the cords is stiffer or softer in all contacts alike, unless the case says how it falls.
            const double share = modulus.dE / modulus.E_max;
            modulus.E_max = laminate_of(*material->ply).E_x;
            modulus.dE = given("belt_fall") != nullptr ? modulus.dE : share * modulus.E_max;
        } else if (material != nullptr) {
            errors.add(belt->place, fmt::format("{} has no moduli of cords and rubber", belt->text),
                       "give its [material.cord_rubber] cord_modulus, cord_poisson, rubber_modulus and rubber_poisson");
        }
        if (const TomlValue* twice = given("belt_maximum")) {
            errors.add(twice->place, "belt_maximum follows from belt_material: it is given twice",
                       "remove one of them");
        }
    }
    const auto place = [&](std::string_view key) {
        const TomlValue* table = root.content().find({"tire", "modulus"});
        return given(key) != nullptr ? given(key)->place : table != nullptr ? table->place : root.place("tire");
    };
    if (modulus.dE >= modulus.E_max) {
        errors.add(place("belt_fall"), "the belt's modulus would fall to nothing",
                   belt == nullptr
                       ? "let it be smaller than belt_maximum"
                       : fmt::format("let it be smaller than the {:.4g} MPa of {}", 1e-6 * modulus.E_max, belt->text));
    }
    if (modulus.dE_T >= 2.0 * modulus.E_mid) {
        errors.add(place("tread_fall"), "the tread's modulus would fall to nothing",
                   "let it be smaller than twice tread_middle");
    }
}

}  // namespace tiretherm::input
