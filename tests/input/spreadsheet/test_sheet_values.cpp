// SPDX-License-Identifier: BSD-3-Clause
// Values of the spreadsheet arrive in the run in SI, the same from CSV, .xls and .xlsx.

#include <algorithm>

#include <gtest/gtest.h>

#include "input/spreadsheet/sheets.hpp"
#include "solver/time_integration/march.hpp"

// What stands in the sheets arrives in the run, from each of the three formats.
namespace tiretherm::input {

namespace {

constexpr double zero = 273.15;

std::filesystem::path example_sheet(const std::string& ending) {
    return source_folder() / "cases" / "convert" / ("thesis_225_50_R17" + ending);
}

/// A number of an effect by its key.
double number(const solver::Problem& problem, std::string_view id, std::string_view key) {
    for (const physics::ActiveEffect& active : problem.effects) {
        for (std::size_t i = 0; active.effect->id == id && i < active.effect->parameters.size(); ++i) {
            if (active.effect->parameters[i].key == key) {
                return active[i];
            }
        }
    }
    ADD_FAILURE() << id << "." << key;
    return 0.0;
}

bool has_effect(const solver::Problem& problem, std::string_view id) {
    return std::ranges::any_of(problem.effects,
                               [&](const physics::ActiveEffect& active) { return active.effect->id == id; });
}

/// Final temperatures of surface and bulk. K
std::vector<double> run(const std::filesystem::path& file) {
    const Reading reading = read_case(file);
    EXPECT_TRUE(reading.problem) << render(reading);
    if (!reading.problem) {
        return {};
    }
    const solver::Report report = solver::run(*reading.problem, [](const solver::Snapshot&) { return true; });
    EXPECT_TRUE(report.status.ok()) << report.status.message;
    return {report.channel_final[0], report.channel_final[1]};
}

}  // namespace

// The numbers of sheets::values() in SI: each beside the one that was written.
TEST(SheetValues, EveryParameterArrivesInTheRun) {
    const SheetCase made = sheets::convert(sheets::switched_on());
    ASSERT_TRUE(made.errors.empty()) << sheets::report(made);
    const solver::Problem problem = sheets::read(made);
    const physics::Tire& tire = problem.tire;
    EXPECT_EQ(problem.title, "Winter tire");
    EXPECT_EQ(tire.name, "205/55 R16");
    ASSERT_EQ(problem.initial.size(), 2U);
    EXPECT_DOUBLE_EQ(problem.initial[0], zero + 38.0);
    EXPECT_DOUBLE_EQ(problem.initial[1], zero + 43.0);
    const physics::Inputs inputs = problem.input_signals.at(0.0, solver::JumpSide::after);
    EXPECT_DOUBLE_EQ(inputs.air_temperature, zero + 21.0);
    EXPECT_DOUBLE_EQ(inputs.road_temperature, zero + 27.0);
    EXPECT_DOUBLE_EQ(tire.minimum_load, 100.0);
    EXPECT_DOUBLE_EQ(tire.unloaded_radius, 0.317);
    EXPECT_DOUBLE_EQ(tire.tread_thickness, 0.013);
    EXPECT_DOUBLE_EQ(tire.sidewall_thickness, 0.008);
    EXPECT_NEAR(problem.mesh.volume[0] / (problem.mesh.volume[0] + problem.mesh.volume[1]), 0.12, 1e-15);
    EXPECT_DOUBLE_EQ(problem.mesh.links[0].length, 0.009);
    EXPECT_DOUBLE_EQ(number(problem, "air_convection", "floor"), 25.0);
    EXPECT_DOUBLE_EQ(number(problem, "road_contact", "Hc"), 450.0);
    EXPECT_DOUBLE_EQ(problem.materials[0].density, 1150.0);
    EXPECT_DOUBLE_EQ(number(problem, "air_convection", "air_conductivity"), 0.026);
    EXPECT_DOUBLE_EQ(number(problem, "air_convection", "air_viscosity"), 1.6e-5);
    EXPECT_DOUBLE_EQ(number(problem, "sliding_friction", "partition"), 0.55);
    EXPECT_DOUBLE_EQ(tire.width, 0.210);
    EXPECT_DOUBLE_EQ(tire.section_height, 0.111);
    EXPECT_DOUBLE_EQ(number(problem, "sliding_friction", "lambda_x"), 1.01);
    EXPECT_DOUBLE_EQ(number(problem, "sliding_friction", "lambda_y"), 1.02);
    EXPECT_DOUBLE_EQ(number(problem, "air_convection", "lambda_h"), 1.03);
    EXPECT_DOUBLE_EQ(number(problem, "road_contact", "lambda_Hc"), 1.04);
    EXPECT_DOUBLE_EQ(problem.handling.lambda_CP, 1.05);
    EXPECT_DOUBLE_EQ(number(problem, "strain_energy_loss", "lambda_srf"), 1.06);
    EXPECT_DOUBLE_EQ(number(problem, "strain_energy_loss", "lambda_blk"), 1.07);
    EXPECT_DOUBLE_EQ(number(problem, "strain_energy_loss", "f0"), 50.0);
    EXPECT_DOUBLE_EQ(number(problem, "strain_energy_loss", "C1"), -8.8);
    EXPECT_DOUBLE_EQ(number(problem, "strain_energy_loss", "C2"), 101.0);
    EXPECT_DOUBLE_EQ(number(problem, "strain_energy_loss", "tan_delta_a"), 2.1e15);
    EXPECT_DOUBLE_EQ(number(problem, "strain_energy_loss", "tan_delta_b"), -4980.0);
    EXPECT_DOUBLE_EQ(number(problem, "strain_energy_loss", "tan_delta_c"), 880.0);
    EXPECT_DOUBLE_EQ(problem.handling.modulus.T_g, zero - 10.0);
    EXPECT_DOUBLE_EQ(problem.handling.modulus.dT, 290.0);
    EXPECT_DOUBLE_EQ(problem.handling.modulus.E_max, 320e6);
    EXPECT_DOUBLE_EQ(problem.handling.modulus.dE, 300e6);
    EXPECT_DOUBLE_EQ(problem.handling.modulus.slope, -52.0);
    EXPECT_DOUBLE_EQ(problem.handling.modulus.l_t, 0.051);
    EXPECT_DOUBLE_EQ(problem.handling.modulus.dE_T, 1120e6);
    EXPECT_DOUBLE_EQ(problem.handling.modulus.E_mid, 600e6);
    EXPECT_DOUBLE_EQ(tire.contact_length_limit, 0.150);
    EXPECT_DOUBLE_EQ(tire.contact_length_slope, 0.36);
    EXPECT_DOUBLE_EQ(tire.contact_area_slope, 2.3e-6);
    EXPECT_DOUBLE_EQ(tire.contact_area_at_zero, 40e-6);
    EXPECT_DOUBLE_EQ(tire.loaded_radius_slope, -4.3e-6);
    EXPECT_DOUBLE_EQ(tire.loaded_radius_at_zero, 0.314);
    EXPECT_DOUBLE_EQ(tire.rolling_radius_factor, 0.333);
    EXPECT_DOUBLE_EQ(tire.rolling_radius_exponent, -0.008);
    EXPECT_EQ(problem.channels.size(), 3U);
    // k and c at 50 degC: 1e-5 2500 + 0.008 50 + 0.12 = 0.545 W/mK and 0.01 2500 + 2 50 + 1700 = 1825 J/kgK.
    EXPECT_NEAR(problem.link_laws[0].value(zero + 50.0), 0.545, 1e-13);
    EXPECT_NEAR(problem.materials[0].heat_capacity.value(zero + 50.0), 1825.0, 1e-9);
    for (const std::string_view id :
         {"sliding_friction", "air_convection", "road_contact", "strain_energy_loss", "conduction"}) {
        EXPECT_TRUE(has_effect(problem, id)) << id;
    }
}

TEST(SheetValues, SwitchesTakeTheirEffectsAway) {
    const solver::Problem problem = sheets::read(sheets::convert(sheets::complete()));
    EXPECT_TRUE(problem.effects.empty());
    sheets::Texts texts = sheets::switched_on();
    sheets::replace(texts["SWITCH"], "Lateral Friction Power,ON", "Lateral Friction Power,0");
    const solver::Problem one = sheets::read(sheets::convert(texts));
    const auto friction = std::ranges::find_if(
        one.effects, [](const physics::ActiveEffect& active) { return active.effect->id == "sliding_friction"; });
    ASSERT_NE(friction, one.effects.end());
    EXPECT_EQ(friction->choices[0], 0U);
    EXPECT_EQ(friction->choices[1], 1U);
}

// A T^2 + B T + C with T in kelvin is the parabola about 0 degC whose value there is C + B z + A z^2 and whose slope there
// is B + 2 A z, z = 273.15: B and C are chosen so that these are 0.008 W/mK/K and 0.12 W/mK, as in sheets::values().
TEST(SheetValues, LawInKelvinIsTheSameParabola) {
    sheets::Texts texts = sheets::complete();
    const double b = 0.008 - 2e-5 * zero;
    const double c = 0.12 - b * zero - 1e-5 * zero * zero;
    texts["THRCOND"] =
        fmt::format("Law,\nCoeff A,1e-5,W/mK3\nCoeff B,{},W/mK2\nCoeff C,{},W/mK\nTemperature scale,K,\n", b, c);
    const SheetCase made = sheets::convert(texts);
    ASSERT_TRUE(made.errors.empty()) << sheets::report(made);
    const solver::Problem problem = sheets::read(made);
    EXPECT_NEAR(problem.link_laws[0].value(zero + 30.0), 0.369, 1e-12);
    EXPECT_NEAR(problem.link_laws[0].value(zero + 50.0), 0.545, 1e-12);
    // -0.184 W/mK at -40 degC: it is held below 20 degC, where it has 0.284.
    EXPECT_NEAR(problem.link_laws[0].value(zero - 40.0), 0.284, 1e-12);
}

TEST(SheetValues, EachFormatGivesTheSameCase) {
    const SheetCase csv = convert_sheet(example_sheet(""));
    ASSERT_TRUE(csv.errors.empty()) << sheets::report(csv);
    EXPECT_EQ(csv.sheets.size(), 10U);
    for (const std::string ending : {".xls", ".xlsx"}) {
        const SheetCase made = convert_sheet(example_sheet(ending));
        ASSERT_TRUE(made.errors.empty()) << sheets::report(made);
        EXPECT_EQ(made.text, csv.text) << ending;
    }
}

TEST(SheetValues, SeparatorsByteOrderMarkAndBracketsDoNotMatter) {
    sheets::Texts texts = sheets::complete();
    const std::string before = sheets::convert(texts).text;
    for (auto& [sheet, text] : texts) {
        std::ranges::replace(text, ',', ';');
        text = "\xEF\xBB\xBF" + text;
        for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2) {
            text.insert(at, "\r");
        }
    }
    EXPECT_EQ(sheets::convert(texts).text, before);
}

