// SPDX-License-Identifier: BSD-3-Clause
// `help` and its topics, and what is answered to the usual slips on the command line.

#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "input/model/sensors.hpp"
#include "input/text/units.hpp"
#include "physics/conventions.hpp"
#include "physics/signals.hpp"
#include "tests/app/program.hpp"

namespace tiretherm::app_test {
namespace {

const std::vector<std::string> topics{"cases", "inputs",     "signs", "units",   "sensors",
                                      "data",  "parameters", "noise", "verdicts"};

/// Words of a text, which may be broken into lines anywhere.
std::string unbroken(const std::string& text) {
    std::istringstream stream(text);
    std::string result;
    for (std::string word; stream >> word;) {
        result += word + " ";
    }
    return result;
}

TEST(Help, ListsTopicsAndCommands) {
    const Call list = call("help");
    EXPECT_EQ(list.exit_code, 0);
    for (const std::string& topic : topics) {
        EXPECT_NE(list.out.find("\n  " + topic + " "), std::string::npos) << topic;
    }
    std::istringstream commands(call("--commands").out);
    for (std::string command; commands >> command;) {
        EXPECT_NE(list.out.find("\n  " + command + " "), std::string::npos) << command;
    }
}

TEST(Help, OfACommandIsThatOfItsOption) {
    EXPECT_EQ(call("help run").out, call("run --help").out);
    EXPECT_EQ(call("help run").exit_code, 0);
}

TEST(Help, TopicsFitATerminalOf80Columns) {
    // Two screens of 40 lines at most; a page that is longer is not read.
    for (const std::string& topic : topics) {
        const Call page = call("help " + topic);
        EXPECT_EQ(page.exit_code, 0) << topic;
        std::istringstream lines(page.out);
        int n = 0;
        for (std::string line; std::getline(lines, line); ++n) {
            EXPECT_LE(line.size(), 80U) << topic << ": " << line;
        }
        EXPECT_GT(n, 10) << topic;
        EXPECT_LE(n, 80) << topic;
    }
}

TEST(Help, TopicsHaveEveryInputSignUnitAndSensor) {
    const std::string inputs = call("help inputs").out;
    const std::string signs = unbroken(call("help signs").out);
    for (const physics::Signal& signal : physics::signals()) {
        EXPECT_NE(inputs.find(fmt::format("  {} ", signal.name)), std::string::npos) << signal.name;
        const std::string sentence = unbroken(std::string(physics::sign_convention(signal)));
        EXPECT_NE(signs.find(fmt::format("{} {}", signal.name, sentence)), std::string::npos) << signal.name;
    }
    const std::string sensors = call("help sensors").out;
    for (const input::SensorKind& kind : input::sensor_kinds()) {
        EXPECT_NE(sensors.find(fmt::format("\n  {} ", kind.name)), std::string::npos) << kind.name;
    }
    const std::string units = call("help units").out;
    for (const input::Dimension& dimension : input::dimensions()) {
        EXPECT_TRUE(dimension.example.empty() || units.find(dimension.example) != std::string::npos) << dimension.name;
    }
    EXPECT_NE(units.find("kph"), std::string::npos);
}

TEST(Help, UsualUnitsAreUnitsOfTheirDimension) {
    // Each must be readable as what it stands beside: the example and the usual units have one signature.
    for (const input::Dimension& dimension : input::dimensions()) {
        std::istringstream units(dimension.units);
        for (std::string unit; units >> unit;) {
            const std::string example = dimension.example.substr(dimension.example.find(' ') + 1);
            const std::string wanted = dimension.name == "a pure number" ? "1" : example;
            EXPECT_TRUE(std::holds_alternative<input::Conversion>(
                input::conversion(unit, input::signature(wanted), input::Scale::absolute)))
                << dimension.name << ": " << unit;
        }
    }
}

TEST(Help, WrongTopicIsAnsweredWithTheNearestOne) {
    const Call wrong = call("help sgns");
    EXPECT_EQ(wrong.exit_code, 1);
    EXPECT_EQ(wrong.err, "tiretherm: there is no topic or command \"sgns\"; did you mean `signs`?\n");
}

TEST(Slips, WordOfAnotherProgramIsAnsweredWithOurs) {
    EXPECT_EQ(call("simulate a.toml").err, "tiretherm: there is no command \"simulate\"; did you mean `run`?\n");
    EXPECT_EQ(call("fit a.toml").err, "tiretherm: there is no command \"fit\"; did you mean `identify`?\n");
}

TEST(Slips, FileBeforeItsCommandIsNamed) {
    EXPECT_EQ(call("a.toml").err,
              "tiretherm: there is no command \"a.toml\"; a command comes first: tiretherm run a.toml\n");
    EXPECT_EQ(call("a.toml check").err,
              "tiretherm: \"a.toml\" stands before its command; write tiretherm check a.toml\n");
}

TEST(Slips, OptionWithoutItsValueSaysWhatIsWanted) {
    EXPECT_EQ(call("run a.toml --out").err, "tiretherm: --out needs a value: --out DIR; see tiretherm run --help\n");
}

TEST(Slips, CaseInAMisspeltFolderIsFound) {
    const sample::Scratch scratch;
    std::filesystem::create_directories(scratch / "cases/laser");
    std::ofstream(scratch / "cases/laser/one_watt.toml") << "title = \"x\"\n";
    const auto answer = [&](const std::string& path) { return call("check " + path, scratch.path()).err; };
    constexpr const char* remedy = "remedy: did you mean `cases/laser/one_watt.toml`?";
    EXPECT_NE(answer("cases/lazer/one_watt.toml").find(remedy), std::string::npos)
        << answer("cases/lazer/one_watt.toml");
    EXPECT_NE(answer("cases/laser/one_wat.toml").find(remedy), std::string::npos);
    EXPECT_NE(answer("cases/laser/one_watt").find(remedy), std::string::npos);
    EXPECT_NE(answer("case/lasr/on_watt.toml").find(remedy), std::string::npos);
    EXPECT_EQ(answer("other/one_watt.toml").find("remedy"), std::string::npos) << answer("other/one_watt.toml");
}

TEST(Slips, UnitThatIsNoneIsAnsweredWithTheNearestUsualOne) {
    const sample::Scratch scratch;
    std::ofstream(scratch / "a.toml") << "include = [\"" << two_node << "\"]\n[drive]\nspeed = \"100 kmh\"\n";
    const std::string said = call("check a.toml", scratch.path()).err;
    EXPECT_NE(said.find("\"kmh\" is not a unit"), std::string::npos) << said;
    EXPECT_NE(said.find("remedy: did you mean `km/h`?"), std::string::npos) << said;
}

}  // namespace
}  // namespace tiretherm::app_test
