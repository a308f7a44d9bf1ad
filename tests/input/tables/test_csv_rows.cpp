// SPDX-License-Identifier: BSD-3-Clause
// The work of reading a log counted in lines that are split: it grows with the lines, not with the columns that are read of it, nor
// with the tires of a car.

#include <gtest/gtest.h>

#include "input/log_survey/log_survey.hpp"
#include "input/measurements/runs.hpp"
#include "input/tables/csv_rows.hpp"
#include "input/tables/data_file.hpp"
#include "input/toml/document.hpp"
#include "support/written.hpp"

namespace tiretherm::input {

namespace {

std::vector<double> read_column(const DataFile& file, int column, InputErrors& errors) {
    std::vector<std::vector<double>> read =
        file.read({{.column = column, .name = "x", .spec = {.unit = "1"}, .purpose = Purpose::measured}}, errors);
    return read.empty() ? std::vector<double>{} : std::move(read.front());
}

/// @param line makes a line of a row
template <typename Line>
std::string log_of(const std::string& heads, int rows, const Line& line) {
    std::string text = heads + "\n";
    for (int i = 0; i < rows; ++i) {
        text += line(i) + "\n";
    }
    return text;
}

}  // namespace

// 10 lines of 3 columns, opened twice: the first column that is read takes one pass, another one a second; what has been parsed takes
// none.
TEST(CsvRows, AreSplitOnceForAllThatHaveBeenParsed) {
    const Written written;
    const auto path = written.add("log.csv", log_of("time [s],a,b", 10, [](int i) {
                                      return std::to_string(i) + "," + std::to_string(2 * i) + ",";
                                  }));
    InputErrors errors;
    const auto first = DataFile::open(path, {}, errors);
    const auto second = DataFile::open(path, {}, errors);
    ASSERT_TRUE(first && second);
    const CsvRows& rows = *errors.rows(first->number());
    EXPECT_EQ(read_column(*first, 1, errors).back(), 18.0);
    EXPECT_EQ(read_column(*second, 1, errors).back(), 18.0);
    EXPECT_EQ(rows.lines_split(), 10U);
    EXPECT_TRUE(std::isnan(read_column(*second, 2, errors).back()));
    EXPECT_TRUE(std::isnan(read_column(*first, 2, errors).back()));
    EXPECT_EQ(rows.lines_split(), 20U);
    EXPECT_EQ(errors.count(), 0U);
}

// A comment and a blank line after each hundred rows: row 700, counted from 0, is line 1 + 701 + 2 * 7.
TEST(CsvRows, AWrongFieldHasItsLineHoweverFarDown) {
    const Written written;
    const auto path = written.add("log.csv", log_of("time [s],a", 1000, [](int i) {
                                      return std::string(i > 0 && i % 100 == 0 ? "# lap\n\n" : "") + std::to_string(i) +
                                             (i == 700 ? ",wet" : ",1");
                                  }));
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

// Of 200 columns in 60 lines none but the time is used: one pass for it, one for all others.
TEST(CsvRows, ASurveySplitsALineTwiceHoweverManyColumnsItHas) {
    const Written written;
    std::string heads = "time [s]";
    for (int c = 0; c < 199; ++c) {
        heads += ",x" + std::to_string(c) + " [degC]";
    }
    const auto path = written.add("log.csv", log_of(heads, 60, [](int i) {
                                      std::string line = std::to_string(i);
                                      for (int c = 0; c < 199; ++c) {
                                          line += "," + std::to_string(20 + (i * (c + 3)) % 17);
                                      }
                                      return line;
                                  }));
    InputErrors errors;
    const auto survey = survey_log(path, {}, errors);
    ASSERT_TRUE(survey);
    EXPECT_EQ(survey->columns.size(), 200U);
    EXPECT_LE(errors.rows(errors.find_file(path.generic_string()))->lines_split(), 2U * 60U);
}

// Four tires, each with its inputs, sensors and columns that nothing uses: the log's 4 500 lines are split once.
TEST(CsvRows, TheTiresOfACarShareThem) {
    const std::filesystem::path path = source_folder() / "cases/car/session.toml";
    InputErrors errors;
    const auto document = read_document(path, errors);
    ASSERT_TRUE(document);
    const Runs runs = read_runs(*document, "session", {}, ReadMode::measured, errors);
    ASSERT_EQ(runs.corners.size(), 4U);
    const auto log = errors.find_file((source_folder() / "cases/car/session.csv").generic_string());
    ASSERT_GE(log, 0);
    EXPECT_EQ(errors.rows(log)->lines_split(), errors.rows(log)->size());
}

}  // namespace tiretherm::input
