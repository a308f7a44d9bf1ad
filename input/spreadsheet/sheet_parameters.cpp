// SPDX-License-Identifier: BSD-3-Clause
// Names of the ten sheets, their measured tables, and the comparison of names without case and punctuation.

#include "input/spreadsheet/sheet_parameters.hpp"

#include <algorithm>
#include <array>
#include <cctype>

#include <fmt/format.h>

namespace tiretherm::input {

namespace {

constexpr std::array<std::string_view, 10> names{
    "INFO", "PARA", "SF", "SEL", "THRCOND", "SPEHEAT", "ContactPatch", "LateralStiffness", "Radius", "SWITCH"};

// sheet, variable, its aliases and unit, value, its aliases and unit, table, key, law, meaning
constexpr std::array tables{
    SheetTable{"THRCOND", "Temperature", "T|Bulk Temperature", "degC", "Thermal Conductivity", "k|Conductivity", "W/mK",
               "material", "conductivity", "conductivity", "k against temperature"},
    SheetTable{"SPEHEAT", "Temperature", "T|Bulk Temperature", "degC", "Specific heat", "c|cv|Specific heat capacity",
               "J/kgK", "material", "heat_capacity", "heat_capacity", "c against temperature"},
    SheetTable{"ContactPatch", "Vertical Load",
               "Fz|Load|Vertical Load vector for contact length|Vertical Load vector for contact patch", "N",
               "Contact Length", "Contact Length vector|Length|Equivalent contact patch length", "mm", "tire",
               "contact_length", "contact_length", "length of the contact against load"},
    SheetTable{"ContactPatch", "Vertical Load",
               "Fz|Load|Vertical Load vector for contact length|Vertical Load vector for contact patch", "N",
               "Contact Patch", "Contact Patch vector|Contact Area|Area|Contact patch area", "mm2", "tire",
               "contact_area", "contact_area", "area of the contact against load"},
    SheetTable{"LateralStiffness", "Vertical Load", "Fz|Load|Vertical Load vector for Lateral Stiffness", "N",
               "Lateral Stiffness", "Tire Lateral stiffness|Cornering Stiffness|CP", "N/rad", "", "", "",
               "cornering stiffness against load and bulk temperature", true},
    SheetTable{"Radius", "Vertical Load",
               "Fz|Load|Vertical Load vector for Loaded Radius|Vertical Load vector for Rolling Radius", "N",
               "Loaded Radius", "Loaded Radius Vector|RL", "m", "tire", "loaded_radius", "loaded_radius",
               "loaded radius against load"},
    SheetTable{"Radius", "Vertical Load",
               "Fz|Load|Vertical Load vector for Loaded Radius|Vertical Load vector for Rolling Radius", "N",
               "Rolling Radius", "Rolling Radius Vector|RR", "m", "tire", "rolling_radius", "rolling_radius",
               "rolling radius against load"},
};

/// Letters and digits of a name in small letters, one blank between its words.
std::string plain(std::string_view text) {
    std::string result;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (std::isalnum(byte) != 0 || byte >= 128) {
            result += static_cast<char>(std::tolower(byte));
        } else if (!result.empty() && result.back() != ' ') {
            result += ' ';
        }
    }
    if (!result.empty() && result.back() == ' ') {
        result.pop_back();
    }
    return result;
}

}  // namespace

std::string SheetParameter::path() const {
    return key.empty() || table.empty() ? std::string(key) : fmt::format("{}.{}", table, key);
}

std::span<const std::string_view> sheet_names() { return names; }
std::span<const SheetTable> sheet_tables() { return tables; }

bool is_called(std::string_view text, std::string_view name, std::string_view aliases) {
    const std::string wanted = plain(text);
    if (wanted.empty()) {
        return false;
    }
    if (wanted == plain(name)) {
        return true;
    }
    while (!aliases.empty()) {
        const std::size_t end = std::min(aliases.find('|'), aliases.size());
        if (wanted == plain(aliases.substr(0, end))) {
            return true;
        }
        aliases.remove_prefix(std::min(end + 1, aliases.size()));
    }
    return false;
}

const SheetParameter* find_sheet_parameter(std::string_view sheet, std::string_view name) {
    const auto found = std::ranges::find_if(sheet_parameters(), [&](const SheetParameter& p) {
        return p.sheet == sheet && is_called(name, p.name, p.aliases);
    });
    return found == sheet_parameters().end() ? nullptr : &*found;
}

bool is_sheet_label(std::string_view sheet, std::string_view text) {
    const std::string label = plain(text);
    const auto of = [&](std::string_view name) { return label == name; };
    return (sheet == "ContactPatch" && (of("contact length") || of("contact patch"))) ||
           (sheet == "Radius" && (of("loaded radius") || of("rolling radius")));
}

}  // namespace tiretherm::input
