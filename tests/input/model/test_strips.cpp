// SPDX-License-Identifier: BSD-3-Clause
// Strips of infrared sensors on a section's surface, and uncertainties of measured numbers, against hand calculation.

#include <cmath>

#include <gtest/gtest.h>

#include "input/runs/read_experiment.hpp"
#include "solver/time_integration/march.hpp"
#include "support/written.hpp"

// Strips of a section's surface, what sensors say of themselves, and measured numbers of any quantity.
namespace tiretherm::input {

namespace {

constexpr double zero_of_strips = 273.15;

solver::Problem read_strips(const std::string& text) {
    const Written written;
    const std::string base = (source_folder() / "tests/bad_cases/good/section.toml").string();
    Reading reading = read_case(written.add("case.toml", "include = [\"" + base + "\"]\n" + text));
    if (!reading.problem) {
        ADD_FAILURE() << render(reading);
        return {};
    }
    return *reading.problem;
}

const solver::Channel& channel_of(const solver::Problem& problem, std::string_view name) {
    for (const solver::Channel& candidate : problem.channels) {
        if (candidate.name == name) {
            return candidate;
        }
    }
    ADD_FAILURE() << name;
    return problem.channels.front();
}

/// 300 K at the centre plane, 100 K/m along the meridian.
std::vector<double> along(const solver::Problem& problem) {
    std::vector<double> T;
    for (const mesh::Point& place : problem.mesh.centre) {
        T.push_back(300.0 + 100.0 * place[0]);
    }
    return T;
}

}  // namespace

// Four strips from -40 to 40 mm have their middles at -30, -10, 10 and 30 mm, where T = 300 + 100 s is 297, 299, 301 and
// 303 K: the first is the outermost on the outboard side. The crown's rings differ by 0.5 % in radius over a column, which
// moves a mean by less than 0.005 * 1 K.
TEST(Strips, AreChannelsSideBySideFromOutboardToInboard) {
    const solver::Problem problem = read_strips(R"(
[[sensor]]
name = "ir"
kind = "strips"
count = 4
from = "-40 mm"
to = "40 mm"
standard_deviation = "0.8 degC"
[[sensor]]
name = "wide"
kind = "strip"
from = "-4 cm"
to = "4 cm"
meaning = "camera"
)");
    ASSERT_EQ(problem.channels.size(), 6U);
    const std::vector<double> T = along(problem);
    for (const auto& [name, expected] :
         {std::pair{"ir_1", 297.0}, std::pair{"ir_2", 299.0}, std::pair{"ir_3", 301.0}, std::pair{"ir_4", 303.0}}) {
        EXPECT_NEAR(channel_of(problem, name).where(T), expected, 5e-3) << name;
        EXPECT_EQ(channel_of(problem, name).standard_deviation, 0.8);
    }
    EXPECT_NEAR(channel_of(problem, "wide").where(T), 300.0, 1e-9);  // symmetric
    EXPECT_EQ(channel_of(problem, "wide").meaning, "camera");
    EXPECT_FALSE(channel_of(problem, "wide").standard_deviation.has_value());
    EXPECT_EQ(channel_of(problem, "ir_1").meaning, "outer surface, mean from -40 to -20 mm along the meridian");
}

// The same array mounted the other way round: its number 1 looks at 20 to 40 mm, where T is 303 K.
TEST(Strips, OfAnArrayThatIsNumberedFromInsideComeTheOtherWayRound) {
    const solver::Problem problem = read_strips(R"(
[[sensor]]
name = "ir"
kind = "strips"
count = 4
from = "-40 mm"
to = "40 mm"
first = "inboard"
)");
    ASSERT_EQ(problem.channels.size(), 5U);  // with the one that the case has besides
    const std::vector<double> T = along(problem);
    for (const auto& [name, expected] :
         {std::pair{"ir_1", 303.0}, std::pair{"ir_2", 301.0}, std::pair{"ir_3", 299.0}, std::pair{"ir_4", 297.0}}) {
        EXPECT_NEAR(channel_of(problem, name).where(T), expected, 5e-3) << name;
    }
    EXPECT_EQ(channel_of(problem, "ir_1").meaning, "outer surface, mean from 20 to 40 mm along the meridian");
}

// Sensors stand behind strips as behind any temperature: at the start everything has 23 degC = 296.15 K, the lagged
// channel too; the gain of 0.1 about 298.15 K takes 0.2 K, the offset adds 2 K.
TEST(Strips, AreReadThroughLagOffsetAndGain) {
    const solver::Problem problem = read_strips(R"(
[[sensor]]
name = "ir"
kind = "strips"
count = 2
from = "-40 mm"
to = "40 mm"
[effects.sensor_offset]
channels = ["ir_1"]
kelvin = "2 K"
[effects.sensor_gain]
channels = ["ir_2"]
excess = 0.1
[effects.sensor_lag]
channels = ["ir_1", "ir_2"]
[effects.camera_emissivity]
channels = ["ir_1"]
emissivity = 0.9
)");
    std::vector<double> first;
    const solver::MarchReport report = solver::run(problem, [&](const solver::Snapshot& snapshot) {
        if (first.empty()) {
            first.assign(snapshot.channels.begin(), snapshot.channels.end());
        }
        return true;
    });
    ASSERT_TRUE(report.status.ok()) << report.status.message;
    ASSERT_EQ(first.size(), 3U);
    EXPECT_NEAR(first[1], zero_of_strips + 25.0,
                1e-9);  // surface and surroundings are alike: the emissivity does not show
    EXPECT_NEAR(first[2], zero_of_strips + 22.8, 1e-9);
}

// What an array of infrared sensors has written is read by the names of its strips.
TEST(Strips, AreColumnsOfAMeasuredRun) {
    const Written written;
    const std::string base = (source_folder() / "tests/bad_cases/good/section.toml").string();
    written.add("camera.csv", "time [s],ir_1 [degC],ir_2 [degC]\n0,23,23\n30,24,25\n60,25,\n");
    const ExperimentReading reading = read_experiment(written.add("case.toml", "include = [\"" + base + R"("]
[[sensor]]
name = "ir"
kind = "strips"
count = 2
from = "-40 mm"
to = "40 mm"
[[run]]
file = "camera.csv"
)"));
    for (const InputError& error : reading.errors) {
        ADD_FAILURE() << render(error);
    }
    ASSERT_TRUE(reading.experiment.has_value());
    const MeasuredRun& run = reading.experiment->runs.front();
    ASSERT_EQ(run.series.size(), 2U);
    EXPECT_EQ(run.problem.channels[run.series[1].channel].name, "ir_2");
    EXPECT_NEAR(run.series[1].value[1], zero_of_strips + 25.0, 1e-9);
    EXPECT_TRUE(std::isnan(run.series[1].value[2]));
}

TEST(Strips, HaveNoDepthToBeWrongAbout) {
    const Written written;
    const std::string base = (source_folder() / "tests/bad_cases/good/section.toml").string();
    const Reading reading = read_case(written.add("case.toml", "include = [\"" + base + R"("]
[[sensor]]
name = "ir"
kind = "strip"
from = "-40 mm"
to = "40 mm"
[effects.sensor_depth]
channels = ["ir"]
)"));
    ASSERT_EQ(reading.errors.size(), 1U);
    EXPECT_EQ(reading.errors.front().what, "ir is not a temperature at one point, which sensor_depth reads");
}

// A flat distribution has its width over the root of 12 as standard deviation: 10 K make 2.887 K, with 2.8 K of the
// source's 4.022 K.
TEST(Measured, HasItsUncertaintyAndItsRanges) {
    const solver::Problem problem = read_strips(R"(
[[sensor]]
name = "radius"
kind = "loaded_radius"
standard_deviation = "0.3 mm"
[[measured]]
channel = "bulk_temperature"
value = "50 degC"
[[measured]]
channel = "bulk_temperature"
value = "50 degC"
uncertainty = "2.8 degC"
[[measured]]
channel = "bulk_temperature"
range = ["40 degC", "50 degC"]
[[measured]]
channel = "bulk_temperature"
range = ["40 degC", "50 degC"]
uncertainty = "2.8 K"
[[measured]]
channel = "radius"
value = "310 mm"
uncertainty = "1 mm"
)");
    ASSERT_EQ(problem.measured.size(), 5U);
    EXPECT_FALSE(problem.measured[0].uncertainty.has_value());
    EXPECT_EQ(problem.measured[1].uncertainty, 2.8);
    EXPECT_NEAR(problem.measured[2].uncertainty.value_or(0.0), 2.8867513, 1e-6);
    EXPECT_NEAR(problem.measured[3].uncertainty.value_or(0.0), 4.0216083, 1e-6);
    EXPECT_NEAR(problem.measured[4].low, 0.31, 1e-15);
    EXPECT_NEAR(problem.measured[4].uncertainty.value_or(0.0), 1e-3, 1e-18);
    EXPECT_NEAR(channel_of(problem, "radius").standard_deviation.value_or(0.0), 3e-4, 1e-18);
}

}  // namespace tiretherm::input
