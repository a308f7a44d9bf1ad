// SPDX-License-Identifier: BSD-3-Clause
// Wrong labels of the shipped logs are told and corrected; anything else that is wrong with them is not taken for one.
#include "diagnosis/data_faults/data_faults.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <optional>

#include <gmock/gmock.h>

#include "diagnosis/practice_bench.hpp"
#include "post/report/remark_text.hpp"

namespace tiretherm::diagnosis {

namespace {

using sample::Log;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr const char* surface = "surface_temperature [degC]";
constexpr const char* bulk = "bulk_temperature [degC]";

std::vector<double>& column(Log& log, const std::string& heading) {
    return log.columns[static_cast<std::size_t>(std::ranges::find(log.headings, heading) - log.headings.begin())];
}

void change(Log& log, const std::string& heading, const std::function<double(double)>& to) {
    std::ranges::transform(column(log, heading), column(log, heading).begin(), to);
}

double in_fahrenheit(double celsius) { return 1.8 * celsius + 32.0; }

/// What is found in logs, and the experiment without it.
struct FoundFaults {
    DataFaults faults;
    input::Experiment as_read;
};

FoundFaults look_for_faults(const std::vector<Log>& logs, const char* bench = "two_node_bench.toml") {
    const input::Written written;
    std::vector<std::filesystem::path> data;
    for (const Log& log : logs) {
        data.push_back(written.add(fmt::format("run{}.csv", data.size() + 1), log.text()));
    }
    const std::filesystem::path file = sample::practice() / bench;
    const auto read_again = [&](const DataCorrections& corrections) {
        auto read = input::read_experiment(file, data, input::ReadMode::measured, {}, corrections.columns).experiment;
        if (read) {
            mirror_inputs(*read, corrections.mirrored);
        }
        return read;
    };
    FoundFaults found{.faults = {}, .as_read = sample::read_bench(file, data)};
    found.faults = find_data_faults(found.as_read, read_again);
    return found;
}

/// The only fault of logs. @returns an empty one after a failure
DataFault only_fault(const std::vector<Log>& logs, const char* bench = "two_node_bench.toml") {
    const FoundFaults found = look_for_faults(logs, bench);
    EXPECT_EQ(found.faults.found.size(), 1U);
    return found.faults.found.empty() ? DataFault{.remark = remark::more_is_missing()} : found.faults.found.front();
}

std::vector<std::string> names_of_fault(const DataFault& fault) {
    std::vector<std::string> names;
    std::ranges::transform(fault.what.columns, std::back_inserter(names), &LabelledColumn::name);
    return names;
}

}  // namespace

// The readings are those of the shipped runs, in another unit. What is left without the fault is their noise of 0.5 and 0.3 K:
// 0.41 K together.
TEST(DataFaults, ASurfaceInFahrenheitIsReadInFahrenheit) {
    std::vector<Log> logs = sample::practice_logs();
    for (Log& log : logs) {
        change(log, surface, in_fahrenheit);
    }
    const FoundFaults found = look_for_faults(logs);
    ASSERT_EQ(found.faults.found.size(), 1U);
    const DataFault& fault = found.faults.found.front();
    EXPECT_EQ(fault.what.kind, Relabelling::Kind::unit);
    EXPECT_EQ(fault.what.unit, "degF");
    EXPECT_THAT(names_of_fault(fault), ElementsAre("surface_temperature"));
    EXPECT_TRUE(fault.scope.recordings.empty());
    EXPECT_NEAR(fault.after, std::sqrt(0.5 * (0.5 * 0.5 + 0.3 * 0.3)), 0.03);
    // 20 degC is written 68: read as Celsius 48 K too hot, read again as it was.
    ASSERT_TRUE(found.faults.corrected);
    const std::vector<double>& again = found.faults.corrected->runs[0].series[0].value;
    EXPECT_NEAR(again[0], 273.15 + sample::practice_logs()[0].columns[8][0], 1e-6);
    EXPECT_EQ(post::text_of(fault.remark).substr(0, 68),
              "The numbers of surface_temperature look like degF under a heading of");
    EXPECT_THAT(post::text_of(fault.remark), HasSubstr("in run1.csv, run2.csv and run3.csv (line 1), or write units = "
                                                       "{ surface_temperature = \"degF\" } in [data]."));
}

TEST(DataFaults, AFaultOfOneRunIsToldOfThatRun) {
    std::vector<Log> logs = sample::practice_logs();
    change(logs[1], surface, in_fahrenheit);
    const DataFault fault = only_fault(logs);
    EXPECT_EQ(fault.what.unit, "degF");
    EXPECT_THAT(fault.scope.recordings, ElementsAre("run2"));
    EXPECT_THAT(post::text_of(fault.remark), HasSubstr("in run2.csv (line 1)"));
}

TEST(DataFaults, AllReadingsInFahrenheitAreOneFault) {
    std::vector<Log> logs = sample::practice_logs();
    for (Log& log : logs) {
        change(log, surface, in_fahrenheit);
        change(log, bulk, in_fahrenheit);
    }
    EXPECT_THAT(names_of_fault(only_fault(logs)), ElementsAre("surface_temperature", "bulk_temperature"));
}

TEST(DataFaults, AirInFahrenheitIsAnInputInAnotherUnit) {
    std::vector<Log> logs = sample::practice_logs();
    for (Log& log : logs) {
        change(log, "air_temperature [degC]", in_fahrenheit);
    }
    const DataFault fault = only_fault(logs);
    EXPECT_EQ(fault.what.unit, "degF");
    EXPECT_THAT(names_of_fault(fault), ElementsAre("air_temperature"));
}

// 9.80665 N are a kilogram-force: a load that is a tenth makes so little heat that no loss within its prior makes up for it.
TEST(DataFaults, ALoadInKilogramForceIsTold) {
    std::vector<Log> logs = sample::practice_logs();
    for (Log& log : logs) {
        change(log, "vertical_load [N]", [](double newton) { return newton / 9.80665; });
    }
    const DataFault fault = only_fault(logs);
    EXPECT_EQ(fault.what.unit, "kgf");
    EXPECT_THAT(names_of_fault(fault), ElementsAre("vertical_load"));
}

TEST(DataFaults, ExchangedSensorsAreReadTheOtherWayRound) {
    std::vector<Log> logs = sample::practice_logs();
    for (Log& log : logs) {
        std::swap(column(log, surface), column(log, bulk));
    }
    const DataFault fault = only_fault(logs);
    EXPECT_EQ(fault.what.kind, Relabelling::Kind::exchange);
    EXPECT_THAT(names_of_fault(fault), ElementsAre("surface_temperature", "bulk_temperature"));
    EXPECT_THAT(post::text_of(fault.remark), HasSubstr("exchanged (swapped)"));
}

// The log of the wheel on the other side: its load is as much below the mean as this one's is above, its lateral force goes with the
// load.
TEST(DataFaults, MirroredInputsAreThoseOfTheWheelOnTheOtherSide) {
    input::Experiment experiment = sample::practice_bench();
    const solver::InputSignals before = experiment.runs[1].problem.input_signals;
    mirror_inputs(experiment, {1});
    const solver::InputSignals& other = experiment.runs[1].problem.input_signals;
    const std::vector<double> load = sample::practice_logs()[1].columns[2];
    const double both = 2.0 * std::accumulate(load.begin(), load.end(), 0.0) / static_cast<double>(load.size());
    for (const double t : {400.0, 1000.0, 1600.0}) {
        const physics::Inputs here = before.at(t, solver::JumpSide::after);
        const physics::Inputs there = other.at(t, solver::JumpSide::after);
        EXPECT_NEAR(there.vertical_load, both - here.vertical_load, 1e-9);
        EXPECT_NEAR(there.lateral_force * here.vertical_load, -here.lateral_force * there.vertical_load, 1e-6);
        EXPECT_EQ(there.slip_angle, -here.slip_angle);
        EXPECT_EQ(there.speed, here.speed);
    }
}

TEST(DataFaults, LogsWithoutFaultsCostOneSimulationOfEachRun) {
    const FoundFaults found = look_for_faults(sample::practice_logs());
    EXPECT_TRUE(found.faults.found.empty());
    EXPECT_EQ(found.faults.simulations, 3);
}

// None of these is a wrong label: a gain of 5 %, an emissivity of 0.9 (10 % of the rise over the air), an error of 10 K that grows
// with time, a surface that is 12 K too hot while the tire rolls.
TEST(DataFaults, OtherErrorsAreNoFaultsOfLabels) {
    const std::vector<std::function<void(Log&)>> errors{
        [](Log& log) { change(log, surface, [](double degrees) { return 1.05 * degrees; }); },
        [](Log& log) { change(log, surface, [](double degrees) { return 0.9 * degrees + 2.0; }); },
        [](Log& log) {
            std::vector<double>& values = column(log, bulk);
            for (std::size_t i = 0; i < values.size(); ++i) {
                values[i] += 20.0 * static_cast<double>(i) / static_cast<double>(values.size());
            }
        },
        [](Log& log) {
            for (std::size_t i = 0; i < log.columns.front().size(); ++i) {
                column(log, surface)[i] += column(log, "speed [km/h]")[i] > 30.0 ? 12.0 : 0.0;
            }
        }};
    for (std::size_t i = 0; i < errors.size(); ++i) {
        std::vector<Log> logs = sample::practice_logs();
        std::ranges::for_each(logs, errors[i]);
        EXPECT_TRUE(look_for_faults(logs).faults.found.empty()) << "error " << i;
    }
}

// A probe and a second one beside it: whichever is which, both orders fit alike.
TEST(DataFaults, SensorsThatReadAlikeAreNotCalledExchanged) {
    std::vector<Log> logs = sample::practice_logs();
    for (Log& log : logs) {
        change(log, bulk, [](double degrees) { return degrees + 15.0; });
        column(log, surface) = column(log, bulk);
    }
    EXPECT_TRUE(look_for_faults(logs).faults.found.empty());
}

TEST(DataFaults, ALogOfOneSensorCanBeInFahrenheit) {
    std::vector<Log> logs = sample::practice_logs();
    for (Log& log : logs) {
        change(log, bulk, in_fahrenheit);
        const auto at = std::ranges::find(log.headings, surface) - log.headings.begin();
        log.headings.erase(log.headings.begin() + at);
        log.columns.erase(log.columns.begin() + at);
    }
    EXPECT_THAT(names_of_fault(only_fault(logs)), ElementsAre("bulk_temperature"));
}

}  // namespace tiretherm::diagnosis
