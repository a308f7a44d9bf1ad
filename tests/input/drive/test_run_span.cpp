// SPDX-License-Identifier: BSD-3-Clause
// Where a run of readings without inputs starts, what is said of a schedule that is not driven, and tables of probes.

#include <cmath>

#include <gtest/gtest.h>

#include "input/measurements/measured_bench.hpp"

namespace tiretherm::input {

namespace {

/// A test of 10 min up to 100 km/h, 20 min at 100, 30 min at 120 km/h.
constexpr std::string_view driven_bench = R"(
[drive]
vertical_load = "4000 N"
air_temperature = "25 degC"
road_temperature = "25 degC"
[[drive.schedule]]
columns = ["time [min]", "speed [km/h]"]
rows = [[0, 0], [10, 100], [30, 100], [30, 120], [60, 120]]
)";
constexpr std::string_view for_an_hour = "[time]\nend = \"60 min\"\n";
constexpr std::string_view late = "time [min],bulk_temperature [degC]\n20,50\n30,55\n40,57\n";

/// The bench under one file. @param tables of the case
ExperimentReading read_one(const std::string& tables, std::string_view log, const std::string& of_run = "") {
    const Written files;
    (void)files.add("probes.csv", log);
    return read_experiment(
        files.add("case.toml", std::string(bench) + tables + "[[run]]\nfile = \"probes.csv\"\n" + of_run));
}

const MeasuredRun& only_run(const ExperimentReading& reading) {
    if (!reading.experiment) {
        throw std::runtime_error(error_report(reading));
    }
    return reading.experiment->runs.front();
}

std::vector<double> in_celsius(const MeasuredRun& run, std::string_view channel) {
    std::vector<double> values = find_series(run, channel)->value;
    for (double& value : values) {
        value -= 273.15;
    }
    return values;
}

}  // namespace

// Readings at 20, 30 and 40 min of a schedule of 60 min: the tire was driven from 0 s on, whatever the first reading's time.
TEST(RunSpan, ReadingsWithoutInputsStartWhereTheScheduleDoes) {
    const ExperimentReading reading = read_one(std::string(driven_bench) + std::string(for_an_hour), late);
    const MeasuredRun& run = only_run(reading);
    EXPECT_EQ(run.problem.settings.start, 0.0);
    EXPECT_EQ(run.problem.settings.end, 2400.0);
    ASSERT_EQ(run.time.size(), 3U);
    EXPECT_EQ(run.time.front(), 1200.0);
    ASSERT_EQ(run.not_driven.size(), 1U);
    EXPECT_EQ(run.not_driven[0], "the run ends at 40 min; the last 20 min of the schedule are not driven");
    ASSERT_EQ(reading.warnings.size(), 1U);
    EXPECT_NE(reading.warnings[0].find(run.not_driven[0]), std::string::npos);
    EXPECT_EQ(not_driven(*reading.experiment), std::vector<std::string>{"probes: " + run.not_driven[0]});
}

// Before its first sample an input of the file is not known: the schedule of the others is then not driven from its start.
TEST(RunSpan, AFileThatGivesInputsStartsWhereTheyDoAndSaysWhatIsNotDriven) {
    const ExperimentReading reading =
        read_one(std::string(driven_bench) + std::string(for_an_hour),
                 "time [min],vertical_load [N],bulk_temperature [degC]\n20,4000,50\n60,4000,57\n");
    const MeasuredRun& run = only_run(reading);
    EXPECT_EQ(run.problem.settings.start, 1200.0);
    ASSERT_EQ(run.not_driven.size(), 1U);
    EXPECT_EQ(run.not_driven[0],
              "the run starts at 20 min from [initial]; the first 20 min of the schedule are not driven");
}

// Two constants drive the tire, and the case says how long: 60 min from 0 s. Without an end nothing tells when it began.
TEST(RunSpan, ConstantInputsBeginWithTheCase) {
    const std::string constant =
        "[drive]\nspeed = \"100 km/h\"\nvertical_load = \"4000 N\"\nair_temperature = \"25 degC\"\n"
        "road_temperature = \"25 degC\"\n";
    EXPECT_EQ(only_run(read_one(constant + std::string(for_an_hour), late)).problem.settings.start, 0.0);
    EXPECT_EQ(only_run(read_one(constant, late)).problem.settings.start, 1200.0);
}

// Who starts the tire at its first reading, chooses a part of the file or says the start has said where the run begins.
TEST(RunSpan, AStartThatIsSaidCounts) {
    const std::string tables = std::string(driven_bench) + std::string(for_an_hour);
    const ExperimentReading from_reading = read_one(tables, late, "initial = { temperature = \"bulk_temperature\" }\n");
    EXPECT_EQ(only_run(from_reading).problem.settings.start, 1200.0);
    EXPECT_EQ(only_run(from_reading).not_driven.size(), 2U);
    const ExperimentReading part = read_one(tables, late, "from = \"30 min\"\n");
    EXPECT_EQ(only_run(part).problem.settings.start, 1800.0);
    EXPECT_EQ(only_run(part).not_driven.front(),
              "the run starts at 30 min from [initial]; the first 10 min of the file are not driven");
    const ExperimentReading own = read_one(tables, late, "time = { start = \"5 min\" }\n");
    EXPECT_EQ(only_run(own).problem.settings.start, 300.0);
}

