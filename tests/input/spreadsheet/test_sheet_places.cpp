// SPDX-License-Identifier: BSD-3-Clause
// Each parameter of the spreadsheet (thesis V.7) changes its own key of the case and no other.

#include <cmath>

#include <gtest/gtest.h>

#include "input/model/expected.hpp"
#include "input/spreadsheet/sheets.hpp"

// Each parameter of the spreadsheet has its place in the case, and no other.
namespace tiretherm::input {

namespace {

using sheets::Texts;

/// A sheet, and the names that V.7 lists for what stands in it.
const std::vector<std::pair<std::string, std::vector<std::string>>> list_of_V7{
    {"SF",
     {"Scaling Factor Friction Long", "Scaling Factor Friction Lat", "Scaling Factor Air-Tire Therm. Exch.",
      "Scaling Factor Track-Tire Therm. Exch.", "Scaling Factor Cornering Stiffness", "Scaling Factor SEL surface",
      "Scaling Factor SEL bulk"}},
    {"PARA",
     {"Surface Mass", "Bulk Mass", "Unloaded Radius", "Tire Width", "Sidewall Height", "Area Ratio",
      "Carcass Measure Depth", "Cross-section height", "Heat partition coefficient", "Air thermal conductivity",
      "Air kinematic viscosity", "Characteristic Length", "External Total Area", "Track-Tire Exchange coefficient",
      "Natural convection coefficient"}},
    {"INFO",
     {"Lowest value of Fz below that SEL and friction is zero", "Air Temperature", "Track Temperature",
      "Surface Initial Temperature", "Bulk Initial Temperature"}},
    {"THRCOND", {"Thermal Conductivity coeff. A", "Thermal Conductivity coeff. B", "Thermal Conductivity coeff. C"}},
    {"SPEHEAT", {"Specific heat coeff. A", "Specific heat coeff. B", "Specific heat coeff. C"}},
    {"SEL",
     {"Reference compound frequency", "Glassy transition temperature", "Glassy-Rubbery transition range",
      "Tand Maximum", "WLF C1 Coefficient", "WLF C2 Coefficient"}},
    {"SWITCH",
     {"Switch on/off Global Friction Power", "Switch on/off Longitudinal Friction Power",
      "Switch on/off lateral Friction Power", "Switch on/off Air-Tire Exchange", "Switch on/off Track-Tire Exchange",
      "Switch on/off Strain Energy generation", "Switch on/off Surface-Bulk conduction"}},
};

/// Vectors of V.7: the sheet, the one that a table is against and the one that it gives.
const std::vector<std::array<std::string, 3>> vectors_of_V7{
    {"ContactPatch", "Vertical Load vector for contact length", "Contact Length vector"},
    {"ContactPatch", "Vertical Load vector for contact patch", "Contact Patch vector"},
    {"Radius", "Vertical Load vector for Loaded Radius", "Loaded Radius Vector"},
    {"Radius", "Vertical Load vector for Rolling Radius", "Rolling Radius Vector"},
    {"LateralStiffness", "Vertical Load vector for Lateral Stiffness", "Tire Lateral stiffness"},
};

/// Another value of the same kind.
std::string other(const std::string& value) {
    if (value == "ON" || value == "OFF") {
        return value == "ON" ? "OFF" : "ON";
    }
    if (value == "degC") {
        return "K";
    }
    if (value == "Winter tire" || value == "205/55 R16") {
        return value == "Winter tire" ? "Summer tire" : "205/60 R16";
    }
    return fmt::format("{}", 0.995 * std::stod(value));
}

/// The keys that a parameter may change: those of the law that it is a coefficient of count as its own only where the law
/// is written on another scale.
std::set<std::string> keys_expected(const SheetParameter& parameter) {
    const std::string law = std::string(parameter.table) + "." + std::string(parameter.key);
    switch (parameter.use) {
        case SheetUse::coefficient:
            return {law + (parameter.name.ends_with('A')   ? ".curvature"
                           : parameter.name.ends_with('B') ? ".slope"
                                                           : ".value")};
        case SheetUse::scale:  // the parabola is written about 0 degC either way; its curvature is the same
            // The conductivity of the sheet is negative at -40 degC and held below 20 degC; in kelvin it is positive.
            return parameter.key == "conductivity"
                       ? std::set<std::string>{law + ".value", law + ".slope", law + ".range"}
                       : std::set<std::string>{law + ".value", law + ".slope"};
        case SheetUse::sensor:
            return {"sensor.name", "sensor.kind"};
        default:
            return {parameter.path()};
    }
}

}  // namespace

TEST(SheetPlaces, EveryNameOfTheListInV7IsKnown) {
    std::size_t names = 0;
    for (const auto& [sheet, list] : list_of_V7) {
        for (const std::string& name : list) {
            EXPECT_NE(find_sheet_parameter(sheet, name), nullptr) << sheet << ": " << name;
            ++names;
        }
    }
    for (const auto& [sheet, variable, value] : vectors_of_V7) {
        EXPECT_TRUE(std::ranges::any_of(sheet_tables(),
                                        [&](const SheetTable& table) {
                                            return table.sheet == sheet &&
                                                   is_called(variable, table.variable, table.variable_aliases) &&
                                                   is_called(value, table.value, table.value_aliases);
                                        }))
            << sheet << ": " << value;
        names += 2;
    }
    EXPECT_EQ(names + 1, 57U);  // and the temperatures of the lateral stiffness: a heading of its table
}

TEST(SheetPlaces, ChangingOneParameterChangesItsKeyAndNoOther) {
    const Texts base = sheets::complete();
    const SheetCase before = sheets::convert(base);
    ASSERT_TRUE(before.errors.empty()) << sheets::report(before);
    std::size_t tried = 0;
    for (const SheetParameter& parameter : sheet_parameters()) {
        const auto& values = sheets::values(parameter.sheet);
        const auto value = values.find(std::string(parameter.name));
        if (value == values.end()) {
            EXPECT_TRUE(parameter.use == SheetUse::computed || parameter.use == SheetUse::none ||
                        parameter.sheet == "LateralStiffness")
                << parameter.name;
            continue;
        }
        Texts texts = base;
        sheets::replace(texts[std::string(parameter.sheet)], sheets::row(value->first, value->second),
                        sheets::row(value->first, {other(value->second.first), value->second.second}));
        const SheetCase after = sheets::convert(texts);
        ASSERT_TRUE(after.errors.empty()) << parameter.name << "\n" << sheets::report(after);
        EXPECT_EQ(sheets::changed_keys(before.text, after.text), keys_expected(parameter)) << parameter.name;
        ++tried;
    }
    EXPECT_EQ(tried, 65U);  // 73 less five computed, one without a place and two that stand for others
}

TEST(SheetPlaces, EveryParameterIsListedWithTheKeyThatItChanges) {
    const SheetCase made = sheets::convert(sheets::complete());
    EXPECT_EQ(made.mapped.size(), 65U);
    const auto keys = sheets::keys_of(made.text);
    for (const SheetMapped& mapped : made.mapped) {
        const bool block = mapped.key == "sensor.cornering_stiffness";
        EXPECT_TRUE(keys.contains(block ? "sensor.kind" : mapped.key)) << mapped.key;
    }
    // What is assumed is what no sheet holds: load, speed, duration, interval, two sensors and free rolling.
    EXPECT_EQ(made.missing.size(), 7U);
    EXPECT_TRUE(made.unmapped.empty());
}

TEST(SheetPlaces, RateAndShiftOfTheModulusTakeThePlaceOfThoseOfTheCompound) {
    Texts texts = sheets::complete();
    const SheetCase before = sheets::convert(texts);
    texts["LateralStiffness"] += "Modulus slope due to bulk temperature,0.04,1/K\n";
    const SheetCase rate = sheets::convert(texts);
    ASSERT_TRUE(rate.errors.empty()) << sheets::report(rate);
    EXPECT_EQ(sheets::changed_keys(before.text, rate.text), std::set<std::string>{"tire.modulus.transition_width"});
    // (71): a = -2 ln(0.003)/dT, so dT = 2 * 5.809143/0.04 K = 290.457 K.
    EXPECT_NEAR(sheets::read(rate).handling.modulus.dT, 290.45715, 1e-4);
    texts["LateralStiffness"] += "Horizontal shift due to bulk temperature,-5,degC\n";
    const SheetCase shift = sheets::convert(texts);
    EXPECT_EQ(sheets::changed_keys(rate.text, shift.text),
              std::set<std::string>{"tire.modulus.transition_temperature"});
    ASSERT_EQ(shift.unmapped.size(), 2U);
    EXPECT_EQ(shift.unmapped[0].parameter, "Tand peak Temperature");
    EXPECT_EQ(shift.unmapped[1].parameter, "Glassy-Rubbery transition range");
}

TEST(SheetPlaces, MeasuredTableTakesThePlaceOfALawThatIsLeftOut) {
    const std::vector<std::array<std::string, 5>> tables{
        {"THRCOND", "Thermal", "Temperature [degC],Thermal Conductivity [W/mK]\n20,0.29\n90,0.95\n", "0.95",
         "material.conductivity.rows"},
        {"SPEHEAT", "Specific", "Temperature [degC],Specific heat [J/kgK]\n20,1700\n90,1950\n", "1950",
         "material.heat_capacity.rows"},
        {"ContactPatch", "Contact Length", "Vertical Load [N],Contact Length [mm]\n2000,55\n6000,124\n", "124",
         "tire.contact_length.rows"},
        {"ContactPatch", "Contact Patch", "Vertical Load [N],Contact Patch [mm2]\n2000,4700\n6000,14000\n", "14000",
         "tire.contact_area.rows"},
        {"Radius", "Loaded", "Vertical Load [N],Loaded Radius [m]\n2000,0.310\n6000,0.291\n", "0.291",
         "tire.loaded_radius.rows"},
        {"Radius", "Rolling", "Vertical Load [N],Rolling Radius [m]\n2000,0.314\n6000,0.312\n", "0.312",
         "tire.rolling_radius.rows"}};
    for (const auto& [sheet, law, table, value, key] : tables) {
        Texts texts = sheets::complete();
        sheets::drop(texts[sheet], law);
        sheets::drop(texts[sheet], "Temperature scale");
        texts[sheet] += "\n" + table;
        const SheetCase before = sheets::convert(texts);
        ASSERT_TRUE(before.errors.empty()) << sheets::report(before);
        EXPECT_EQ(before.missing.size(), 7U) << key;
        sheets::replace(texts[sheet], "," + value + "\n", "," + other(value) + "\n");
        EXPECT_EQ(sheets::changed_keys(before.text, sheets::convert(texts).text), std::set<std::string>{key});
        (void)sheets::read(before);
    }
}

// Beside a law a table is for comparison, as in the thesis (V.4.7). l(4 kN) = 150 - 300/(1 + exp(1.44)) = 92.54 mm.
TEST(SheetPlaces, MeasuredTableBesideALawIsHeldAgainstIt) {
    Texts texts = sheets::complete();
    const SheetCase before = sheets::convert(texts);
    texts["ContactPatch"] += "\nVertical Load [N],Contact Length [mm]\n4000,120\n";
    texts["LateralStiffness"] += "\nVertical Load [N],Temperature [degC],Lateral Stiffness [N/rad]\n4000,70,1e5\n";
    const SheetCase after = sheets::convert(texts);
    ASSERT_TRUE(after.errors.empty()) << sheets::report(after);
    EXPECT_TRUE(sheets::changed_keys(before.text, after.text).empty());
    ASSERT_EQ(after.unmapped.size(), 2U);
    EXPECT_EQ(after.unmapped[0].reason,
              "the law of the same sheet is used; furthest off at 4000 N: measured 120 mm, law 92.54 mm");
    const solver::Problem problem = sheets::read(after);
    const double CP = 1.05 * physics::cornering_stiffness(problem.handling.modulus, problem.tire, 4000.0, 343.15).value;
    EXPECT_NE(after.unmapped[1].reason.find(fmt::format("law {:.4g} N/rad", CP)), std::string::npos)
        << after.unmapped[1].reason;
}

// 1150 kg/m3 * 2 pi 0.317 m * 0.210 m * 13 mm = 6.2532 kg, 12 % of it in the surface: 0.75038 and 5.5028 kg.
TEST(SheetPlaces, WhatTheProgramComputesIsHeldAgainstTheSheet) {
    Texts texts = sheets::complete();
    const SheetCase before = sheets::convert(texts);
    texts["PARA"] +=
        "Surface Mass,0.75038,kg\nBulk Mass,5.7779,kg\nArea Ratio,0.18,-\n"
        "Characteristic Length,157.75,mm\nExternal Total Area,0.41827,m2\n";
    const SheetCase after = sheets::convert(texts);
    ASSERT_TRUE(after.errors.empty()) << sheets::report(after);
    EXPECT_TRUE(sheets::changed_keys(before.text, after.text).empty());
    ASSERT_EQ(after.unmapped.size(), 5U);
    EXPECT_EQ(after.unmapped[0].reason, "computed by the program: 0.75038 kg, as in the sheet");
    EXPECT_EQ(after.unmapped[1].reason,
              "computed by the program: 5.5028 kg; that of the sheet is +5 % off and not used");
    // 1/(1/0.634 + 1/0.210) = 0.15775 m
    EXPECT_EQ(after.unmapped[3].reason, "computed by the program: 0.15775 m, as in the sheet");
    EXPECT_EQ(after.unmapped[4].reason, "computed by the program: 0.41827 m2, as in the sheet");
}

TEST(SheetPlaces, PageOfTheSheetsNamesEveryParameterWithItsKey) {
    const std::string page = expected::text_of(source_folder() / "cases" / "convert" / "README.md");
    for (const SheetParameter& parameter : sheet_parameters()) {
        const std::size_t at = page.find(fmt::format("| {}", parameter.name));
        ASSERT_NE(at, std::string::npos) << parameter.name;
        if (!parameter.path().empty() && parameter.use != SheetUse::sensor) {
            bool found = false;  // SPEHEAT and THRCOND share a name
            for (std::size_t row = at; row != std::string::npos;
                 row = page.find(fmt::format("| {}", parameter.name), row + 1)) {
                const std::string line = page.substr(row, page.find('\n', row) - row);
                found = found || line.find("`" + parameter.path()) != std::string::npos;
            }
            EXPECT_TRUE(found) << parameter.name << " " << parameter.path();
        }
    }
}

}  // namespace tiretherm::input
