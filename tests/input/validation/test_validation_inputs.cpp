// SPDX-License-Identifier: BSD-3-Clause
// Inputs of experiments in a validation table: each way to change a case or a reading, at both ends of a range, against
// the times and values that follow by hand.

#include <cmath>

#include <gtest/gtest.h>

#include "input/validation/input_definition.hpp"
#include "input/validation/validation.hpp"
#include "support/written.hpp"

namespace tiretherm::input {

namespace {

/// 20 s at 100 km/h, then 40 s at 50 km/h.
constexpr std::string_view drive = R"(
[effects.still_air]
[drive]
air_temperature = "23 degC"
[[drive.schedule]]
columns = ["time [s]", "speed [km/h]"]
rows = [[0, 100], [20, 100], [20, 50], [60, 50]]
[[sensor]]
name = "inside"
kind = "point"
depth = "8 mm"
)";

constexpr std::string_view number = R"(
[[number]]
id = "A"
what = "a number"
case = "warm"
models = ["section"]
channel = "top"
take = "max"
from = "10 s"
to = "30 s"
value = "85 degC"
uncertainty = "2 K"
source = "page 1"
)";

std::string input(std::string_view standing, std::string_view body) {
    return "[[input]]\nname = \"x\"\nmeaning = \"an input\"\nstanding = \"" + std::string(standing) + "\"\n" +
           std::string(body);
}

class InputTable : public testing::Test {
protected:
    InputTable() {
        for (const char* name : {"warm_section.toml", "cold_section.toml"}) {
            written_.add(name, std::string(slab) + std::string(drive));
        }
    }
    Validation read(const std::string& table) const {
        ValidationReading reading = read_validation(written_.add("table.toml", table));
        EXPECT_TRUE(reading.table.has_value()) << render(CaseFindings{.errors = reading.errors, .warnings = {}});
        return reading.table ? std::move(*reading.table) : Validation{};
    }
    /// The first error of a table.
    std::string error(const std::string& table) const {
        const ValidationReading reading = read_validation(written_.add("table.toml", table));
        for (const InputError& found : reading.errors) {
            EXPECT_TRUE(found.file.ends_with("table.toml")) << found.file;
        }
        return reading.errors.empty() ? "no error" : reading.errors.front().what;
    }
    Written written_;
};

/// The readout of the section at an end of the only input of the first number.
const Readout& at_end(const Validation& table, std::size_t end) {
    return table.numbers.at(0).inputs.at(0).at_ends.at(end).at(1).value().of.of;
}

double speed(const Validation& table, std::size_t run, double t) {
    return 3.6 * table.runs.at(run).problem.input_signals.at(t, solver::JumpSide::after).speed;
}

}  // namespace

// The case as it is and two changed ones; the unchanged number is read from the unchanged case.
TEST_F(InputTable, KeyIsWrittenIntoACaseOfItsOwnForEachEnd) {
    const Validation table = read(input("assumed",
                                        "keys = [\"drive.air_temperature\", \"initial.temperature\"]\n"
                                        "value = \"23 degC\"\nrange = [\"18 degC\", \"301.15 K\"]\n") +
                                  std::string(number) + "inputs = [\"x\"]\n");
    ASSERT_EQ(table.runs.size(), 3U);
    EXPECT_EQ(table.numbers[0].models[1].value().of.of.run, 0U);
    const auto air = [&](std::size_t end) {
        return table.runs[at_end(table, end).run]
            .problem.input_signals.at(0.0, solver::JumpSide::after)
            .air_temperature;
    };
    EXPECT_DOUBLE_EQ(air(0), 273.15 + 18.0);
    EXPECT_NEAR(air(1), 273.15 + 28.0, 1e-9);
    EXPECT_EQ(table.runs[at_end(table, 0).run].changed, "x = 18 degC");
    EXPECT_EQ(table.inputs.at(0).standing, Standing::assumed);
    EXPECT_EQ(table.numbers[0].inputs[0].at_ends[0][0], std::nullopt);  // no two-node model
}