// Ten hours on a clock of the day, beside a schedule of one hour from 0.
TEST(RunSpan, ReadingsOfAnotherClockAreNotDrivenAndThatIsSaid) {
    const ExperimentReading reading = read_one(std::string(driven_bench) + std::string(for_an_hour),
                                               "time [h],bulk_temperature [degC]\n10,50\n11,55\n");
    ASSERT_EQ(only_run(reading).not_driven.size(), 1U);
    EXPECT_EQ(
        only_run(reading).not_driven[0],
        "the run goes from 600 min to 660 min, the schedule of the case from 0 s to 60 min: none of it is driven; "
        "let both have one clock");
}

// Readings until 90 min and from -5 min on, beside a schedule from 0 to 60 min: inputs keep their first and last values.
TEST(RunSpan, AScheduleThatIsTooShortIsSaid) {
    const ExperimentReading reading = read_one(std::string(driven_bench) + std::string(for_an_hour),
                                               "time [min],bulk_temperature [degC]\n-5,25\n50,57\n90,57\n");
    const std::vector<std::string>& said = only_run(reading).not_driven;
    ASSERT_EQ(said.size(), 2U);
    EXPECT_EQ(said[0], "the run starts at -300 s, the schedule at 0 s: until then its first values hold");
    EXPECT_EQ(said[1], "the run ends at 90 min, the schedule at 60 min: from then on its last values hold");
}

// The same three readings, turned: a line for each probe. A dash is no reading.
TEST(ProbeTable, LinesOfProbesAreReadAsColumns) {
    const std::string tables = std::string(driven_bench) + std::string(for_an_hour);
    const ExperimentReading reading = read_one(tables,
                                               "High-speed test 12\n"
                                               "probe,depth [mm],20 min,30 min,40 min\n"
                                               "bulk_temperature [degC],10,50,55,57\n"
                                               "surface_temperature [degF],0,104,-,113\n");
    const MeasuredRun& run = only_run(reading);
    EXPECT_EQ(run.problem.settings.start, 0.0);
    EXPECT_EQ(run.time, (std::vector<double>{1200.0, 1800.0, 2400.0}));
    EXPECT_NEAR(in_celsius(run, "bulk_temperature")[1], 55.0, 1e-9);
    EXPECT_NEAR(in_celsius(run, "surface_temperature")[0], 40.0, 1e-9);
    EXPECT_TRUE(std::isnan(in_celsius(run, "surface_temperature")[1]));
}

// The unit of the values may stand in the first heading, in those of the columns or in a column of its own; that of bare times in
// the first heading. Decimal commas go with semicolons.
TEST(ProbeTable, UnitsMayStandWhereLaboratoriesWriteThem) {
    const std::string tables = std::string(driven_bench) + std::string(for_an_hour);
    for (const char* text : {"probe [degC],20 min,30 min\nbulk_temperature,50.5,55\n",
                             "Probe (degC);t = 20 min;t = 30 min\nbulk_temperature;50,5;55,0\n",
                             "needle,20 min [degC],30 min [degC]\nbulk_temperature,50.5,55\n",
                             "probe / time [min],unit,20,30\nbulk_temperature,degC,50.5,55\n",
                             "time [s],1200,1800\nbulk_temperature [degC],50.5,55\n"}) {
        const ExperimentReading reading = read_one(tables, text);
        const MeasuredRun& run = only_run(reading);
        EXPECT_EQ(run.time, (std::vector<double>{1200.0, 1800.0})) << text;
        EXPECT_NEAR(in_celsius(run, "bulk_temperature")[0], 50.5, 1e-9) << text;
    }
}

// Columns that are steps: a reading was taken at the end of its step, of 100 km/h at 30 min and of 120 km/h at 60 min.
TEST(ProbeTable, StepsAreThoseOfTheSchedule) {
    const std::string tables = std::string(driven_bench) + std::string(for_an_hour);
    for (const char* text :
         {"probe [degC],100 km/h,120 km/h\nbulk_temperature,50,55\n",
          "probe [degC],step 1,step 2\nbulk_temperature,50,55\n", "probe [degC],1,2\nbulk_temperature,50,55\n",
          "probe / speed [km/h],unit,100,120\nbulk_temperature,degC,50,55\n"}) {
        EXPECT_EQ(only_run(read_one(tables, text)).time, (std::vector<double>{1800.0, 3600.0})) << text;
    }
}

// Columns of other logs stay columns: names of sensors that begin with a number's unit, numbers of channels, times as texts.
TEST(ProbeTable, OtherTablesAreReadLineByLine) {
    const std::string tables = std::string(driven_bench) + std::string(for_an_hour);
    for (const char* text : {"time [s],bulk_temperature [degC],10 mm [degC],20 mm [degC]\n0,50,1,1\n600,55,1,1\n",
                             "time [s],bulk_temperature [degC],1,2\n0,50,1,1\n600,55,1,1\n"}) {
        EXPECT_EQ(only_run(read_one(tables, text)).time, (std::vector<double>{0.0, 600.0})) << text;
    }
}

}  // namespace tiretherm::input
