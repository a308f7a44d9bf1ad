// SPDX-License-Identifier: BSD-3-Clause
// The list of all tables, and which of them a title of a message names.
#include "input/schema/all_tables.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <iterator>
#include <map>
#include <string>

#include "input/text/quantity_specs.hpp"

namespace tiretherm::input {

namespace {

/// Tables that are described once for several places.
const std::map<std::string_view, std::string_view, std::less<>>& described_as() {
    static const std::map<std::string_view, std::string_view, std::less<>> same{
        {"the case", ""},
        {"the study", "study:"},
        {"the table", "table:"},
        {"mesh.y", "mesh.x"},
        {"mesh.radius", "mesh.x"},
        {"mesh.link_conductivity", "law"},
        {"material.heat_capacity", "law"},
        {"material.conductivity", "law"},
        {"material.conductivity_meridian", "law"},
        {"material.conductivity_circumference", "law"},
        {"tire.grip.adhesion", "law"},
        {"diagnose.possible.drive", "drive"},
        {"diagnose.possible.drive.schedule", "drive.schedule"},
        {"diagnose.possible.drive.file", "drive.file"},
        {"number.over", "number.minus"},
        {"number.over.minus", "number.minus"},
    };
    return same;
}

std::vector<TableKeys> collected() {
    constexpr std::array parts{schema::case_tables,      schema::tire_tables,   schema::mesh_tables,
                               schema::material_tables,  schema::effect_tables, schema::drive_tables,
                               schema::vehicle_tables,   schema::time_tables,   schema::sensor_tables,
                               schema::run_tables,       schema::fit_tables,    schema::study_tables,
                               schema::validation_tables};
    std::vector<TableKeys> all;
    for (const auto part : parts) {
        std::ranges::move(part(), std::back_inserter(all));
    }
    return all;
}

}  // namespace

const Key* TableKeys::find(std::string_view name, std::string_view kind) const {
    const Key* found = nullptr;
    for (const Key& key : keys) {
        if (key.name == name && (found == nullptr || key.is_of(kind))) {
            found = &key;
        }
    }
    return found;
}

bool Key::is_of(std::string_view kind) const {
    if (of_kinds.empty()) {
        return true;
    }
    // Kinds are separated by blanks: a whole word of the list.
    const std::string list = " " + std::string(of_kinds) + " ";
    return list.find(" " + std::string(kind) + " ") != std::string::npos;
}

const std::vector<TableKeys>& all_tables() {
    static const std::vector<TableKeys> all = collected();
    return all;
}

const TableKeys* keys_of_table(std::string_view title) {
    std::string path(title);
    std::erase_if(path, [](char c) { return c == '[' || c == ']'; });
    if (const auto same = described_as().find(path); same != described_as().end()) {
        path = same->second;
    } else if (path.starts_with("effects.") && path.find('.') == path.rfind('.')) {
        path = "effects.NAME";
    }
    const auto found = std::ranges::find(all_tables(), path, &TableKeys::path);
    return found == all_tables().end() ? nullptr : &*found;
}

Key schema::signal(std::string_view name, std::string_view sentence) {
    const physics::Signal* its = physics::find_signal(name);
    assert(its != nullptr);
    return quantity(name, quantity_specs::of(*its), sentence);
}

}  // namespace tiretherm::input
