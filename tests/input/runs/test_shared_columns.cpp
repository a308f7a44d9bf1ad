// SPDX-License-Identifier: BSD-3-Clause
// What [data] says once about the columns of all measured runs, what a run says over it, and names of units.

#include <gtest/gtest.h>

#include "input/measurements/measured_bench.hpp"

namespace tiretherm::input {

namespace {

/// A log in a logger's own words: temperatures in "C".
constexpr std::string_view logger =
    "t [s],V [km/h],Fz [N],Tair [C],Ttrack [C],IR spot [C],probe [C]\n"
    "0,36,4000,25,30,25.0,25.5\n"
    "2,54,4100,25,30,25.5,25.8\n"
    "5,72,4200,25,31,26.0,26.1\n";

constexpr std::string_view data =
    "[data]\n"
    "columns = { t = \"time\", V = \"speed\", Fz = \"vertical_load\", Tair = \"air_temperature\", Ttrack = "
    "\"road_temperature\", \"IR spot\" = \"surface_temperature\", probe = \"bulk_temperature\" }\n"
    "unit_names = { C = \"degC\" }\n";

/// The bench with two files of the logger, and these tables.
ExperimentReading read_car(const Written& written, const std::string& tables, std::string_view second = logger) {
    written.add("a.csv", logger);
    written.add("b.csv", second);
    return read_experiment(written.add("case.toml", std::string(bench) + tables));
}

const std::string two_runs = "[[run]]\nfile = \"a.csv\"\n[[run]]\nfile = \"b.csv\"\n";

std::string said(const ExperimentReading& reading, const Written& written) {
    return replaced(error_report(reading), written.folder().generic_string() + "/", "");
}

double speed_at(const MeasuredRun& run, double time) {
    return run.problem.input_signals.at(time, solver::JumpSide::after).speed;
}

}  // namespace

// 25.5 degC are 298.65 K; 54 km/h are 15 m/s. Said once, it counts for both runs, and for a file beside the case.
TEST(SharedColumns, OfDataCountForAllRuns) {
    const Written written;
    const ExperimentReading reading = read_car(written, std::string(data) + two_runs);
    ASSERT_TRUE(reading.experiment) << said(reading, written);
    EXPECT_EQ(said(reading, written), "");
    ASSERT_EQ(reading.experiment->runs.size(), 2U);
    for (const MeasuredRun& run : reading.experiment->runs) {
        EXPECT_NEAR(speed_at(run, 2.0), 15.0, 1e-12);
        ASSERT_NE(find_series(run, "bulk_temperature"), nullptr);
        EXPECT_NEAR(find_series(run, "bulk_temperature")->value[0], 298.65, 1e-9);
    }
    const ExperimentReading beside = read_experiment(written.folder() / "case.toml", {written.folder() / "a.csv"});
    ASSERT_TRUE(beside.experiment) << said(beside, written);
    EXPECT_NEAR(speed_at(beside.experiment->runs.front(), 2.0), 15.0, 1e-12);
}

// The second run has its speed in a column of another name and in m/s, leaves out nothing and holds nothing.
TEST(SharedColumns, WhatARunSaysWins) {
    const Written written;
    const std::string shared =
        std::string(data) + "ignore = [\"probe\"]\nhold = [\"speed\"]\nunits = { V = \"m/s\" }\n";
    const std::string wide =
        "t [s],V [km/h],wheel,Fz [N],Tair [C],Ttrack [C],IR spot [C],probe [C]\n"
        "0,1,36,4000,25,30,25.0,25.5\n2,1,54,4100,25,30,25.5,25.8\n5,1,72,4200,25,31,26.0,26.1\n";
    const ExperimentReading both = read_car(
        written,
        shared +
            "[[run]]\nfile = \"a.csv\"\n[[run]]\nfile = \"b.csv\"\ncolumns = { wheel = \"speed\" }\nignore = []\n"
            "hold = []\nunits = { wheel = \"km/h\" }\n",
        wide);
    ASSERT_TRUE(both.experiment) << said(both, written);
    const MeasuredRun& first = both.experiment->runs[0];
    const MeasuredRun& second = both.experiment->runs[1];
    EXPECT_NEAR(speed_at(first, 1.0), 36.0, 1e-12);  // held, in m/s
    EXPECT_EQ(find_series(first, "bulk_temperature"), nullptr);
    EXPECT_NEAR(speed_at(second, 1.0), 12.5, 1e-12);  // straight from 10 to 15 m/s
    EXPECT_NE(find_series(second, "bulk_temperature"), nullptr);
}

// [data] may know columns that only some files have, but one that no file has is probably a slip: said, not refused.
TEST(SharedColumns, ThatNoFileHasAreAWarning) {
    const Written written;
    const std::string more = replaced(std::string(data), "t = \"time\"", "t = \"time\", prob = \"bulk_temperature\"");
    const ExperimentReading reading = read_car(written, more + two_runs);
    EXPECT_TRUE(reading.experiment);
    EXPECT_NE(said(reading, written).find("no file of a [[run]] has the column \"prob\": did you mean `probe`?"),
              std::string::npos)
        << said(reading, written);
}

// Each of the columns in [Grd] is wrong, and one line mends them all. [data] from and to are those of --data alone.
TEST(SharedColumns, TheMessageOfAnUnknownUnitNamesTheOneLineForAll) {
    const Written written;
    const std::string without = replaced(std::string(data), "unit_names = { C = \"degC\" }\n", "");
    const std::string own_unit = replaced(std::string(logger), "[C]", "[Grd]");
    static_cast<void>(read_car(written, ""));
    written.add("c.csv", own_unit);
    const auto read_own = [&](const std::string& tables) {
        return read_experiment(written.add("case.toml", std::string(bench) + without + tables));
    };
    const std::string found = said(read_own("[[run]]\nfile = \"c.csv\"\n"), written);
    EXPECT_NE(found.find("the column probe is in [Grd]: \"Grd\" is not a unit"), std::string::npos) << found;
    EXPECT_NE(found.find("or once for all columns in [Grd]: unit_names = { \"Grd\" = \"degC\" }\n"), std::string::npos)
        << found;
    const ExperimentReading own =
        read_own("from = \"3 s\"\n[[run]]\nfile = \"c.csv\"\nunit_names = { Grd = \"degC\" }\n");
    ASSERT_TRUE(own.experiment) << said(own, written);
    EXPECT_EQ(own.experiment->runs.front().time.size(), 3U);
}

// A logger's C is degC without a word of the case: 25.5 C are 298.65 K.
TEST(SharedColumns, AColumnOfATemperatureInCIsInDegreesCelsius) {
    const Written written;
    const std::string without = replaced(std::string(data), "unit_names = { C = \"degC\" }\n", "");
    const ExperimentReading reading = read_car(written, without + "[[run]]\nfile = \"a.csv\"\n");
    ASSERT_TRUE(reading.experiment) << said(reading, written);
    EXPECT_NEAR(find_series(reading.experiment->runs.front(), "bulk_temperature")->value[0], 298.65, 1e-9);
}

// The clock is not the camera: nothing is mapped, and the example is the first column that can be a temperature.
TEST(UnmappedColumns, TheRemedyMapsATemperatureAndNeverTheClock) {
    const Written written;
    const std::string found =
        said(read_car(written, "[[run]]\nfile = \"a.csv\"\ncolumns = { V = \"speed\" }\n", logger), written);
    EXPECT_NE(found.find("remedy: map one: columns = { Tair = \"surface_temperature\" }; the sensors are"),
              std::string::npos)
        << found;
    EXPECT_NE(found.find("none of the file's columns (t, Fz, Tair, Ttrack, IR spot, probe) is mapped to a sensor"),
              std::string::npos)
        << found;
    const std::size_t mapping = found.find(
        "remedy: map a column of the file (t, V, Fz, Tair, Ttrack, IR spot, probe) to it, columns = { COLUMN = "
        "\"vertical_load\" }, or add");
    EXPECT_NE(mapping, std::string::npos) << found;
}

}  // namespace tiretherm::input
