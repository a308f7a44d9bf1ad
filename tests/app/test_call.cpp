// SPDX-License-Identifier: BSD-3-Clause
// Help, version, `check`, `effects` and wrong command lines: the printed words and the exit status.

#include <algorithm>
#include <regex>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "input/text/word_lists.hpp"
#include "physics/effect.hpp"
#include "tests/app/program.hpp"
#include "tests/input/measurements/measured_bench.hpp"

namespace tiretherm::app_test {
namespace {

using Json = nlohmann::json;

/// All commands of the program, in the order of its help.
const std::vector<std::string> commands{
#define COMMAND(name, example) #name,
#include "app/commands.list"
#undef COMMAND
};

TEST(Call, HelpOfTheProgramAndOfEachCommandHasAnExample) {
    for (const std::string& command : commands) {
        const Call help = call(command + " --help");
        EXPECT_EQ(help.exit_code, 0) << command;
        EXPECT_EQ(help.err, "");
        EXPECT_NE(help.out.find("Example"), std::string::npos) << command;
        EXPECT_NE(help.out.find("  tiretherm " + command), std::string::npos) << command;
    }
    const Call program = call("--help");
    EXPECT_EQ(program.exit_code, 0);
    EXPECT_EQ(program.err, "");
    const std::size_t examples = program.out.find("\nExamples:\n");
    ASSERT_NE(examples, std::string::npos) << program.out;
    for (const std::string& command : commands) {
        EXPECT_NE(program.out.find("\n  tiretherm " + command, examples), std::string::npos) << program.out;
    }
}

TEST(Call, HelpOfRunSaysWhatIsOverwritten) {
    // The help breaks its lines where the column ends.
    const std::string help = std::regex_replace(call("run --help").out, std::regex("\\s+"), " ");
    EXPECT_NE(help.find("files of an earlier run there are replaced"), std::string::npos) << help;
    EXPECT_NE(help.find("out/<case name>"), std::string::npos) << help;
}

TEST(Call, VersionIsOneLine) {
    const Call version = call("--version");
    EXPECT_EQ(version.exit_code, 0);
    EXPECT_TRUE(version.out.starts_with("tiretherm 0.")) << version.out;
    EXPECT_EQ(version.out.find('\n'), version.out.size() - 1);
}

TEST(Call, CommandsAreListedOneALineForScripts) {
    const Call answer = call("--commands");
    EXPECT_EQ(answer.exit_code, 0);
    EXPECT_EQ(answer.err, "");
    EXPECT_TRUE(answer.out.starts_with("run\ncheck\ncompare\n")) << answer.out;
    // As many as the program itself lists where one is missing: "the commands are run, check, ... and convert".
    const std::string listed = call("").err;
    const auto separators = std::count(listed.begin(), listed.end(), ',') + 1;
    EXPECT_EQ(std::count(answer.out.begin(), answer.out.end(), '\n'), separators + 1) << answer.out << listed;
    EXPECT_EQ(call("--help").out.find("--commands"), std::string::npos);
}

TEST(Call, UnknownCommandIsAnsweredWithTheNearestOne) {
    const Call wrong = call("chekc " + two_node);
    EXPECT_EQ(wrong.exit_code, 1);
    EXPECT_EQ(wrong.out, "");
    EXPECT_EQ(wrong.err, "tiretherm: there is no command \"chekc\"; did you mean `check`?\n");
    EXPECT_EQ(call("rum --json").exit_code, 1);
    EXPECT_EQ(Json::parse(call("rum --json").out)["error"], "there is no command \"rum\"; did you mean `run`?");
}

TEST(Call, TheConverterOfWorkbooksIsNamedWhereItIsLookedFor) {
    for (const std::string command : {"convert tire.xlsx --out o", "import tire.xls"}) {
        const Call sent = call(command);
        EXPECT_EQ(sent.exit_code, 1);
        EXPECT_EQ(sent.out, "");
        EXPECT_EQ(sent.err,
                  fmt::format("tiretherm: there is no command \"{}\"; the converter of workbooks is a script: "
                              "tools/spreadsheet_to_case.py WORKBOOK --out DIR\n",
                              command.substr(0, command.find(' '))));
    }
}

TEST(Call, UnknownOptionIsAnsweredWithTheNearestOne) {
    const Call wrong = call("run " + two_node + " --ouput x");
    EXPECT_EQ(wrong.exit_code, 1);
    EXPECT_EQ(wrong.err, "tiretherm: there is no option \"--ouput\"; did you mean `--out`?\n");
}

TEST(Call, SecondCaseIsRefused) {
    const Call wrong = call("run " + two_node + " other.toml");
    EXPECT_EQ(wrong.exit_code, 1);
    EXPECT_EQ(wrong.err, "tiretherm: one argument too many: \"other.toml\"; see tiretherm run --help\n");
}

TEST(Call, MissingCaseAndMissingCommandAreErrors) {
    EXPECT_EQ(call("run").exit_code, 1);
    EXPECT_EQ(call("run").err, "tiretherm: CASE is required; see tiretherm run --help\n");
    EXPECT_EQ(call("").exit_code, 1);
    EXPECT_EQ(call("").err, fmt::format("tiretherm: no command; the commands are {}; see tiretherm --help\n",
                                        input::listed(commands)));
}

TEST(Check, SoundCaseIsToldInAFewLines) {
    const Call check = call("check " + two_node);
    EXPECT_EQ(check.exit_code, 0);
    EXPECT_EQ(check.err, "");
    EXPECT_TRUE(check.out.starts_with("two_node/4000N_100kmh: no errors\n")) << check.out;
    EXPECT_NE(check.out.find("nothing was simulated: the errors of grid and time steps are not known"),
              std::string::npos)
        << check.out;
    EXPECT_NE(check.out.find("channels  surface_temperature, bulk_temperature\n"), std::string::npos) << check.out;
    // 0.785569 at the peak (Compound.KnowsTheLargestLossTangent)
    EXPECT_NE(check.out.find("loss      tan delta at most 0.786 at -8 degC and 52 Hz\n"), std::string::npos)
        << check.out;
    const Json json = Json::parse(call("check --json " + two_node).out);
    EXPECT_NEAR(json["tire"]["loss_tangent_peaks"][0]["value"], 0.785569, 1e-6);
    EXPECT_EQ(json["errors"], Json::array());
    EXPECT_EQ(json["cells"], 2);
}

TEST(Check, SaysWhatCordsAndRubberMake) {
    // By hand in the head of the case: V = 0.112957, k2 = 0.312957, k1 sin^2 + k2 cos^2 = 1.09272, 5.08983 W/mK;
    // E1 = V 200 GPa + (1 - V) 10 MPa = 22.6002 GPa, E2 = 10 MPa (1 + 2 V)/(1 - V) = 13.8202 MPa. At 22 degrees with
    // s^2 c^2 = 0.120638, G12 = 3.33333 MPa (1 + V)/(1 - V) = 4.1822 MPa (to 1e-4): 1/E = 0.120638/4.1822 + 0.019693/13.8202
    // + 0.000033 - 0.000005 = 0.030299 1/MPa: 33.0 MPa.
    const std::string cords = TIRETHERM_SOURCE_DIR "/cases/section/4000N_100kmh_cords.toml";
    const Call check = call("check " + cords);
    for (const char* line :
         {"plies     steel belt: 11.3 % cords; at 20 degC 0.313 W/mK through, 1.09 along the meridian, 5.09 around the "
          "circumference\n",
          "            one ply 22.6 GPa along its cords, 13.8 MPa across, G12 4.18 MPa, nu12 0.477\n",
          "            one ply 33 MPa around the circumference, "}) {
        EXPECT_NE(check.out.find(line), std::string::npos) << check.out;
    }
    const Json json = Json::parse(call("check --json " + cords).out);
    ASSERT_EQ(json["plies"].size(), 2U);
    EXPECT_EQ(json["plies"][1]["material"], "textile carcass");
    EXPECT_NEAR(json["plies"][1]["conductivity_meridian"].get<double>(), 0.463825, 1e-6);
    EXPECT_NEAR(json["plies"][0]["modulus_along"].get<double>(), 22.6002e9, 1e5);
}

TEST(Check, RunsNothing) {
    const sample::Scratch scratch;
    EXPECT_EQ(call("check " + two_node, scratch.path()).exit_code, 0);
    EXPECT_TRUE(std::filesystem::is_empty(scratch.path()));
}

// A logger that was paused for a minute, in the log of the case's own run: `check` needs no --data to say so, once. Of the shipped cars
// nothing is wrong.
TEST(Check, WhatLooksWrongInTheCasesOwnDataIsToldOnce) {
    const input::Written written;
    std::string log =
        "time [s],speed [km/h],vertical_load [N],air_temperature [degC],road_temperature [degC],"
        "surface_temperature [degC]\n";
    for (int i = 0; i < 60; ++i) {
        log += fmt::format("{},72,4000,20,25,{:.2f}\n", i < 30 ? 2 * i : 2 * i + 60, 25.0 + 0.13 * i);
    }
    written.add("run.csv", log);
    written.add("case.toml", std::string(input::bench) + "[[run]]\nfile = \"run.csv\"\n");
    const Call check = call("check case.toml", written.folder());
    EXPECT_EQ(check.exit_code, 0) << check.err;
    const std::string jump = "run.csv: time jumps by 62 s after 58 s";
    const std::size_t first = check.out.find(jump);
    ASSERT_NE(first, std::string::npos) << check.out;
    EXPECT_EQ(check.out.find(jump, first + 1), std::string::npos) << check.out;
    const Json json = Json::parse(call("check --json case.toml", written.folder()).out);
    EXPECT_EQ(json["warnings"].size(), 1U) << json["warnings"];
    for (const char* car : {"session.toml", "wheels.toml"}) {
        const Call sound = call(std::string("check " TIRETHERM_SOURCE_DIR "/cases/car/") + car);
        for (const char* word : {"exchanged", "outlier", "jumps"}) {
            EXPECT_EQ(sound.out.find(word), std::string::npos) << sound.out;
        }
    }
}

TEST(Check, CaseWithErrorsCannotBeRun) {
    const Call check = call("check many_errors.toml", TIRETHERM_SOURCE_DIR "/tests/bad_cases");
    EXPECT_EQ(check.exit_code, 1);
    EXPECT_NE(check.err.find("many_errors.toml:"), std::string::npos);
    EXPECT_NE(check.err.find(" errors; the case cannot be run; with measured runs beside it: check --data FILE\n"),
              std::string::npos)
        << check.err;
}

TEST(Inputs, AllAreListedWithUnitSignAndReaders) {
    const Call list = call("inputs");
    EXPECT_EQ(list.exit_code, 0);
    const Json json = Json::parse(call("inputs --json").out);
    ASSERT_EQ(json["inputs"].size(), physics::signals().size());
    const std::string page = call("inputs --markdown").out;
    for (std::size_t i = 0; i < physics::signals().size(); ++i) {
        const std::string name(physics::signals()[i].name);
        EXPECT_EQ(json["inputs"][i]["name"], name);
        EXPECT_FALSE(json["inputs"][i]["sign"].get<std::string>().empty()) << name;
        EXPECT_NE(list.out.find(name + " ("), std::string::npos) << name;
        EXPECT_NE(page.find("\n## " + name + "\n"), std::string::npos) << name;
    }
}

TEST(Inputs, OneNamesTheEffectsAndSensorsThatReadIt) {
    const Json camber = Json::parse(call("inputs camber --json").out);
    EXPECT_EQ(camber["used_by"], Json::array({"input_delay", "camber_asymmetry", "pressure_across_tread"}));
    EXPECT_EQ(camber["sensors"],
              Json::array({"cornering_stiffness", "bulk_temperature_factor", "lateral_force", "reference_lateral_force",
                           "longitudinal_force", "contact_pressure_outside", "contact_pressure_middle",
                           "contact_pressure_inside", "peak_lateral_force"}));
    EXPECT_NE(call("inputs camber")
                  .out.find("Used where given by the effects: input_delay, camber_asymmetry, pressure_across_tread\n"),
              std::string::npos);
    const Call wrong = call("inputs cambr");
    EXPECT_EQ(wrong.exit_code, 1);
    EXPECT_NE(wrong.err.find("there is no input \"cambr\""), std::string::npos);
    EXPECT_NE(wrong.err.find("did you mean `camber`?"), std::string::npos) << wrong.err;
}

TEST(Effects, ListNamesTheWholeCatalogue) {
    const Call list = call("effects");
    EXPECT_EQ(list.exit_code, 0);
    const Json json = Json::parse(call("effects --json").out);
    ASSERT_EQ(json["effects"].size(), physics::catalogue().size());
    for (std::size_t i = 0; i < physics::catalogue().size(); ++i) {
        const std::string name(physics::catalogue()[i]->id);
        EXPECT_NE(list.out.find("\n" + name + " ("), list.out.starts_with(name + " (") ? 0 : std::string::npos) << name;
        EXPECT_EQ(json["effects"][i]["name"], name);
    }
}

TEST(Effects, OneIsToldWithEquationSourceAndBounds) {
    const physics::Effect& laser = *physics::find_effect("laser");
    const Call one = call("effects laser");
    EXPECT_EQ(one.exit_code, 0);
    EXPECT_NE(one.out.find(std::string(laser.equation)), std::string::npos) << one.out;
    EXPECT_NE(one.out.find(std::string(laser.source)), std::string::npos) << one.out;
    EXPECT_NE(one.out.find("absorptivity          1      0   1  -     share of the light that is absorbed"),
              std::string::npos)
        << one.out;
    const Json json = Json::parse(call("effects laser --json").out);
    EXPECT_EQ(json["parameters"][1]["key"], "absorptivity");
    EXPECT_EQ(json["parameters"][1]["default"], 1.0);
    EXPECT_EQ(json["parameters"][1]["low"], 0.0);
    EXPECT_EQ(json["parameters"][1]["high"], 1.0);
    EXPECT_EQ(json["parameters"][0]["unit"], "m");
}

// What a reader of the page learns, a program does: its table, what else it reads, what it needs; sidewalls or else the inside.
TEST(Effects, JsonSaysAllThatThePageSays) {
    const Json loss = Json::parse(call("effects strain_energy_loss --json").out);
    const std::string page = call("effects strain_energy_loss").out;
    EXPECT_EQ(loss["tables"][0]["key"], "profile");
    EXPECT_EQ(loss["may_read"][0], "inflation_pressure");
    EXPECT_EQ(loss["needs"], "a [tire]");
    for (const char* heading : {"\nTables\n", "\nAlso, when given\n", "\nNeeds\n"}) {
        EXPECT_NE(page.find(heading), std::string::npos) << heading << page;
    }
    EXPECT_EQ(Json::parse(call("effects sidewall_convection --json").out)["one_patch"], true);
    EXPECT_EQ(Json::parse(call("effects sensor_lag --json").out)["acts_on"],
              "the sensors that a case names: channels = [...]");
}

TEST(Effects, UnknownNameIsAnsweredWithTheNearestOne) {
    const Call wrong = call("effects lasr");
    EXPECT_EQ(wrong.exit_code, 1);
    EXPECT_EQ(wrong.err, "tiretherm: there is no effect \"lasr\"; did you mean `laser`?\n");
    EXPECT_EQ(Json::parse(call("effects lasr --json").out)["errors"], Json::array());
}

}  // namespace
}  // namespace tiretherm::app_test
