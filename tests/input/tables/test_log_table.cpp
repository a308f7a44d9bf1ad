// SPDX-License-Identifier: BSD-3-Clause
// A file is read once for all corners, runs, passes and surveys of a command, whatever its format.

#include <cmath>

#include <gtest/gtest.h>

#include "input/log_survey/log_survey.hpp"
#include "input/loggers/ld_writer.hpp"
#include "input/measurements/measured_bench.hpp"
#include "input/runs/runs.hpp"
#include "input/tables/data_file.hpp"
#include "input/text/table_shelf.hpp"
#include "input/toml/document.hpp"
#include "post/fields/hdf5_file.hpp"
#include "support/written.hpp"

namespace tiretherm::input {

namespace {

std::vector<double> read_column(const DataFile& file, int column, InputErrors& errors) {
    std::vector<std::vector<double>> read =
        file.read({{.column = column, .name = "x", .spec = {.unit = "1"}, .purpose = Purpose::measured}}, errors);
    return read.empty() ? std::vector<double>{} : std::move(read.front());
}

/// Four corners with a surface temperature each, and a road temperature that [[drive.file]] takes from the same file.
std::string car_with(const std::string& file) {
    std::string text(bench);
    for (const char* corner : {"FL", "FR", "RL", "RR"}) {
        text += fmt::format("[[corner]]\nname = \"{0}\"\ncolumns = {{ S_{0} = \"surface_temperature\" }}\n", corner);
    }
    return fmt::format(
        "{0}[[drive.file]]\npath = \"{1}\"\nignore = [\"speed\", \"vertical_load\", \"air_temperature\"]\n"
        "[[run]]\nfile = \"{1}\"\nignore = [\"road_temperature\"]\n",
        text, file);
}

struct CarColumn {
    std::string name;
    std::string unit;
    std::vector<int> values;
};
const std::vector<CarColumn>& car_columns_at_1_hz() {
    static const std::vector<CarColumn> columns{{"speed", "km/h", {36, 54, 72}},
                                                {"vertical_load", "N", {4000, 4100, 4200}},
                                                {"air_temperature", "degC", {25, 25, 26}},
                                                {"road_temperature", "degC", {30, 30, 31}},
                                                {"S_FL", "degC", {30, 31, 32}},
                                                {"S_FR", "degC", {31, 32, 33}},
                                                {"S_RL", "degC", {32, 33, 34}},
                                                {"S_RR", "degC", {33, 34, 35}}};
    return columns;
}

std::string car_csv() {
    std::string text = "time [s]";
    for (const CarColumn& column : car_columns_at_1_hz()) {
        text += fmt::format(",{} [{}]", column.name, column.unit);
    }
    for (std::size_t k = 0; k < 3; ++k) {
        text += fmt::format("\n{}", k);
        for (const CarColumn& column : car_columns_at_1_hz()) {
            text += fmt::format(",{}", column.values[k]);
        }
    }
    return text + "\n";
}

std::string car_ld() {
    std::vector<made_up::LdChannel> channels;
    for (const CarColumn& column : car_columns_at_1_hz()) {
        channels.push_back(made_up::integers(column.name, column.unit, 1, column.values));
    }
    return made_up::LdWriter::file(channels);
}

void write_car_hdf5(const std::filesystem::path& path) {
    post::Hdf5File file(path);
    const auto add = [&](const std::string& name, const std::vector<double>& values, const std::string& unit) {
        file.write("/" + name, values, 0, {.units = unit, .long_name = "", .source = "", .coordinates = ""});
    };
    add("time", {0, 1, 2}, "s");
    for (const CarColumn& column : car_columns_at_1_hz()) {
        add(column.name, {column.values.begin(), column.values.end()}, column.unit);
    }
}

}  // namespace

// A run at each of four corners and [[drive.file]] at each of them: eight openings of one file. Of the surface at FR 32 degC at 1 s.
TEST(LogTable, IsReadOnceForAllCornersAndTheDrive) {
    const Written written;
    written.add("log.csv", car_csv());
    written.add("log.ld", car_ld());
    write_car_hdf5(written.folder() / "log.h5");
    for (const std::string file : {"log.csv", "log.ld", "log.h5"}) {
        InputErrors errors;
        const auto document = read_document(written.add("case.toml", car_with(file)), errors);
        ASSERT_TRUE(document);
        const Runs runs = read_runs(*document, "case", {}, ReadMode::measured, errors);
        std::string said;
        for (const InputError& error : errors.in_order()) {
            said += render(error);
        }
        ASSERT_EQ(said, "") << file;
        ASSERT_EQ(runs.experiment.runs.size(), 4U);
        EXPECT_DOUBLE_EQ(runs.experiment.runs[1].series.front().value[1], 305.15) << file;
        EXPECT_DOUBLE_EQ(
            runs.experiment.runs[3].problem.input_signals.at(2.0, solver::JumpSide::after).road_temperature, 304.15)
            << file;
        EXPECT_EQ(errors.tables().files_read, 1U) << file;
    }
}

// The new case of a log is checked with the log's table: others that share the tables read nothing, and name the file as they found it.
TEST(LogTable, IsSharedByErrorsOfItsOwn) {
    const Written written;
    const auto path = written.add("log.csv", "time [s],a\n0,1\n1,wet\n");
    InputErrors of_log;
    const auto first = DataFile::open(path, {}, of_log);
    InputErrors of_case;
    of_case.add_file("case.toml", "");
    of_case.share_tables(of_log);
    const auto second = DataFile::open(written.folder() / "." / "log.csv", {}, of_case);
    ASSERT_TRUE(first && second);
    EXPECT_EQ(&first->table(), &second->table());
    EXPECT_EQ(of_log.tables().files_read, 1U);
    EXPECT_TRUE(read_column(*second, 1, of_case).empty());
    ASSERT_EQ(of_case.count(), 1U);
    EXPECT_EQ(of_case.in_order().front().line, 3);
    EXPECT_EQ(of_case.in_order().front().source, "1,wet");
    EXPECT_EQ(of_case.in_order().front().file, (written.folder() / "." / "log.csv").generic_string());
}

// A comment and a blank line after each hundred rows: row 700, counted from 0, is line 1 + 701 + 2 * 7.
TEST(LogTable, AWrongFieldHasItsLineHoweverFarDown) {
    const Written written;
    std::string lines = "time [s],a\n";
    for (int i = 0; i < 1000; ++i) {
        lines += fmt::format("{}{},{}\n", i > 0 && i % 100 == 0 ? "# lap\n\n" : "", i, i == 700 ? "wet" : "1");
    }
    const auto path = written.add("log.csv", lines);
    InputErrors errors;
    const auto file = DataFile::open(path, {}, errors);
    ASSERT_TRUE(file);
    EXPECT_TRUE(read_column(*file, 1, errors).empty());
    ASSERT_EQ(errors.count(), 1U);
    EXPECT_EQ(errors.in_order().front().line, 716);
    EXPECT_EQ(errors.in_order().front().column, 5);
    EXPECT_EQ(errors.in_order().front().what, "x is \"wet\"; a number is wanted");
    EXPECT_EQ(file->spot(701).place.line, 717);
}

// A text of more than 4 MB is let go once its numbers are read: 400 000 rows of "1,1" and a line end are less, of 13 bytes more. The
// message reads it again, unless the file has been changed meanwhile.
TEST(LogTable, AWrongFieldOfALongFileHasItsLine) {
    const Written written;
    std::string lines = "time [s],a\n";
    for (int i = 0; i < 400'000; ++i) {
        lines += i == 300'000 ? "300000,wet  \n" : fmt::format("{:<6},1.0000\n", i);
    }
    const auto path = written.add("log.csv", lines);
    const auto error_of = [&](bool is_changed) {
        written.add("log.csv", lines);
        InputErrors errors;
        const auto file = DataFile::open(path, {}, errors);
        if (is_changed) {
            written.add("log.csv", "time [s],a\n0,1\n");
        }
        EXPECT_TRUE(read_column(file.value(), 1, errors).empty());
        return errors.in_order().at(0);
    };
    EXPECT_EQ(error_of(false).line, 300'002);
    EXPECT_EQ(error_of(false).source, "300000,wet  ");
    EXPECT_EQ(error_of(true).line, 0);
}

// What a logger writes where a sensor gives nothing is no error: single 9999 and -999, and 1037 for the first three samples. A column that
// is out of range all along has another unit.
TEST(LogTable, CodesOfADeadSensorAreMissing) {
    const auto read = [](const std::vector<std::string>& fields, std::size_t n_errors, const std::string& warning) {
        const Written written;
        std::string lines = "time [s],T [degC]\n";
        for (std::size_t i = 0; i < fields.size(); ++i) {
            lines += fmt::format("{},{}\n", i, fields[i]);
        }
        InputErrors errors;
        const auto file = DataFile::open(written.add("log.csv", lines), {}, errors);
        const QuantitySpec air{.unit = "K", .low = 200.0, .high = 400.0};
        const auto values = file->read({{.column = 1, .name = "T", .spec = air, .purpose = Purpose::measured}}, errors);
        EXPECT_EQ(errors.count(), n_errors) << fields.front();
        EXPECT_EQ(errors.warnings().empty() ? "" : errors.warnings().front().what, warning);
        return values.empty() ? std::vector<double>{} : values.front();
    };
    const std::vector<double> one =
        read({"20", "9999", "21", "-999", "22"}, 0,
             "T is 9999 degC or -999 degC in 2 of 5 samples, which no sensor of it reads: left out");
    ASSERT_EQ(one.size(), 5U);
    EXPECT_TRUE(std::isnan(one[1]) && std::isnan(one[3]));
    EXPECT_DOUBLE_EQ(one[4], 295.15);
    EXPECT_TRUE(std::isnan(read({"1037", "1037", "1037", "20", "21", "20", "22"}, 0,
                                "T is 1037 degC in 3 of 7 samples, which no sensor of it reads: left out")
                               .at(0)));
    read({"290", "291", "290", "20"}, 3, "");
    read({"125", "126", "127", "128", "126", "125"}, 2, "");
    read({"20", "300", "21"}, 1, "");
}

// A line for each probe and time: a column for each probe, a row for each of three times, of which the second has no shoulder. What is
// wrong with a reading stands where it is in the file.
TEST(LogTable, ALineForEachReadingMakesAColumnForEachProbe) {
    const Written written;
    const auto path = written.add(
        "log.csv",
        "time [s],probe,temperature [degC]\n0,core,25\n0,shoulder,26\n1,core,27\n2,shoulder,28\n2,core,hot\n");
    InputErrors errors;
    const auto file = DataFile::open(path, {}, errors);
    ASSERT_TRUE(file && file->find("core") == 1 && file->find("shoulder") == 2);
    const auto time =
        file->read({{.column = 0, .name = "time", .spec = {.unit = "s"}, .purpose = Purpose::clock}}, errors);
    EXPECT_EQ(time.front(), (std::vector<double>{0.0, 1.0, 2.0}));
    const QuantitySpec temperature{.unit = "K", .high = 1000.0};
    const auto shoulder =
        file->read({{.column = 2, .name = "x", .spec = temperature, .purpose = Purpose::measured}}, errors);
    ASSERT_EQ(errors.count(), 0U);
    EXPECT_DOUBLE_EQ(shoulder.front()[0], 299.15);
    EXPECT_TRUE(std::isnan(shoulder.front()[1]));
    EXPECT_DOUBLE_EQ(shoulder.front()[2], 301.15);
    EXPECT_TRUE(
        file->read({{.column = 1, .name = "x", .spec = temperature, .purpose = Purpose::measured}}, errors).empty());
    EXPECT_EQ(errors.in_order().at(0).line, 6);
    EXPECT_EQ(errors.in_order().at(0).column, 8);
}

// Of the survey all columns are looked at, of which the log uses the time alone.
TEST(LogTable, IsReadOnceForASurvey) {
    const Written written;
    const auto path = written.add("log.csv", car_csv());
    InputErrors errors;
    const auto survey = survey_log(path, {}, errors);
    ASSERT_TRUE(survey);
    EXPECT_EQ(survey->columns.size(), 9U);
    EXPECT_EQ(errors.tables().files_read, 1U);
}

}  // namespace tiretherm::input