// A part of 20 s takes 50 s: what follows comes 30 s later, the end at 90 s; 10 s, its middle, becomes 25 s. In 5 s: 15 s
// earlier.
TEST_F(InputTable, PartOfAScheduleIsStretchedWithAllTimesThatFollow) {
    const Validation table = read(input("inferred",
                                        "between = [[\"0 s\", \"20 s\"]]\nvalue = \"20 s\"\n"
                                        "range = [\"5 s\", \"50 s\"]\n") +
                                  std::string(number) + "inputs = [\"x\"]\n");
    const Readout& shorter = at_end(table, 0);
    EXPECT_DOUBLE_EQ(table.runs.at(shorter.run).problem.settings.end, 45.0);
    EXPECT_DOUBLE_EQ(shorter.window.from, 2.5);
    EXPECT_DOUBLE_EQ(shorter.window.to, 15.0);
    const Readout& longer = at_end(table, 1);
    EXPECT_DOUBLE_EQ(table.runs.at(longer.run).problem.settings.end, 90.0);
    EXPECT_DOUBLE_EQ(longer.window.from, 25.0);
    EXPECT_DOUBLE_EQ(longer.window.to, 60.0);
    EXPECT_NEAR(speed(table, longer.run, 49.0), 100.0, 1e-9);
    EXPECT_NEAR(speed(table, longer.run, 51.0), 50.0, 1e-9);
    EXPECT_NEAR(speed(table, shorter.run, 6.0), 50.0, 1e-9);
}

// Parts of 10 s from 0 s and from 20 s, each 15 s: 5 s is half of the first, 7.5 s; 20 s lies behind it, 25 s; 40 s
// behind both, 50 s.
TEST(MovedMoment, IsLaterByWhatThePartsBeforeItTakeLonger) {
    const std::vector<SchedulePart> parts{{.begin = 0.0, .end = 10.0}, {.begin = 20.0, .end = 30.0}};
    EXPECT_DOUBLE_EQ(moved_moment(5.0, parts, 15.0), 7.5);
    EXPECT_DOUBLE_EQ(moved_moment(20.0, parts, 15.0), 25.0);
    EXPECT_DOUBLE_EQ(moved_moment(40.0, parts, 15.0), 50.0);
    EXPECT_DOUBLE_EQ(moved_moment(-1.0, parts, 15.0), -1.0);
}

TEST_F(InputTable, EntriesOfAScheduleThatHaveTheValueAreChanged) {
    const Validation table = read(input("assumed",
                                        "signal = \"speed\"\nvalue = \"100 km/h\"\n"
                                        "range = [\"80 km/h\", \"120 km/h\"]\n") +
                                  std::string(number) + "inputs = [\"x\"]\n");
    EXPECT_NEAR(speed(table, at_end(table, 1).run, 10.0), 120.0, 1e-9);
    EXPECT_NEAR(speed(table, at_end(table, 1).run, 40.0), 50.0, 1e-9);
}

TEST_F(InputTable, AnotherSensorCaseOrShareIsReadWithoutAFurtherCase) {
    const Validation sensor = read(input("assumed", "reads = \"channel\"\nvalue = \"top\"\nrange = [\"inside\"]\n") +
                                   std::string(number) + "inputs = [\"x\"]\n");
    EXPECT_EQ(at_end(sensor, 0).channel, 1U);
    EXPECT_EQ(sensor.runs.size(), 1U);
    const Validation other = read(input("assumed", "reads = \"case\"\nvalue = \"warm\"\nrange = [\"cold\"]\n") +
                                  std::string(number) + "inputs = [\"x\"]\n");
    EXPECT_EQ(other.runs.at(at_end(other, 0).run).file.filename(), "cold_section.toml");
    const Validation share =
        read(input("assumed", "reads = \"time_to\"\nvalue = 0.95\nrange = [0.9, \"98 %\"]\n") +
             "[[number]]\nid = \"A\"\nwhat = \"a\"\ncase = \"warm\"\nmodels = [\"section\"]\nchannel = \"top\"\n"
             "time_to = \"95 %\"\nbelow = \"60 s\"\nsource = \"page 1\"\ninputs = [\"x\"]\n");
    EXPECT_DOUBLE_EQ(at_end(share, 0).window.share, 0.9);
    EXPECT_DOUBLE_EQ(at_end(share, 1).window.share, 0.98);
}

