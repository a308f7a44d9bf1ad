// SPDX-License-Identifier: BSD-3-Clause
// [diagnose] signals and ignore decide which columns may be causes.

#include <cmath>

#include <gtest/gtest.h>

#include "input/columns/column_kinds.hpp"
#include "input/measurements/made_up_log.hpp"

namespace tiretherm::input {

namespace {

/// Five columns that the model does not use, of which throttle and two brakes are drives.
MadeUpLog log_with_columns() {
    MadeUpLog log(200, 2.0);
    log.add("speed", "km/h", [](double t) { return t < 20.0 ? 0.0 : 80.0 + 20.0 * std::sin(t / 13.0); });
    log.add("vertical_load", "N", [](double) { return 4000.0; });
    log.add("air_temperature", "degC", [](double) { return 25.0; });
    log.add("road_temperature", "degC", [](double) { return 30.0; });
    log.add("bulk_temperature", "degC",
            [](double t) { return 45.0 - 20.0 * std::exp(-t / 150.0) + 0.1 * std::sin(t); });
    log.add("throttle", "-", [](double t) { return std::sin(t / 5.0) > 0.3 ? 1.0 : 0.0; });
    log.add("brake_front", "bar", [](double t) { return std::sin(t / 7.0) > 0.6 ? 1.0 : 0.0; });
    log.add("brake_rear", "bar", [](double t) { return std::sin(t / 3.0) > 0.8 ? 1.0 : 0.0; });
    log.add("ir_1", "degC", [](double t) { return 30.0 + 5.0 * std::sin(t / 60.0); });
    log.add("ir_2", "degC", [](double t) { return 31.0 + 5.0 * std::sin(t / 50.0); });
    return log;
}

std::vector<std::string> causes(const ExperimentReading& reading) {
    std::vector<std::string> names;
    EXPECT_TRUE(reading.experiment.has_value()) << error_report(reading);
    if (reading.experiment) {
        for (const ColumnSummary& column : unused_columns(reading.experiment->runs)) {
            if (column.may_be_cause) {
                names.push_back(column.name);
            }
        }
    }
    return names;
}

using Names = std::vector<std::string>;

}  // namespace

TEST(ColumnChoice, WithoutItDrivesAreTried) {
    EXPECT_EQ(causes(read_logs({log_with_columns()})), (Names{"throttle", "brake_front", "brake_rear"}));
}

TEST(ColumnChoice, SignalsAreTriedWhateverTheyAre) {
    EXPECT_EQ(causes(read_logs({log_with_columns()}, "[diagnose]\nsignals = [\"throttle\", \"ir_?\"]\n")),
              (Names{"throttle", "ir_1", "ir_2"}));
    EXPECT_EQ(causes(read_logs({log_with_columns()}, "[diagnose]\nsignals = []\n")), Names{});
}

TEST(ColumnChoice, WhatIsIgnoredIsNot) {
    EXPECT_EQ(causes(read_logs({log_with_columns()}, "[diagnose]\nignore = [\"brake_*\"]\n")), Names{"throttle"});
    const ExperimentReading both =
        read_logs({log_with_columns()}, "[diagnose]\nsignals = [\"*\"]\nignore = [\"brake_*\", \"ir_2\"]\n");
    EXPECT_EQ(causes(both), (Names{"throttle", "ir_1"}));
    const std::vector<ColumnSummary> columns = unused_columns(both.experiment->runs);
    EXPECT_EQ(columns[1].reason, "left out by ignore of [diagnose]");
}

TEST(ColumnChoice, WhatNoRunHasIsReported) {
    const ExperimentReading reading = read_logs(
        {log_with_columns()}, "[diagnose]\nsignals = [\"throtle\", \"fan_*\", \"speed\", \"bulk_temperature\"]\n");
    EXPECT_FALSE(reading.experiment.has_value());
    ASSERT_EQ(reading.errors.size(), 4U);
    EXPECT_EQ(reading.errors[0].what, "no column that the model does not use is called \"throtle\"");
    EXPECT_EQ(reading.errors[0].remedy, "did you mean `throttle`?");
    EXPECT_EQ(reading.errors[1].remedy, "the columns are throttle, brake_front, brake_rear, ir_1 and ir_2");
    EXPECT_EQ(reading.errors[2].what, "speed is an input of the model, which is always tried");
    EXPECT_EQ(reading.errors[3].what, "bulk_temperature is a sensor: what it reads is an effect and no cause");
}

TEST(ColumnChoice, ToIgnoreWhatIsNotThereIsAWarning) {
    const ExperimentReading reading = read_logs({log_with_columns()}, "[diagnose]\nignore = [\"fan_*\"]\n");
    ASSERT_TRUE(reading.experiment.has_value()) << error_report(reading);
    ASSERT_EQ(reading.warnings.size(), 1U);
    EXPECT_TRUE(
        reading.warnings.front().ends_with("ignore of [diagnose] names \"fan_*\", which is no column that the model "
                                           "does not use: the columns are throttle, "
                                           "brake_front, brake_rear, ir_1 and ir_2"))
        << reading.warnings.front();
}

}  // namespace tiretherm::input