// The example has the tire of cases/two_node; from the same start the last temperatures are the same: the laws of k and of
// the contact area differ by a rounding (0.1014 + 0.00943 T for 0.29 + 0.00943 (T - 20)), 1e-15 of them, which moves
// neither a step of the solver nor the temperatures by more than 1e-9 K.
TEST(SheetValues, ExampleRunsAsTheLibrarysTwoNodeTire) {
    const Written written;
    const std::filesystem::path made = written.add("example.toml", convert_sheet(example_sheet(".xlsx")).text);
    const std::filesystem::path same = written.add(
        "same.toml", "include = [\"example.toml\"]\n[initial]\nsurface = \"23 degC\"\nbulk = \"23 degC\"\n");
    const std::vector<double> library = run(source_folder() / "cases" / "two_node" / "4000N_100kmh.toml");
    const std::vector<double> converted = run(same);
    ASSERT_EQ(library.size(), 2U);
    ASSERT_EQ(converted.size(), 2U);
    EXPECT_NEAR(converted[0], library[0], 1e-9);
    EXPECT_NEAR(converted[1], library[1], 1e-9);
    // From 38 and 43 degC, as the thesis's picture shows: 9.4 kJ/K over a link of 30 W/K forget 20 K in an hour to 1e-3 K,
    // and the two runs step differently, to 0.01 K each.
    const std::vector<double> warm = run(made);
    EXPECT_NEAR(warm[0], library[0], 0.02);
    EXPECT_NEAR(warm[1], library[1], 0.02);
}

