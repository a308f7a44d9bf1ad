// SPDX-License-Identifier: BSD-3-Clause
// Inputs given by an included file and by the case: a log in the place of a constant, a constant in the place of a log, and
// keys that are taken away; which run a case is read for; who reads an input.

#include <gtest/gtest.h>

#include "input/runs/reader.hpp"
#include "tests/input/measurements/measured_bench.hpp"

namespace tiretherm::input {
namespace {

const std::string hall =
    "time [s],speed [km/h],vertical_load [N],air_temperature [degC]\n0,36,4000,25\n10,36,4000,31\n";
const std::string constants = "[drive]\nair_temperature = \"20 degC\"\nroad_temperature = \"20 degC\"\n";
const std::string log_of_hall = "[[drive.file]]\npath = \"hall.csv\"\n";

/// Two files: the case and what it includes.
Reading included(const std::string& base, const std::string& own) {
    const Written written;
    written.add("hall.csv", hall);
    written.add("base.toml", std::string(bench) + base);
    return read_case(written.add("case.toml", "include = [\"base.toml\"]\n" + own));
}

double air(const Reading& reading, double t) {
    return reading.problem->input_signals.at(t, solver::JumpSide::before).air_temperature - 273.15;
}

}  // namespace

// The log says 25 degC at 0 s and 31 at 10 s, the included constant 20.
TEST(IncludedDrive, LogOfTheCaseWinsOverAnIncludedConstant) {
    const Reading reading = included(constants, log_of_hall);
    ASSERT_TRUE(reading.problem) << render(reading);
    EXPECT_NEAR(air(reading, 0.0), 25.0, 1e-9);
    EXPECT_NEAR(air(reading, 10.0), 31.0, 1e-9);
}

TEST(IncludedDrive, ScheduleOfTheCaseWinsOverAnIncludedConstant) {
    const Reading reading = included(
        constants + "speed = \"36 km/h\"\nvertical_load = \"4000 N\"\n",
        "[[drive.schedule]]\ncolumns = [\"time [s]\", \"air_temperature [degC]\"]\nrows = [[0, 40], [10, 50]]\n"
        "[time]\nend = \"10 s\"\n");
    ASSERT_TRUE(reading.problem) << render(reading);
    EXPECT_NEAR(air(reading, 5.0), 45.0, 1e-9);
}

TEST(IncludedDrive, ConstantOfTheCaseWinsOverAnIncludedLog) {
    const Reading reading = included(log_of_hall, constants);
    ASSERT_TRUE(reading.problem) << render(reading);
    EXPECT_NEAR(air(reading, 10.0), 20.0, 1e-9);
}

// Within one file nobody knows which is meant.
TEST(IncludedDrive, ConstantAndLogOfOneFileAreAMistake) {
    const Reading reading = included("", constants + log_of_hall);
    ASSERT_EQ(reading.errors.size(), 1U) << render(reading);
    EXPECT_TRUE(reading.errors[0].what.starts_with("air_temperature is given twice")) << reading.errors[0].what;
}

TEST(Unset, TakesKeysAwayFromIncludedFiles) {
    const std::string both =
        "[drive]\nspeed = \"72 km/h\"\n[[drive.schedule]]\ncolumns = [\"time [s]\", \"air_temperature "
        "[degC]\"]\nrows = [[0, 40], [10, 50]]\n";
    const Reading reading = included(
        both, "unset = [\"drive.schedule\"]\n" + constants + "vertical_load = \"4000 N\"\n[time]\nend = \"10 s\"\n");
    ASSERT_TRUE(reading.problem) << render(reading);
    EXPECT_NEAR(air(reading, 5.0), 20.0, 1e-9);
    EXPECT_NEAR(reading.problem->input_signals.at(5.0, solver::JumpSide::before).speed, 20.0, 1e-9);
}

TEST(Unset, KeyThatNoIncludedFileHasIsAMistake) {
    const Reading typed = included(constants, "unset = [\"drive.air_temprature\"]\n" + log_of_hall);
    ASSERT_EQ(typed.errors.size(), 1U) << render(typed);
    EXPECT_EQ(typed.errors[0].what, "unset: no included file has \"drive.air_temprature\"");
    EXPECT_EQ(typed.errors[0].remedy, "did you mean `air_temperature`?");
    EXPECT_EQ(included(constants, "unset = 3\n" + log_of_hall).errors.at(0).what,
              "unset is 3; a list of keys is wanted");
    EXPECT_EQ(included(constants, "unset = [\"mesh.kind.x.y\", \"\", \".\"]\n" + log_of_hall).errors.size(), 3U);
    const Written written;
    EXPECT_NE(render(read_case(written.add("alone.toml", "unset = [\"drive\"]\n" + std::string(bench))))
                  .find("unset takes keys away from included files, and this file includes none"),
              std::string::npos);
}

// camber moves the side force of the Magic Formula (4.9 of MF 5.2): it is used, though no heat follows it.
TEST(UnreadInputs, SensorOfTheMagicFormulaReadsTheCamber) {
    const std::string drive =
        "[drive]\nspeed = \"36 km/h\"\nvertical_load = \"4000 N\"\nair_temperature = \"20 degC\"\n"
        "road_temperature = \"20 degC\"\nslip_angle = \"1 deg\"\ncamber = \"2 deg\"\n[time]\nend = "
        "\"10 s\"\n";
    const Reading without = included(drive, "");
    ASSERT_TRUE(without.problem) << render(without);
    EXPECT_NE(render(without).find("no active effect and no sensor uses camber"), std::string::npos) << render(without);
    const Reading with = included(drive, "[tire]\nproperty_file = \"" TIRETHERM_SOURCE_DIR
                                         "/tests/input/data/made_up.tir\"\n[[sensor]]\nname = \"side\"\nkind = "
                                         "\"lateral_force\"\n");
    ASSERT_TRUE(with.problem) << render(with);
    EXPECT_EQ(render(with).find("uses camber"), std::string::npos) << render(with);
}

TEST(RunOfACase, IsChosenByItsName) {
    const std::string runs =
        "[drive]\nvertical_load = \"4000 N\"\nair_temperature = \"20 degC\"\nroad_temperature = \"20 "
        "degC\"\n[time]\nend = \"10 s\"\n[[run]]\nname = \"slow\"\ndrive = { speed = \"36 km/h\" }\n"
        "measured = [{ channel = \"bulk_temperature\", value = \"30 degC\", uncertainty = \"1 K\" }]\n"
        "[[run]]\nname = \"fast\"\ndrive = { speed = \"72 km/h\" }\n"
        "measured = [{ channel = \"bulk_temperature\", value = \"30 degC\", uncertainty = \"1 K\" }]\n";
    const Written written;
    const std::filesystem::path file = written.add("case.toml", std::string(bench) + runs);
    const auto speed = [](const Reading& reading) {
        return reading.problem->input_signals.at(5.0, solver::JumpSide::before).speed;
    };
    const Reading first = read_case(file);
    ASSERT_TRUE(first.problem) << render(first);
    EXPECT_EQ(first.runs, (std::vector<std::string>{"slow", "fast"}));
    EXPECT_EQ(first.run, "slow");
    EXPECT_NEAR(speed(first), 10.0, 1e-9);
    const Reading second = read_case_run(file, "fast");
    ASSERT_TRUE(second.problem) << render(second);
    EXPECT_EQ(second.run, "fast");
    EXPECT_NEAR(speed(second), 20.0, 1e-9);
    const Reading none = read_case_run(file, "fats");
    ASSERT_EQ(none.errors.size(), 1U) << render(none);
    EXPECT_EQ(none.errors[0].what, "the case has no run \"fats\"");
    EXPECT_EQ(none.errors[0].remedy, "did you mean `fast`?");
}

}  // namespace tiretherm::input
