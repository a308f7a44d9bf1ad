// SPDX-License-Identifier: BSD-3-Clause
// Spreadsheets that tests write, with every parameter at a value that no default has, and the case made of them.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "input/spreadsheet/sheet_case.hpp"
#include "input/spreadsheet/sheet_parameters.hpp"
#include "input/toml/document.hpp"
#include "support/written.hpp"

/// Spreadsheets that tests write, and what became of them.
namespace tiretherm::input::sheets {

/// The text of each sheet's CSV file, by its name.
using Texts = std::map<std::string, std::string>;

/// Every parameter that has a place, as name, value and unit, none with the value that a case would have without it.
/// The two of LateralStiffness that stand for two of SEL are left out.
inline const std::map<std::string, std::pair<std::string, std::string>>& values(std::string_view sheet) {
    using Rows = std::map<std::string, std::pair<std::string, std::string>>;
    static const std::map<std::string, Rows, std::less<>> all{
        {"INFO",
         {{"Tyre Name", {"Winter tire", "-"}},
          {"Size", {"205/55 R16", "-"}},
          {"Initial Tyre Surface Temperature", {"38", "degC"}},
          {"Initial Tyre Bulk Temperature", {"43", "degC"}},
          {"Air Temperature", {"21", "degC"}},
          {"Track Temperature", {"27", "degC"}},
          {"Min Fz for no contact condition", {"100", "N"}}}},
        {"PARA",
         {{"Unloaded Radius", {"0.317", "m"}},
          {"Tread Thickness", {"13", "mm"}},
          {"Sidewall Thickness", {"8", "mm"}},
          {"Tire Surface Mass percentage", {"12", "%"}},
          {"Bulk Measure Point Depth", {"9", "mm"}},
          {"Natural convection coeff.", {"25", "[W/m\u00B2K]"}},
          {"Hc", {"450", "[W/m2K]"}},
          {"Tire Rubber Density", {"1150", "kg/m3"}},
          {"Air Thermal Conductivity", {"0.026", "[W/mK]"}},
          {"Air kinematic viscosity", {"1.6e-5", "[m\u00B2/s]"}},
          {"Heat Partition coefficient", {"0.55", "[-]"}},
          {"Tire Width", {"210", "mm"}},
          {"Sidewall Height", {"111", "mm"}}}},
        {"SF",
         {{"Scaling Factor Friction Long", {"1.01", "-"}},
          {"Scaling Factor Friction Lat", {"1.02", "-"}},
          {"Scaling Factor Air-Tire Therm. Exch.", {"1.03", "-"}},
          {"Scaling Factor Track-Tire Therm. Exch.", {"1.04", "-"}},
          {"Scaling Factor Cornering Stiffness", {"1.05", "-"}},
          {"Scaling Factor SEL surface", {"1.06", "-"}},
          {"Scaling Factor SEL bulk", {"1.07", "-"}}}},
        {"SEL",
         {{"Reference Frequency", {"50", "Hz"}},
          {"Tand peak Temperature", {"-10", "[\u00B0C]"}},
          {"Glassy-Rubbery transition range", {"290", "K"}},
          {"C1", {"-8.8", "[-]"}},
          {"C2", {"101", "[-]"}},
          {"Tand Parameter a1", {"2.1E+15", "[-]"}},
          {"Tand Parameter b1", {"-4980", "[-]"}},
          {"Tand Parameter c1", {"880", "[-]"}}}},
        {"THRCOND",
         {{"Thermal Conductivity coeff. A", {"1e-5", "W/mK3"}},
          {"Thermal Conductivity coeff. B", {"0.008", "W/mK2"}},
          {"Thermal Conductivity coeff. C", {"0.12", "W/mK"}},
          {"Temperature scale", {"degC", ""}}}},
        {"SPEHEAT",
         {{"Specific heat coeff. A", {"0.01", "J/kgK3"}},
          {"Specific heat coeff. B", {"2", "J/kgK2"}},
          {"Specific heat coeff. C", {"1700", "J/kgK"}},
          {"Temperature scale", {"degC", ""}}}},
        {"ContactPatch",
         {{"Contact Length max length", {"150", "mm"}},
          {"Contact Length length curve slope", {"0.36", "[-]"}},
          {"Contact Patch Coeff A", {"2.3", "[mm\u00B2/N]"}},
          {"Contact Patch Coeff B", {"40", "mm2"}}}},
        {"LateralStiffness",
         {{"CP computation", {"ON", ""}},
          {"Maximum modulus", {"320", "MPa"}},
          {"Modulus delta due to contact length", {"300", "MPa"}},
          {"Modulus slope due to contact length", {"-52", "1/m"}},
          {"Contact length threshold", {"51", "mm"}},
          {"Modulus delta due to bulk temperature", {"1120", "MPa"}},
          {"Modulus at the transition", {"600", "MPa"}}}},
        {"Radius",
         {{"Loaded Radius Coeff A", {"-4.3E-06", "[m/N]"}},
          {"Loaded Radius Coeff B", {"0.314", "[m]"}},
          {"Rolling Radius Coeff A", {"0.333", "[m]"}},
          {"Rolling Radius Coeff B", {"-0.008", "[1/N]"}}}},
        {"SWITCH",
         {{"Switch on/off Global Friction Power", {"OFF", ""}},
          {"Switch on/off Longitudinal Friction Power", {"OFF", ""}},
          {"Switch on/off Lateral Friction Power", {"OFF", ""}},
          {"Switch on/off Air-Tire Exchange", {"OFF", ""}},
          {"Switch on/off Track-Tire Exchange", {"OFF", ""}},
          {"Switch on/off Strain Energy generation", {"OFF", ""}},
          {"Switch on/off Surface-Bulk conduction", {"OFF", ""}}}},
    };
    return all.find(sheet)->second;
}

inline std::string row(const std::string& name, const std::pair<std::string, std::string>& value) {
    return fmt::format("{},{},{}\n", name, value.first, value.second);
}

/// All ten sheets with these values.
inline Texts complete() {
    Texts texts;
    for (const std::string_view sheet : sheet_names()) {
        std::string& text = texts[std::string(sheet)] = fmt::format("{}\n,Value,Units\n", sheet);
        for (const auto& [name, value] : values(sheet)) {
            text += row(name, value);
        }
    }
    return texts;
}

/// The complete sheets with all switches on.
inline Texts switched_on() {
    Texts texts = complete();
    for (std::size_t at = 0; (at = texts["SWITCH"].find("OFF", at)) != std::string::npos;) {
        texts["SWITCH"].replace(at, 3, "ON");
    }
    return texts;
}

/// Takes the rows out whose names begin like this.
inline void drop(std::string& text, std::string_view name) {
    for (std::size_t at = text.find("\n" + std::string(name)); at != std::string::npos;
         at = text.find("\n" + std::string(name))) {
        text.erase(at + 1, text.find('\n', at + 1) - at);
    }
}

/// Puts another text for one that must be there.
inline void replace(std::string& text, std::string_view from, std::string_view to) {
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from << " in\n" << text;
    text.replace(at, from.size(), to);
}

inline SheetCase convert(const Texts& texts) {
    const Written written;
    for (const auto& [sheet, text] : texts) {
        written.add("tire/" + sheet + ".csv", text);
    }
    return convert_sheet(written.folder() / "tire");
}

/// All errors as they are shown, without the folder.
inline std::string report(const SheetCase& made) {
    std::string text;
    for (const InputError& error : made.errors) {
        InputError shown = error;
        const std::size_t slash = shown.file.rfind('/');
        shown.file = slash == std::string::npos ? shown.file : shown.file.substr(slash + 1);
        text += render(shown);
    }
    return text;
}

/// Every value of a case by the path of its key; of lists without the numbers of their items.
inline void flatten(const TomlValue& node, const std::string& path, std::multimap<std::string, std::string>& into) {
    if (node.kind == TomlValue::Kind::table) {
        for (const Entry& entry : node.entries) {
            flatten(entry.value, path.empty() ? entry.key : path + "." + entry.key, into);
        }
    } else if (node.kind == TomlValue::Kind::array) {
        for (const TomlValue& item : node.items) {
            flatten(item, path, into);
        }
    } else {
        into.emplace(path, shown(node));
    }
}

inline std::multimap<std::string, std::string> keys_of(const std::string& text) {
    InputErrors errors;
    const TextFile file{.number = errors.add_file("case", text), .text = text};
    const std::optional<TomlValue> document = parse_toml(file, errors);
    std::multimap<std::string, std::string> keys;
    if (document) {
        flatten(*document, "", keys);
    }
    return keys;
}

/// The keys that two cases write differently.
inline std::set<std::string> changed_keys(const std::string& before, const std::string& after) {
    const auto a = keys_of(before);
    const auto b = keys_of(after);
    std::set<std::string> changed;
    for (const auto* of : {&a, &b}) {
        for (const auto& [key, value] : *of) {
            const auto values_in = [&key = key](const auto& keys) {
                std::multiset<std::string> found;
                for (auto [i, end] = keys.equal_range(key); i != end; ++i) {
                    found.insert(i->second);
                }
                return found;
            };
            if (values_in(a) != values_in(b)) {
                changed.insert(key);
            }
        }
    }
    return changed;
}

/// The case as the program reads it.
inline solver::Problem read(const SheetCase& made) {
    const Written written;
    Reading reading = read_case(written.add("case.toml", made.text));
    EXPECT_TRUE(reading.problem) << render(reading);
    return reading.problem ? std::move(*reading.problem) : solver::Problem{};
}

}  // namespace tiretherm::input::sheets