// The subtracted value is read at 0 s, where the part has not begun.
TEST_F(InputTable, InputActsOnWhatIsSubtractedToo) {
    const Validation table = read(input("assumed",
                                        "between = [[\"0 s\", \"20 s\"]]\nvalue = \"20 s\"\n"
                                        "range = [\"5 s\", \"50 s\"]\n") +
                                  "[[number]]\nid = \"A\"\nwhat = \"a\"\ncase = \"warm\"\nmodels = [\"section\"]\n"
                                  "channel = \"top\"\nat = \"20 s\"\nminus = { at = \"0 s\" }\nabove = \"0 K\"\n"
                                  "source = \"page 1\"\ninputs = [\"x\"]\n");
    const Difference& difference = table.numbers.at(0).inputs.at(0).at_ends.at(1).at(1).value().of;
    EXPECT_DOUBLE_EQ(difference.of.window.to, 50.0);
    EXPECT_DOUBLE_EQ(difference.minus.value().window.to, 0.0);
    EXPECT_EQ(difference.minus->run, difference.of.run);
}

TEST_F(InputTable, PrintedInputMakesNoRunAndIsCheckedAgainstTheCase) {
    const std::string use = std::string(number) + "inputs = [\"x\"]\n";
    const Validation table = read(input("printed", "keys = [\"drive.air_temperature\"]\nvalue = \"296.15 K\"\n") + use);
    EXPECT_EQ(table.runs.size(), 1U);
    EXPECT_EQ(table.inputs.at(0).number, 296.15);
    EXPECT_TRUE(table.numbers.at(0).inputs.at(0).at_ends.empty());
    EXPECT_EQ(error(input("printed", "keys = [\"drive.air_temperature\"]\nvalue = \"25 degC\"\n") + use),
              "the value is 25 degC, but warm_section has \"23 degC\"");
}

TEST_F(InputTable, InputThatANumberWasUsedToInferIsMarked) {
    const std::string keys =
        "keys = [\"drive.air_temperature\"]\nvalue = \"23 degC\"\nrange = [\"18 degC\", \"28 degC\"]\n";
    const std::string use = std::string(number) + "inferred_from_it = [\"x\"]\n";
    EXPECT_TRUE(read(input("inferred", keys) + use).numbers.at(0).inputs.at(0).inferred_from_it);
    EXPECT_EQ(error(input("assumed", keys) + use), "the input \"x\" is assumed, not inferred");
}

// A wrong end is an error of the case, shown at its place in the table.
TEST_F(InputTable, EndThatTheCaseRefusesIsReportedWhereItIsWritten) {
    EXPECT_EQ(error(input("assumed",
                          "keys = [\"effects.still_air.h\"]\nadds_keys = true\nvalue = \"10 W/m2K\"\n"
                          "range = [\"-5 W/m2K\", \"15 W/m2K\"]\n") +
                    std::string(number) + "inputs = [\"x\"]\n"),
              "h is \"-5 W/m2K\"; it must be between 0 W/m2K and 1e+06 W/m2K");
}

TEST_F(InputTable, ExperimentsThatAreNotWantedTakeTheRunsOfTheirInputsWithThem) {
    const std::string keys =
        "keys = [\"drive.air_temperature\"]\nvalue = \"23 degC\"\nrange = [\"18 degC\", \"28 degC\"]\n";
    Validation table = read(input("assumed", keys) + std::string(number) + "inputs = [\"x\"]\n" +
                            "[[number]]\nid = \"B\"\nwhat = \"b\"\ncase = \"cold\"\nmodels = [\"section\"]\n"
                            "channel = \"top\"\ninputs = [\"x\"]\n");
    EXPECT_EQ(table.runs.size(), 6U);
    EXPECT_TRUE(table.keep({"B"}).empty());
    ASSERT_EQ(table.runs.size(), 3U);
    EXPECT_EQ(table.runs.at(at_end(table, 1).run).changed, "x = 28 degC");
}

}  // namespace tiretherm::input
