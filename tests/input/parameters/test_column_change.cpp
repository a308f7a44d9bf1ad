// SPDX-License-Identifier: BSD-3-Clause
// Columns in another unit or under another name: in the reading of a case, and in the fitted case that is laid over it.

#include "input/parameters/column_change.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "input/measurements/measured_bench.hpp"
#include "input/parameters/overlay.hpp"

namespace tiretherm::input {
namespace {

const ColumnChange surface_in_fahrenheit{.heading = "surface_temperature", .unit = "degF"};
const std::vector<ColumnChange> exchanged{{.heading = "surface_temperature", .name = "bulk_temperature"},
                                          {.heading = "bulk_temperature", .name = "surface_temperature"}};

/// What the sensor of this name reads first in a run, K.
double first_reading(const ExperimentReading& reading, std::size_t run, const std::string& sensor) {
    if (!reading.experiment) {
        ADD_FAILURE() << error_report(reading);
        return 0.0;
    }
    const MeasuredRun& one = reading.experiment->runs.at(run);
    for (const MeasuredSeries& series : one.series) {
        if (one.problem.channels[series.channel].name == sensor) {
            return series.value.front();
        }
    }
    ADD_FAILURE() << sensor << " is not in the run";
    return 0.0;
}

ExperimentReading read_with(const std::filesystem::path& file, const std::vector<std::filesystem::path>& data,
                            const std::vector<ColumnChange>& columns) {
    return read_experiment(file, data, ReadMode::measured, {}, columns);
}

}  // namespace

// 25 degF are -3.889 degC.
TEST(ColumnChange, AUnitOfAllRunsCountsForFilesAndForRunsOfTheCase) {
    const Written written;
    const auto data = written.add("a.csv", log_of_five);
    const auto file = written.add("case.toml", bench);
    const auto own = written.add("own.toml", std::string(bench) + "[[run]]\nfile = \"a.csv\"\n" +
                                                 "units = { surface_temperature = \"degC\" }\n");
    const double cold = 273.15 + (25.0 - 32.0) / 1.8;
    EXPECT_NEAR(first_reading(read_with(file, {data}, {surface_in_fahrenheit}), 0, "surface_temperature"), cold, 1e-9);
    EXPECT_NEAR(first_reading(read_with(own, {}, {surface_in_fahrenheit}), 0, "surface_temperature"), cold, 1e-9);
}

TEST(ColumnChange, AChangeOfOneRunLeavesTheOthersAndTheirNames) {
    const Written written;
    const std::vector<std::filesystem::path> data{written.add("x/a.csv", log_of_five),
                                                  written.add("y/a.csv", log_of_five)};
    const auto file = written.add("case.toml", bench);
    ColumnChange change = surface_in_fahrenheit;
    change.run = "y_a";
    const ExperimentReading reading = read_with(file, data, {change});
    EXPECT_NEAR(first_reading(reading, 0, "surface_temperature"), 298.15, 1e-9);
    EXPECT_NEAR(first_reading(reading, 1, "surface_temperature"), 273.15 + (25.0 - 32.0) / 1.8, 1e-9);
    EXPECT_EQ(reading.experiment->runs[0].name, "x_a");
    EXPECT_EQ(reading.experiment->runs[1].name, "y_a");
}

TEST(ColumnChange, ExchangedColumnsAreReadAsEachOther) {
    const Written written;
    const auto data = written.add("a.csv", log_of_five);
    const ExperimentReading reading = read_with(written.add("case.toml", bench), {data}, exchanged);
    EXPECT_NEAR(first_reading(reading, 0, "surface_temperature"), 298.65, 1e-9);
    EXPECT_NEAR(first_reading(reading, 0, "bulk_temperature"), 298.15, 1e-9);
}

// The fitted case includes the original, whose [data] says something else of another column: both count.
TEST(ColumnChange, AFittedCaseReadsItsFilesAndOthersWithTheChange) {
    const Written written;
    const auto data = written.add("a.csv", log_of_five);
    const auto later = written.add("later.csv", log_of_five);
    const auto file = written.add("case.toml", std::string(bench) + "[data]\nunits = { throttle = \"%\" }\n");
    for (const bool alone : {false, true}) {
        ColumnChange change = surface_in_fahrenheit;
        change.run = alone ? "a" : "";
        const ExperimentReading reading = read_with(file, {data}, {change});
        ASSERT_TRUE(reading.experiment) << error_report(reading);
        const MeasuredRun& run = reading.experiment->runs.front();
        const Overlay overlay{.original = file,
                              .before = &run.problem,
                              .fitted = &run.problem,
                              .parameters = {},
                              .runs = {{.name = run.name, .problem = &run.problem, .file = run.file}},
                              .columns = {change}};
        const auto fitted = written.add("fitted.toml", overlay_text(overlay, written.folder()));
        const double cold = 273.15 + (25.0 - 32.0) / 1.8;
        EXPECT_NEAR(first_reading(read_experiment(fitted), 0, "surface_temperature"), cold, 1e-9);
        EXPECT_NEAR(first_reading(read_experiment(fitted, {later}), 0, "surface_temperature"), alone ? 298.15 : cold,
                    1e-9);
        EXPECT_EQ(read_experiment(fitted, {later}).experiment->runs[0].unused.front().unit, "%");
    }
}

// 72 km/h are 20 m/s; the same number may be 32.2 m/s in miles per hour, or 72 m/s of a fast car. 31 degrees of a road may be
// of Fahrenheit; 26 kelvin are no temperature of air.
TEST(ColumnChange, AColumnKnowsTheOtherUnitsThatItsSizeAllows) {
    const Written written;
    const auto data = written.add("a.csv", log_of_five);
    const ExperimentReading reading = read_experiment(written.add("case.toml", bench), {data});
    ASSERT_TRUE(reading.experiment) << error_report(reading);
    const std::vector<ReadColumn>& columns = reading.experiment->runs[0].columns;
    const auto units = [&](std::string_view name) {
        std::string all;
        for (const ReadColumn::OtherUnit& one : std::ranges::find(columns, name, &ReadColumn::name)->others) {
            all += one.name + " ";
        }
        return all;
    };
    EXPECT_EQ(units("speed"), "m/s mph ");
    EXPECT_EQ(units("road_temperature"), "degF ");
    EXPECT_EQ(units("surface_temperature"), "degF ");
    const ReadColumn& speed = *std::ranges::find(columns, "speed", &ReadColumn::name);
    EXPECT_EQ(speed.line, 1);
    EXPECT_EQ(speed.unit, "km/h");
    EXPECT_NEAR(speed.others.back().from_read.to_si(20.0), 72.0 * 1609.344 / 3600.0, 1e-9);
}

}  // namespace tiretherm::input
