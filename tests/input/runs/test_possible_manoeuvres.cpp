// SPDX-License-Identifier: BSD-3-Clause
// [diagnose] possible: the manoeuvres of a case, and those of cases/manoeuvres.toml where it has none. What is wrong with an entry is in
// tests/bad_cases/possible*.toml.

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "input/measurements/made_up_log.hpp"
#include "input/measurements/measured_bench.hpp"
#include "support/written.hpp"

namespace tiretherm::input {

namespace {

/// A tire that warms, driven by these inputs beside the temperatures of air and road.
MadeUpLog log_driven_by(const std::vector<std::pair<std::string, std::string>>& inputs) {
    MadeUpLog log(200, 2.0);
    for (const auto& [name, unit] : inputs) {
        log.add(name, unit, [](double t) { return 60.0 + std::sin(t / 13.0); });
    }
    log.add("air_temperature", "degC", [](double) { return 25.0; });
    log.add("road_temperature", "degC", [](double) { return 30.0; });
    log.add("bulk_temperature", "degC",
            [](double t) { return 45.0 - 20.0 * std::exp(-t / 150.0) + 0.1 * std::sin(t); });
    return log;
}

std::vector<Manoeuvre> possible_of(const ExperimentReading& reading) {
    EXPECT_TRUE(reading.experiment.has_value()) << error_report(reading);
    return reading.experiment ? reading.experiment->possible : std::vector<Manoeuvre>{};
}

const MadeUpLog& rolling() {
    static const MadeUpLog log = log_driven_by({{"speed", "km/h"}, {"vertical_load", "N"}});
    return log;
}

}  // namespace

// The file has nine: three that change speed or load, a long hold, a stop and a coast-down need these two alone; slip angles, camber and
// two of a laser need an input that the log does not have.
TEST(PossibleManoeuvres, WithoutAListThoseOfTheLibraryThatTheRunsCanHave) {
    const std::vector<Manoeuvre> possible = possible_of(read_logs({rolling()}));
    ASSERT_EQ(possible.size(), 5u);
    EXPECT_EQ(possible.front().name, "speed steps of 50, 100 and 150 km/h at 4500 N, 10 min each");
    EXPECT_EQ(possible.front().end, 1800.0);
    const solver::JumpSide after = solver::JumpSide::after;
    EXPECT_NEAR(possible.front().inputs.at(600.0, after).speed, 50.0 / 3.6, 1e-12);
    EXPECT_NEAR(possible.front().inputs.at(602.5, after).speed, 75.0 / 3.6,
                1e-12);  // half of the way from step to step
    EXPECT_NEAR(possible.front().inputs.at(1800.0, after).speed, 150.0 / 3.6, 1e-12);
    const std::vector<Manoeuvre> with_slip =
        possible_of(read_logs({log_driven_by({{"speed", "km/h"}, {"vertical_load", "N"}, {"slip_angle", "deg"}})}));
    ASSERT_EQ(with_slip.size(), 6u);
    EXPECT_NEAR(with_slip[2].inputs.at(300.0, after).slip_angle, 2.0 * std::numbers::pi / 180.0, 1e-12);
}

TEST(PossibleManoeuvres, AListOfTheCaseTakesTheirPlace) {
    const std::vector<Manoeuvre> possible = possible_of(read_logs(
        {rolling()},
        "[diagnose]\npossible = [{ name = \"coast-down\", drive = { vertical_load = \"3 kN\", schedule = [{ columns = "
        "[\"time [min]\", \"speed [km/h]\"], rows = [[1, 150], [11, 36]] }] } }]\n"));
    ASSERT_EQ(possible.size(), 1u);
    EXPECT_EQ(possible.front().name, "coast-down");
    EXPECT_EQ(possible.front().start, 60.0);
    EXPECT_EQ(possible.front().end, 660.0);
    EXPECT_NEAR(possible.front().inputs.at(660.0, solver::JumpSide::before).speed, 10.0, 1e-12);
    EXPECT_NEAR(possible.front().inputs.at(660.0, solver::JumpSide::before).vertical_load, 3000.0, 1e-9);
}

// 0, 36 and 72 km/h over 200 s, in a file of their own.
TEST(PossibleManoeuvres, TheLogOfAnEarlierDriveIsOne) {
    const Written written;
    const std::filesystem::path log =
        written.add("earlier.csv", "time [s],speed [km/h],lap [-]\n0,0,1\n100,36,1\n200,72,2\n");
    const std::vector<Manoeuvre> possible = possible_of(read_logs(
        {rolling()}, "[[diagnose.possible]]\nname = \"as before\"\n[[diagnose.possible.drive.file]]\npath = \"" +
                         log.generic_string() + "\"\n"));
    ASSERT_EQ(possible.size(), 1u);
    EXPECT_EQ(possible.front().end, 200.0);
    EXPECT_NEAR(possible.front().inputs.at(150.0, solver::JumpSide::after).speed, 15.0, 1e-12);
}

// One of two needs slip angles, which the log does not have: it is said, and the other stays.
TEST(PossibleManoeuvres, OneThatTheRunsCannotHaveIsLeftOutWithAWarning) {
    const auto entry = [](const std::string& name, const std::string& input) {
        return "[[diagnose.possible]]\nname = \"" + name +
               "\"\n[[diagnose.possible.drive.schedule]]\ncolumns = [\"time [min]\", \"" + input +
               "\"]\nrows = [[0, 1], [10, 2]]\n";
    };
    const ExperimentReading reading =
        read_logs({rolling()}, entry("slides", "slip_angle [deg]") + entry("rolls", "speed [km/h]"));
    const std::vector<Manoeuvre> possible = possible_of(reading);
    ASSERT_EQ(possible.size(), 1u);
    EXPECT_EQ(possible.front().name, "rolls");
    ASSERT_EQ(reading.warnings.size(), 1u);
    EXPECT_NE(reading.warnings.front().find("\"slides\" of possible is left out: slip_angle is no input of the runs"),
              std::string::npos)
        << reading.warnings.front();
}

}  // namespace tiretherm::input
