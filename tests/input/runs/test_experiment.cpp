// SPDX-License-Identifier: BSD-3-Clause
// Logs in all dialects are read into the same experiment: values in SI, columns mapped, renamed and ignored.

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "input/measurements/measured_bench.hpp"

namespace tiretherm::input {

namespace {

/// The bench with more tables, in a folder that has `run1.csv`.
ExperimentReading read_bench(std::string_view tables, std::string_view log = log_of_five) {
    const Written written;
    written.add("run1.csv", log);
    return read_experiment(written.add("case.toml", std::string(bench) + std::string(tables)));
}

double input(const MeasuredRun& run, double t, double physics::Inputs::*member) {
    return run.problem.input_signals.at(t, solver::JumpSide::after).*member;
}

/// log_of_five, however it was written.
void expect_five(const ExperimentReading& reading, const std::string& how) {
    SCOPED_TRACE(how);
    ASSERT_TRUE(reading.experiment.has_value()) << error_report(reading);
    EXPECT_TRUE(reading.warnings.empty()) << error_report(reading);
    ASSERT_EQ(reading.experiment->runs.size(), 1U);
    const MeasuredRun& run = reading.experiment->runs.front();
    EXPECT_EQ(run.name, "run1");
    EXPECT_EQ(run.time, (std::vector<double>{0, 2, 5, 6, 10}));
    EXPECT_EQ(run.problem.settings.start, 0.0);
    EXPECT_EQ(run.problem.settings.end, 10.0);
    EXPECT_NEAR(input(run, 2.0, &physics::Inputs::speed), 15.0, 1e-12);
    EXPECT_NEAR(input(run, 3.5, &physics::Inputs::vertical_load), 4150.0, 1e-9);
    EXPECT_NEAR(input(run, 8.0, &physics::Inputs::road_temperature), 304.15, 1e-9);
    ASSERT_EQ(run.series.size(), 2U);
    const MeasuredSeries* bulk = find_series(run, "bulk_temperature");
    ASSERT_NE(bulk, nullptr);
    const std::vector<double> degrees{25.5, 25.8, 26.1, 26.6, 27.0};
    ASSERT_EQ(bulk->value.size(), degrees.size());
    for (std::size_t i = 0; i < degrees.size(); ++i) {
        EXPECT_NEAR(bulk->value[i], degrees[i] + 273.15, 1e-9);
    }
    ASSERT_EQ(run.unused.size(), 1U);
    EXPECT_EQ(run.unused[0].name, "throttle");
    EXPECT_EQ(run.unused[0].unit, "-");
    EXPECT_EQ(run.unused[0].value, (std::vector<double>{0.10, 0.20, 0.35, 0.40, 0.15}));
}

constexpr std::string_view first_run = "[[run]]\nfile = \"run1.csv\"\n";

}  // namespace

TEST(Experiment, ALogIsReadWithItsUnits) { expect_five(read_bench(first_run), "commas"); }

TEST(Experiment, DialectsOfOneLogAreOneExperiment) {
    const std::string log(log_of_five);
    expect_five(read_bench(first_run, replaced(log, ",", ";")), "semicolons");
    expect_five(read_bench(first_run, replaced(log, ",", "\t")), "tabs");
    expect_five(read_bench(first_run, "\xEF\xBB\xBF" + replaced(log, "\n", "\r\n")), "mark and carriage returns");
    expect_five(read_bench(first_run, replaced(log, "\n", "\n\n")), "blank lines");
    const std::string numbers = log.substr(log.find('\n') + 1);
    const std::string names =
        "time,speed,vertical_load,air_temperature,road_temperature,throttle,surface_temperature,bulk_temperature\n";
    const std::string units = "s,km/h,N,degC,degC,-,degC,degC\n";
    expect_five(read_bench(first_run, names + units + numbers), "a line of units");
    expect_five(
        read_bench(first_run, replaced(names, ",", ";") + replaced(units, ",", ";") + replaced(numbers, ",", ";")),
        "a line of units, semicolons");
}

// As MoTeC i2 exports: lines about the recording, some of them with numbers and as long as one likes, then quoted
// names, quoted units, a blank line, quoted numbers.
TEST(Experiment, LinesAboutTheRecordingMayStandAboveTheNames) {
    std::string log =
        "\"Format\",\"MoTeC CSV File\",,,\"Workbook\",\"tire, rig\"\r\n\"Venue\",\"Oval\",,,\"Worksheet\",\"Heat\"\r\n"
        "\"Sample Rate\",\"0.5\",\"Hz\"\r\n\"Duration\",\"10.000\",\"s\"\r\n\"Beacon Markers\",\"4.2 8.1\"\r\n\r\n"
        "\"time\",\"speed\",\"vertical_load\",\"air_temperature\",\"road_temperature\",\"throttle\","
        "\"surface_temperature\",\"bulk_temperature\"\r\n"
        "\"s\",\"km/h\",\"N\",\"C\",\"degC\",\"-\",\"degC\",\"degC\"\r\n\r\n";
    log = replaced(log, "\"C\"", "\"degC\"");
    std::string rest(log_of_five.substr(log_of_five.find('\n') + 1));
    rest = "\"" + replaced(replaced(rest, ",", "\",\""), "\n", "\"\r\n\"");
    log += rest.substr(0, rest.size() - 1);
    expect_five(read_bench(first_run, log), "MoTeC");
}

TEST(Experiment, TheOrderOfColumnsDoesNotMatter) {
    expect_five(read_bench(first_run,
                           "bulk_temperature [degC],throttle [-],road_temperature [degC],vertical_load [kN],time [min],"
                           "surface_temperature [K],air_temperature [degC],speed [m/s]\n"
                           "25.5,0.10,30,4.0,0,298.15,25,10\n"
                           "25.8,0.20,30,4.1,0.033333333333333333,298.65,25,15\n"
                           "26.1,0.35,31,4.2,0.083333333333333333,299.15,25,20\n"
                           "26.6,0.40,31,4.2,0.1,299.45,26,20\n"
                           "27.0,0.15,31,4.0,0.16666666666666667,299.25,26,10\n"),
                "another order and other units");
}

TEST(Experiment, ColumnsAreMappedGivenUnitsAndIgnored) {
    std::string log = replaced(std::string(log_of_five), "speed [km/h]", "V");
    log = replaced(log, "bulk_temperature [degC]", "T_sh [degC],gear");
    for (const char* line : {"25.5", "25.8", "26.1", "26.6", "27.0"}) {
        log = replaced(log, std::string(",") + line + "\n", std::string(",") + line + ",N\n");
    }
    log = replaced(log, "road_temperature [degC]", "road_temperature [degC],vertical_load_2 [N]");
    log = replaced(replaced(log, ",30,", ",30,x,"), ",31,", ",31,y,");
    expect_five(read_bench("[[run]]\nfile = \"run1.csv\"\ncolumns = { V = \"speed\", T_sh = \"bulk_temperature\" }\n"
                           "units = { V = \"km/h\" }\nignore = [\"vertical_load_2\"]\n",
                           log),
                "mapped");
}

// A speed that is switched at the samples, and the way that follows from it.
TEST(Experiment, ASwitchedInputHoldsItsValues) {
    const std::string log =
        "time [s],speed [km/h],bulk_temperature [degC]\n0,0,20\n2,72,20\n5,0,21\n6,72,21\n10,0,22\n";
    const auto distance = [&](std::string_view keys) {
        const ExperimentReading reading = read_bench(
            "[[run]]\nfile = \"run1.csv\"\n" + std::string(keys) +
                "drive = { vertical_load = \"4 kN\", air_temperature = \"20 degC\", road_temperature = \"20 degC\" }\n",
            log);
        EXPECT_TRUE(reading.experiment.has_value()) << error_report(reading);
        if (!reading.experiment) {
            return 0.0;
        }
        const MeasuredRun& run = reading.experiment->runs.front();
        double sum = 0.0;
        for (int i = 0; i < 10000; ++i) {
            sum += 1e-3 * run.problem.input_signals.at(1e-3 * (i + 0.5), solver::JumpSide::after).speed;
        }
        return sum;
    };
    // 20 m/s. Straight: the areas of triangles and trapezoids, 20 + 30 + 10 + 40 m.
    EXPECT_NEAR(distance(""), 100.0, 1e-6);
    // Held: 3 s and 4 s of 20 m/s.
    EXPECT_NEAR(distance("hold = [\"speed\"]\n"), 140.0, 1e-6);
    // Jumps of a held input are break times of the steps.
    const ExperimentReading held = read_bench(
        "[[run]]\nfile = \"run1.csv\"\nhold = [\"speed\"]\ndrive = { vertical_load = \"4 kN\", air_temperature = \"20 "
        "degC\", road_temperature = \"20 degC\" }\n",
        log);
    ASSERT_TRUE(held.experiment.has_value());
    EXPECT_EQ(held.experiment->runs.front().problem.input_signals.stops(), (std::vector<double>{2, 5, 6, 10}));
    const ExperimentReading wrong = read_bench("[[run]]\nfile = \"run1.csv\"\nhold = [\"sped\"]\n", log);
    ASSERT_FALSE(wrong.experiment.has_value());
    EXPECT_NE(error_report(wrong).find("hold: no column of the file is the input \"sped\""), std::string::npos);
}

// Two lines at one time are a jump of the inputs; of the sensors the first counts.
TEST(Experiment, TwoLinesAtOneTimeAreAJump) {
    const ExperimentReading reading = read_bench(
        "[[run]]\nfile = \"run1.csv\"\ndrive = { vertical_load = \"4 kN\", air_temperature = \"20 degC\", "
        "road_temperature = \"20 degC\" }\n",
        "time [s],speed [km/h],bulk_temperature [degC]\n0,36,20\n4,36,21\n4,72,99\n10,72,22\n");
    ASSERT_TRUE(reading.experiment.has_value()) << error_report(reading);
    const MeasuredRun& run = reading.experiment->runs.front();
    EXPECT_EQ(run.time, (std::vector<double>{0, 4, 10}));
    EXPECT_NEAR(run.series.front().value[1], 294.15, 1e-9);
    EXPECT_NEAR(run.problem.input_signals.at(4.0, solver::JumpSide::before).speed, 10.0, 1e-12);
    EXPECT_NEAR(run.problem.input_signals.at(4.0, solver::JumpSide::after).speed, 20.0, 1e-12);
    EXPECT_EQ(run.problem.input_signals.stops(), std::vector<double>{4});
}

}  // namespace tiretherm::input
