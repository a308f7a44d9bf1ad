// SPDX-License-Identifier: BSD-3-Clause
// Measured runs from HDF5: datasets as columns, results of the program read back, and files that are refused.

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "input/measurements/measured_bench.hpp"
#include "post/fields/hdf5_file.hpp"

namespace tiretherm::input {

namespace {

using Values = std::vector<double>;

/// Writes datasets of numbers with their units.
class Writer {
public:
    explicit Writer(const std::filesystem::path& path) : file_(path) {}
    void add(const std::string& path, const Values& values, const std::string& units) {
        file_.write(path, values, 0, {.units = units, .long_name = "", .source = "", .coordinates = ""});
    }
    post::Hdf5File& file() { return file_; }

private:
    post::Hdf5File file_;
};

/// The bench over a file `run.h5`. @param tables of the case
ExperimentReading read_hdf5(const std::function<void(Writer&)>& write, std::string_view tables = "") {
    const Written written;
    {
        Writer writer(written.folder() / "run.h5");
        write(writer);
    }
    return read_experiment(written.add("case.toml", std::string(bench) + std::string(tables) +
                                                        "[[run]]\nfile = \"run.h5\"\nunits = { V = \"km/h\" }\n"
                                                        "columns = { V = \"speed\" }\n"));
}

/// @param folder "" or a group's path
void write_sound(Writer& writer, const std::string& folder) {
    writer.add(folder + "/time", {0, 10, 20}, "s");
    writer.add(folder + "/V", {36, 54, 72}, "");
    writer.add(folder + "/vertical_load", {4, 4, 5}, "kN");
    writer.add(folder + "/air_temperature", {25, 25, 26}, "degC");
    writer.add(folder + "/road_temperature", {298.15, 298.15, 299.15}, "K");
    writer.add(folder + "/bulk_temperature", {25, std::nan(""), 27}, "degC");
    writer.add(folder + "/throttle", {0.1, 0.2, 0.3}, "1");
}

void expect_sound(const ExperimentReading& reading) {
    ASSERT_TRUE(reading.experiment.has_value()) << error_report(reading);
    const MeasuredRun& run = reading.experiment->runs.front();
    EXPECT_EQ(run.name, "run");
    EXPECT_EQ(run.time, (Values{0, 10, 20}));
    const physics::Inputs inputs = run.problem.input_signals.at(15.0, solver::JumpSide::after);
    EXPECT_NEAR(inputs.speed, 17.5, 1e-12);
    EXPECT_NEAR(inputs.vertical_load, 4500.0, 1e-9);
    ASSERT_EQ(run.series.size(), 1U);
    EXPECT_NEAR(run.series[0].value[0], 298.15, 1e-9);
    EXPECT_TRUE(std::isnan(run.series[0].value[1]));
    ASSERT_EQ(run.unused.size(), 1U);
    EXPECT_EQ(run.unused[0].value, (Values{0.1, 0.2, 0.3}));
}

std::string only_error(const ExperimentReading& reading) {
    EXPECT_FALSE(reading.experiment.has_value());
    EXPECT_EQ(reading.errors.size(), 1U) << error_report(reading);
    return reading.errors.empty() ? "" : reading.errors[0].what + " | " + reading.errors[0].remedy;
}

}  // namespace

TEST(Hdf5, DatasetsOfTheRootAreColumns) {
    expect_sound(read_hdf5([](Writer& writer) { write_sound(writer, ""); }));
}

TEST(Hdf5, DatasetsMayStandInOneGroup) {
    expect_sound(read_hdf5([](Writer& writer) {
        writer.file().add_group("/about");
        writer.file().write("/about/rig", std::string("rig 3"), {});
        writer.file().add_group("/run");
        write_sound(writer, "/run");
    }));
}

TEST(Hdf5, InSeveralGroupsNobodyKnowsWhich) {
    EXPECT_EQ(only_error(read_hdf5([](Writer& writer) {
                  for (const char* group : {"/warm_up", "/test"}) {
                      writer.file().add_group(group);
                      write_sound(writer, group);
                  }
              })),
              "several groups of the file hold datasets: test and warm_up | keep the run's datasets in the root or in "
              "one group");
}

// results.h5 of a run: temperatures of its channels against time, and much else of other lengths that is no column.
TEST(Hdf5, WhatTirethermWroteIsReadBack) {
    const auto write = [](Writer& writer) {
        writer.file().add_attribute("/", "format", std::string("tiretherm results 1"));
        for (const char* group : {"/channels", "/field", "/mesh"}) {
            writer.file().add_group(group);
        }
        writer.add("/channels/time", {0, 1, 5}, "s");
        writer.add("/channels/bulk_temperature", {300, 301, 302}, "K");
        writer.add("/field/time", {0, 5}, "s");
        writer.add("/mesh/volume", {1, 2, 3, 4}, "m3");
    };
    const Written written;
    {
        Writer writer(written.folder() / "results.h5");
        write(writer);
    }
    const ExperimentReading reading = read_experiment(
        written.add("case.toml", std::string(bench) + "[drive]\nspeed = \"80 km/h\"\nvertical_load = \"4000 N\"\n"
                                                      "air_temperature = \"23 degC\"\nroad_temperature = \"23 degC\"\n"
                                                      "[[run]]\nfile = \"results.h5\"\n"));
    ASSERT_TRUE(reading.experiment.has_value()) << error_report(reading);
    const MeasuredRun& run = reading.experiment->runs.front();
    EXPECT_EQ(run.time, (Values{0, 1, 5}));
    ASSERT_EQ(run.series.size(), 1U);
    EXPECT_EQ(run.series[0].value, (Values{300, 301, 302}));
    EXPECT_EQ(run.problem.settings.end, 5.0);
}

TEST(Hdf5, ADatasetWithoutUnitIsNamed) {
    EXPECT_EQ(only_error(read_hdf5([](Writer& writer) {
                  write_sound(writer, "");
                  writer.add("/camber", {0, 1, 0}, "");
              })),
              "the column camber has no unit | give the dataset an attribute units = \"deg\", or say it in the case: "
              "units = { camber = \"deg\" }");
}

TEST(Hdf5, DatasetsOfOtherLengthsAreNamed) {
    EXPECT_EQ(only_error(read_hdf5([](Writer& writer) {
                  write_sound(writer, "");
                  writer.add("/camber", {0, 1}, "deg");
              })),
              "the dataset camber has 2 values, time has 3 | let all datasets of the run have one length");
}

TEST(Hdf5, AWrongValueIsFoundByItsNumber) {
    EXPECT_EQ(only_error(read_hdf5([](Writer& writer) {
                  write_sound(writer, "");
                  writer.add("/slip_angle", {0, 1, 100}, "deg");
              })),
              "slip_angle is 100 deg; it must be between -81 deg and 81 deg (value 3) | leave the field empty where "
              "nothing was measured");
}

TEST(Hdf5, AFileThatWasCutOffIsRefused) {
    const Written written;
    const std::filesystem::path file = written.folder() / "run.h5";
    {
        Writer writer(file);
        write_sound(writer, "");
    }
    std::filesystem::resize_file(file, std::filesystem::file_size(file) / 2);
    const std::string error =
        only_error(read_experiment(written.add("case.toml", std::string(bench) + "[[run]]\nfile = \"run.h5\"\n")));
    EXPECT_NE(error.find("run.h5 is HDF5, but cannot be opened: it is cut off, damaged or still being written | "),
              std::string::npos)
        << error;
}

TEST(Hdf5, AFileOfNothingButTextHasNoColumns) {
    EXPECT_EQ(
        only_error(read_hdf5([](Writer& writer) { writer.file().write("/note", std::string("nothing"), {}); })),
        "the file holds no datasets of numbers in one dimension | write one for the time and one for each signal, "
        "in the root or in one group");
}

}  // namespace tiretherm::input
