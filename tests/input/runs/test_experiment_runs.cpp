// SPDX-License-Identifier: BSD-3-Clause
// Several measured runs of one case: inputs, initial temperatures, clocks, missing samples and precedence of files.

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "input/measurements/measured_bench.hpp"

namespace tiretherm::input {

namespace {

namespace fs = std::filesystem;
using physics::Inputs;

double input_at(const MeasuredRun& run, double t, double Inputs::*member) {
    return run.problem.input_signals.at(t, solver::JumpSide::after).*member;
}

/// A log of 0, 10, ... 100 s at one speed, whose bulk rises by 0.1 K/s from 23 degC.
std::string even_log(double km_h, double air = 20.0) {
    std::string log =
        "time [s],speed [km/h],vertical_load [N],air_temperature [degC],road_temperature [degC],"
        "bulk_temperature [degC]\n";
    for (int t = 0; t <= 100; t += 10) {
        log += std::to_string(t) + "," + std::to_string(km_h) + ",4000," + std::to_string(air + 0.01 * t) + ",25," +
               std::to_string(23.0 + 0.1 * t) + "\n";
    }
    return log;
}

/// The bench under two logs: `slow.csv` at 36 km/h in 20 degC, `fast.csv` at 72 km/h in 30 degC.
class Bench {
public:
    explicit Bench(std::string_view tables) {
        written_.add("slow.csv", even_log(36.0));
        written_.add("fast.csv", even_log(72.0, 30.0));
        case_ = written_.add("case.toml", std::string(bench) + std::string(tables));
    }
    [[nodiscard]] ExperimentReading read(const std::vector<std::string>& data = {}) const {
        std::vector<fs::path> files;
        for (const std::string& name : data) {
            files.push_back(written_.folder() / name);
        }
        return read_experiment(case_, files);
    }
    [[nodiscard]] Reading read_as_case() const { return read_case(case_); }
    void add(const std::string& name, std::string_view text) const { (void)written_.add(name, text); }

private:
    Written written_;
    fs::path case_;
};

/// The runs of a reading; without them the test ends.
const std::vector<MeasuredRun>& runs_of(const ExperimentReading& reading, std::size_t n) {
    if (!reading.experiment || reading.experiment->runs.size() != n) {
        throw std::runtime_error("not " + std::to_string(n) + " runs\n" + error_report(reading));
    }
    return reading.experiment->runs;
}

constexpr std::string_view both = "[[run]]\nfile = \"slow.csv\"\n[[run]]\nfile = \"fast.csv\"\n";

}  // namespace

TEST(Runs, EachHasItsOwnInputs) {
    const ExperimentReading reading = Bench(both).read();
    const auto& runs = runs_of(reading, 2);
    EXPECT_EQ(runs[0].name, "slow");
    EXPECT_EQ(runs[1].name, "fast");
    EXPECT_NEAR(input_at(runs[0], 50.0, &Inputs::speed), 10.0, 1e-12);
    EXPECT_NEAR(input_at(runs[1], 50.0, &Inputs::speed), 20.0, 1e-12);
    EXPECT_EQ(runs[0].problem.name, runs[1].problem.name);
}

TEST(Runs, EachHasItsOwnStartDriveAndClock) {
    const ExperimentReading reading = Bench(R"(
[drive]
camber = "0 deg"
[time]
tolerance = "0.02 K"
end = "1 s"
[[run]]
file = "slow.csv"
initial = { temperature = "31 degC" }
drive = { camber = "2 deg" }
[[run]]
name = "second half"
file = "fast.csv"
from = "45 s"
to = "90 s"
[run.initial]
surface = "40 degC"
[run.time]
start = "30 s"
tolerance = "0.05 K"
)")
                                          .read();
    const auto& runs = runs_of(reading, 2);
    EXPECT_NEAR(runs[0].problem.initial[0], 304.15, 1e-9);
    EXPECT_NEAR(runs[0].problem.initial[1], 304.15, 1e-9);
    EXPECT_NEAR(input_at(runs[0], 0.0, &Inputs::camber), 2.0 * M_PI / 180.0, 1e-12);
    EXPECT_EQ(runs[0].problem.settings.end, 100.0) << "the file's, not the case's";
    EXPECT_EQ(runs[0].problem.settings.tolerance, 0.02);
    EXPECT_EQ(runs[1].name, "second half");
    EXPECT_NEAR(runs[1].problem.initial[0], 313.15, 1e-9);  // its own
    EXPECT_NEAR(runs[1].problem.initial[1], 296.15, 1e-9);  // the case's
    EXPECT_EQ(input_at(runs[1], 0.0, &Inputs::camber), 0.0);
    EXPECT_EQ(runs[1].problem.settings.start, 30.0) << "its own table's";
    EXPECT_EQ(runs[1].problem.settings.end, 90.0);
    EXPECT_EQ(runs[1].problem.settings.tolerance, 0.05);
    EXPECT_EQ(runs[1].time, (std::vector<double>{50, 60, 70, 80, 90}));
    ASSERT_EQ(runs[1].series.size(), 1U);
    EXPECT_NEAR(runs[1].series[0].value.front(), 273.15 + 28.0, 1e-9);  // 23 + 0.1 * 50
}

TEST(Runs, AFileWinsOverTheDriveOfTheCase) {
    const ExperimentReading reading = Bench(std::string(both) + R"(
[drive]
vertical_load = "1 N"
[[drive.schedule]]
columns = ["time [s]", "speed [km/h]", "camber [deg]"]
rows = [[0, 5, 0], [100, 5, 1]]
)")
                                          .read();
    const auto& runs = runs_of(reading, 2);
    EXPECT_NEAR(input_at(runs[1], 50.0, &Inputs::speed), 20.0, 1e-12);
    EXPECT_EQ(input_at(runs[1], 50.0, &Inputs::vertical_load), 4000.0);
    EXPECT_NEAR(input_at(runs[1], 50.0, &Inputs::camber), 0.5 * M_PI / 180.0, 1e-12) << "what no file gives stays";
}

TEST(Runs, MayStartAtTheTemperatureOfTheAir) {
    const std::string air = replaced(std::string(bench), "\"23 degC\"", "\"air_temperature\"");
    const Written written;
    written.add("fast.csv", even_log(72.0, 30.0));
    const ExperimentReading reading =
        read_experiment(written.add("case.toml", air + "[[run]]\nfile = \"fast.csv\"\nfrom = \"20 s\"\n"));
    const auto& runs = runs_of(reading, 1);
    EXPECT_NEAR(runs[0].problem.initial[0], 273.15 + 30.2, 1e-9);  // of this run: 30 + 0.01 * 20
}

TEST(Runs, TheAirOfAScheduleIsThatOfTheStart) {
    const Written written;
    const Reading reading = read_case(
        written.add("case.toml", replaced(std::string(slab), "temperature = \"23 degC\"",
                                          "temperature = \"10 degC\"\nrubber = \"air_temperature\"") +
                                     "[[drive.schedule]]\ncolumns = [\"time [s]\", \"air_temperature [degC]\"]\n"
                                     "rows = [[-10, 10], [10, 30]]\n"));
    ASSERT_TRUE(reading.problem.has_value()) << render(reading);
    EXPECT_NEAR(reading.problem->initial[0], 293.15, 1e-9);  // half way at 0 s
}

TEST(Runs, WithoutAirNothingCanStartAtItsTemperature) {
    const Written written;
    const fs::path file = written.add("case.toml", replaced(std::string(slab), "\"23 degC\"", "\"air_temperature\""));
    const Reading reading = read_case(file);
    ASSERT_EQ(reading.errors.size(), 1U) << render(reading);
    EXPECT_EQ(reading.errors[0].what, "temperature is set to \"air_temperature\", but no air temperature is given");
    EXPECT_EQ(reading.errors[0].remedy, "add air_temperature to [drive], or write a temperature");
}

TEST(Runs, NumbersStandBesideAFileOrInsteadOfOne) {
    const ExperimentReading reading = Bench(R"(
[drive]
air_temperature = "20 degC"
road_temperature = "20 degC"
[[run]]
file = "slow.csv"
measured = [{ channel = "surface_temperature", value = "30 degC", uncertainty = "0.5 K", time = "50 s" }]
[[run]]
name = "settled"
drive = { speed = "100 km/h", vertical_load = "4000 N" }
time = { steady = true }
[[run.measured]]
channel = "bulk_temperature"
range = ["50 degC", "56 degC"]
uncertainty = "2 K"
source = "sheet 3"
)")
                                          .read();
    const auto& runs = runs_of(reading, 2);
    ASSERT_EQ(runs[0].numbers.size(), 1U);
    EXPECT_EQ(runs[0].numbers[0].channel, 0U);
    EXPECT_EQ(runs[0].numbers[0].time, 50.0);
    EXPECT_NEAR(runs[0].numbers[0].value, 303.15, 1e-9);
    EXPECT_EQ(runs[0].numbers[0].standard_deviation, 0.5);
    EXPECT_EQ(runs[0].series.size(), 1U);
    EXPECT_TRUE(runs[1].file.empty());
    EXPECT_TRUE(runs[1].problem.settings.steady);
    EXPECT_TRUE(runs[1].time.empty());
    ASSERT_EQ(runs[1].numbers.size(), 1U);
    EXPECT_NEAR(runs[1].numbers[0].value, 326.15, 1e-9);  // the middle of the range
    // A flat distribution 6 K wide has a standard deviation of 6/sqrt(12) = sqrt(3) K; with 2 K it makes sqrt(7) K.
    EXPECT_NEAR(runs[1].numbers[0].standard_deviation, std::sqrt(7.0), 1e-12);
    EXPECT_EQ(runs[1].numbers[0].source, "sheet 3");
}

TEST(Runs, FilesBesideTheCaseTakeThePlaceOfItsRuns) {
    const Bench rig(std::string("[[run]]\nfile = \"not_there.csv\"\n[data]\ncolumns = { V = \"speed\" }\n") +
                    "units = { V = \"km/h\" }\nfrom = \"20 s\"\n");
    rig.add("a/log.csv", replaced(even_log(36.0), "speed [km/h]", "V"));
    rig.add("b/log.csv", replaced(even_log(72.0), "speed [km/h]", "V"));
    const ExperimentReading reading = rig.read({"a/log.csv", "b/log.csv", "fast.csv"});
    const auto& runs = runs_of(reading, 3);
    EXPECT_EQ(runs[0].name, "a_log");
    EXPECT_EQ(runs[1].name, "b_log");
    EXPECT_EQ(runs[2].name, "fast");
    EXPECT_NEAR(input_at(runs[0], 50.0, &Inputs::speed), 10.0, 1e-12);
    EXPECT_NEAR(input_at(runs[1], 50.0, &Inputs::speed), 20.0, 1e-12);
    EXPECT_NEAR(input_at(runs[2], 50.0, &Inputs::speed), 20.0, 1e-12);
    EXPECT_EQ(runs[2].time.front(), 20.0);
    const ExperimentReading without = rig.read();
    ASSERT_EQ(without.errors.size(), 1U) << error_report(without);
    EXPECT_NE(without.errors[0].what.find("not_there.csv cannot be read"), std::string::npos);
    const ExperimentReading twice = rig.read({"a/log.csv", "a/log.csv"});
    ASSERT_EQ(twice.errors.size(), 1U) << error_report(twice);
    EXPECT_EQ(twice.errors[0].remedy, "give each file once, under a name of its own");
}

TEST(Runs, ACaseWithRunsIsAlsoACaseToRun) {
    const Reading reading = Bench(both).read_as_case();
    ASSERT_TRUE(reading.problem.has_value()) << render(reading);
    EXPECT_NEAR(reading.problem->input_signals.at(50.0, solver::JumpSide::after).speed, 10.0, 1e-12) << "its first run";
    EXPECT_EQ(reading.problem->settings.end, 100.0);
}

TEST(Runs, ACaseWithoutRunsHasNone) {
    const Written written;
    const ExperimentReading reading = read_experiment(written.add("case.toml", slab));
    EXPECT_FALSE(reading.experiment.has_value());
    ASSERT_EQ(reading.errors.size(), 1U) << error_report(reading);
    EXPECT_EQ(reading.errors[0].what, "the case has no measured run");
}

TEST(Runs, ACaseOfNumbersAloneIsOneRun) {
    const Written written;
    const ExperimentReading reading = read_experiment(
        written.add("slab.toml", std::string(slab) + "[[measured]]\nchannel = \"top\"\nvalue = \"23 degC\"\n"
                                                     "uncertainty = \"1 K\"\n"));
    const auto& runs = runs_of(reading, 1);
    EXPECT_EQ(runs[0].name, "slab");
    EXPECT_EQ(runs[0].numbers.size(), 1U);
    EXPECT_EQ(runs[0].numbers[0].time, 60.0);
}

TEST(Runs, MissingSamplesAreLeftOutOfInputsAndStayMissingInSensors) {
    std::string log = even_log(36.0);
    // 20 s: no speed and no bulk; of 12 samples.
    log = replaced(log, "20,36.000000,4000,20.200000,25,25.000000\n", "20,,4000,20.200000,25,NaN\n");
    log = replaced(log, "10,36.000000,", "10,18.000000,") + "110,36,4000,21,25,34\n";
    const Bench rig("[[run]]\nfile = \"holes.csv\"\n");
    rig.add("holes.csv", log);
    const ExperimentReading reading = rig.read();
    const auto& runs = runs_of(reading, 1);
    // Straight from 5 m/s at 10 s to 10 m/s at 30 s.
    EXPECT_NEAR(input_at(runs[0], 20.0, &Inputs::speed), 7.5, 1e-12);
    ASSERT_EQ(runs[0].series.size(), 1U);
    EXPECT_EQ(runs[0].time.size(), 12U);
    EXPECT_TRUE(std::isnan(runs[0].series[0].value[2]));
    EXPECT_NEAR(runs[0].series[0].value[3], 273.15 + 26.0, 1e-9);
    ASSERT_EQ(reading.warnings.size(), 1U) << error_report(reading);
    EXPECT_TRUE(
        reading.warnings[0].ends_with("holes.csv:1: speed is missing in 1 of 12 samples, for at most 20 s from "
                                      "10 s on: it is taken as straight between its neighbours"))
        << reading.warnings[0];
}

TEST(Runs, AUnitOfTheCaseWinsOverTheHeadingWithAWarning) {
    const ExperimentReading reading = Bench("[[run]]\nfile = \"slow.csv\"\nunits = { speed = \"m/s\" }\n").read();
    const auto& runs = runs_of(reading, 1);
    EXPECT_NEAR(input_at(runs[0], 50.0, &Inputs::speed), 36.0, 1e-12);
    ASSERT_EQ(reading.warnings.size(), 1U) << error_report(reading);
    EXPECT_TRUE(reading.warnings[0].ends_with("the column speed is in [km/h] by its heading; m/s is taken instead"));
}

TEST(Runs, ANumberOfTheCaseCountsInEachRunWithAWarning) {
    const std::string number =
        "[[measured]]\nchannel = \"bulk_temperature\"\nvalue = \"33 degC\"\nuncertainty = \"1 K\"\n";
    const ExperimentReading reading = Bench(std::string(both) + number).read();
    const auto& runs = runs_of(reading, 2);
    EXPECT_EQ(runs[0].numbers.size(), 1U);
    EXPECT_EQ(runs[1].numbers.size(), 1U);
    ASSERT_EQ(reading.warnings.size(), 1U) << error_report(reading);
    EXPECT_TRUE(reading.warnings[0].ends_with(
        "the [[measured]] values of the case apply to each of 2 runs: give them to the run in "
        "which they were measured"));
    // Without uncertainty it only stands beside the simulated ones.
    const ExperimentReading shown = Bench(std::string(both) + replaced(number, "uncertainty = \"1 K\"\n", "")).read();
    EXPECT_TRUE(runs_of(shown, 2)[0].numbers.empty());
    EXPECT_TRUE(shown.warnings.empty());
}

TEST(Runs, AFileWinsOverALogOfTheCaseColumnByColumn) {
    const Bench rig("[[run]]\nfile = \"slow.csv\"\n[[drive.file]]\npath = \"rig.csv\"\n");
    rig.add("rig.csv", "time [s],speed [km/h],camber [deg]\n0,1,0\n200,1,2\n");
    const ExperimentReading reading = rig.read();
    const auto& runs = runs_of(reading, 1);
    EXPECT_NEAR(input_at(runs[0], 50.0, &Inputs::speed), 10.0, 1e-12);
    EXPECT_NEAR(input_at(runs[0], 50.0, &Inputs::camber), 0.5 * M_PI / 180.0, 1e-12);
    EXPECT_EQ(runs[0].problem.settings.end, 100.0) << "the run's file says how long, not the log of the case";
}

TEST(Runs, ErrorsOfAllRunsAreReportedAtOnce) {
    const ExperimentReading reading =
        Bench("[[run]]\nfile = \"slow.csv\"\nfrom = \"500 s\"\n[[run]]\nfile = \"fast.csv\"\nto = \"-1 s\"\n").read();
    ASSERT_EQ(reading.errors.size(), 2U) << error_report(reading);
    EXPECT_EQ(reading.errors[0].what,
              "fewer than two samples lie between from and to: the file goes from 0 s to 100 s");
    EXPECT_EQ(reading.errors[0].line + 3, reading.errors[1].line);
}

}  // namespace tiretherm::input