// A title alone leaves every sheet but INFO to the defaults, which are the thesis's tire: the library's case again.
TEST(SheetValues, DefaultsAreTheThesissTire) {
    sheets::Texts texts;
    for (const std::string_view sheet : sheet_names()) {
        texts[std::string(sheet)] = "A title\n";
    }
    texts["INFO"] += "Size,225/50 R17\n";
    texts["PARA"] += "Unloaded Radius,330.8,mm\n";
    const SheetCase made = sheets::convert(texts);
    ASSERT_TRUE(made.errors.empty()) << sheets::report(made);
    // 73 parameters less 2 given, 1 without a place, 7 that may be left out without a word (5 computed, width, height)
    // and 2 that stand for others; three coefficients and a scale of two laws are one entry each: 61 - 8 + 2, and 7 that no
    // sheet holds.
    EXPECT_EQ(made.missing.size(), 62U);
    for (const SheetMissing& missing : made.missing) {
        EXPECT_NE(made.text.find("#     " + missing.key), std::string::npos) << missing.key;
        EXPECT_FALSE(missing.reason.empty()) << missing.key;
    }
    const Written written;
    const std::vector<double> found = run(written.add("default.toml", made.text));
    const std::vector<double> library = run(source_folder() / "cases" / "two_node" / "4000N_100kmh.toml");
    EXPECT_NEAR(found[0], library[0], 1e-9);
    EXPECT_NEAR(found[1], library[1], 1e-9);
}

TEST(SheetValues, TireOfAnotherSizeIsWarnedOfTheLawsThatItBorrows) {
    sheets::Texts texts = sheets::switched_on();
    EXPECT_TRUE(sheets::convert(texts).warnings.empty());
    sheets::drop(texts["Radius"], "Rolling Radius Coeff A");
    const SheetCase made = sheets::convert(texts);
    ASSERT_EQ(made.warnings.size(), 1U);
    EXPECT_NE(
        made.warnings[0].find("tire: Rolling Radius Coeff A of the 205/55 R16 is taken from the thesis's 225/50 R17"),
        std::string::npos)
        << made.warnings[0];
    sheets::replace(texts["INFO"], "205/55 R16", "225/50 R17");
    EXPECT_TRUE(std::ranges::none_of(sheets::convert(texts).warnings,
                                     [](const std::string& warning) { return warning.find("taken from") < 200; }));
}

}  // namespace tiretherm::input
