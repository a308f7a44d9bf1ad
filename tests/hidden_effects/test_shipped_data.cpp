// SPDX-License-Identifier: BSD-3-Clause
// The logs that the cases come with are what their generators write: make_bench_logs, make_laser_logs,
// make_laser_bench_logs, make_section_logs, make_car_logs.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <sstream>

#include <gtest/gtest.h>

#include "car/car_layouts_truth.hpp"
#include "laser/laser_logs_truth.hpp"
#include "section/section_logs_truth.hpp"
#include "two_node/shipped_truth.hpp"

namespace hidden_effects {

namespace {

std::string text_of(const std::string& file) {
    std::ifstream in(std::string(TIRETHERM_SOURCE_DIR) + "/cases/" + file, std::ios::binary);
    EXPECT_TRUE(in) << file;
    return {std::istreambuf_iterator<char>(in), {}};
}

std::vector<double> numbers(std::string row) {
    std::vector<double> out;
    std::istringstream in(row);
    for (std::string cell; std::getline(in, cell, ',');) {
        out.push_back(std::stod(cell));
    }
    return out;
}

/// The same headings and rows; a number may differ by one of its last digit, as libraries round sines differently.
void expect_as_shipped(const ShippedLog& log) {
    SCOPED_TRACE(log.file);
    std::istringstream shipped(text_of(log.file));
    std::istringstream made(written(log.columns));
    std::string shipped_row;
    std::string made_row;
    ASSERT_TRUE(std::getline(shipped, shipped_row));
    ASSERT_TRUE(std::getline(made, made_row));
    EXPECT_EQ(shipped_row, made_row);
    std::size_t row = 0;
    for (; std::getline(made, made_row); ++row) {
        ASSERT_TRUE(std::getline(shipped, shipped_row)) << "row " << row;
        const std::vector<double> a = numbers(shipped_row);
        const std::vector<double> b = numbers(made_row);
        ASSERT_EQ(a.size(), log.columns.size());
        ASSERT_EQ(b.size(), log.columns.size());
        for (std::size_t c = 0; c < a.size(); ++c) {
            ASSERT_NEAR(a[c], b[c], 1.01 * std::pow(10.0, -log.columns[c].digits))
                << log.columns[c].heading << ", row " << row;
        }
    }
    EXPECT_EQ(row, log.columns.front().value.size());
    EXPECT_FALSE(std::getline(shipped, shipped_row)) << "more rows than are made";
}

/// The cells of a text, whatever separates them.
std::vector<std::string> cells_of(const std::string& text) {
    constexpr std::string_view separators = "\", \t\r";
    std::vector<std::string> cells;
    for (std::size_t at = text.find_first_not_of(separators); at != std::string::npos;) {
        const std::size_t end = std::min(text.find_first_of(separators, at), text.size());
        cells.push_back(text.substr(at, end - at));
        at = text.find_first_not_of(separators, end);
    }
    return cells;
}

/// A cell of a logger's file may differ by one of its last digit; its lines of description, names and units may not.
void expect_export(const std::string& file, const std::string& text, std::size_t least_rows) {
    SCOPED_TRACE(file);
    std::istringstream shipped(text_of(file));
    std::istringstream made(text);
    std::string a;
    std::string b;
    std::size_t row = 0;
    for (; std::getline(made, b); ++row) {
        ASSERT_TRUE(std::getline(shipped, a)) << "row " << row;
        if (a == b) {
            continue;
        }
        const std::vector<std::string> cells_a = cells_of(a);
        const std::vector<std::string> cells_b = cells_of(b);
        ASSERT_EQ(cells_a.size(), cells_b.size()) << "row " << row;
        for (std::size_t c = 0; c < cells_a.size(); ++c) {
            const std::size_t point = cells_b[c].find('.');
            const std::size_t digits = point == std::string::npos ? 0 : cells_b[c].size() - point - 1;
            ASSERT_NEAR(std::stod(cells_a[c]), std::stod(cells_b[c]),
                        1.01 * std::pow(10.0, -static_cast<double>(digits)))
                << a << "\n"
                << b;
        }
    }
    EXPECT_GT(row, least_rows);
    EXPECT_FALSE(std::getline(shipped, a)) << "more rows than are made";
}

}  // namespace

TEST(ShippedData, BenchLogsAreWhatIsMade) {
    for (const ShippedLog& log : bench_logs()) {
        expect_as_shipped(log);
    }
}

TEST(ShippedData, LaserLogsAreWhatIsMade) {
    for (const ShippedLog& log : laser_logs()) {
        expect_as_shipped(log);
    }
}

TEST(ShippedData, LasersBenchLogsAreWhatIsMade) {
    for (const ShippedLog& log : laser_bench_logs()) {
        expect_as_shipped(log);
    }
}

TEST(ShippedData, LogsOfSectionAndLayersAreWhatIsMade) {
    for (const ShippedLog& log : section_logs()) {
        expect_as_shipped(log);
    }
    for (const ShippedLog& log : layers_logs()) {
        expect_as_shipped(log);
    }
}

TEST(ShippedData, LogsOfTheCarAreWhatIsMade) {
    expect_export("car/session.csv", shipped_car_log(), 4000);
    expect_export("car/wheels.csv", shipped_wheel_log(), 1300);
    for (const LoggerFile& file : shipped_logger_files()) {
        const std::string name = "car/loggers/" + file.name;
        if (file.name != "motec.ld") {
            expect_export(name, file.content, file.name == "motec.ldx" ? 5 : 800);
            continue;
        }
        // Samples of two or four bytes: one that is rounded otherwise has its lowest byte changed. A channel has 1 in 20 of them.
        const std::string shipped = text_of(name);
        ASSERT_EQ(shipped.size(), file.content.size());
        std::size_t others = 0;
        for (std::size_t i = 0; i < shipped.size(); ++i) {
            others += shipped[i] != file.content[i] ? 1 : 0;
        }
        EXPECT_LT(others, shipped.size() / 500);
    }
}

TEST(ShippedData, ARowHasItsDigitsAndNoMinusBeforeAZero) {
    EXPECT_EQ(written({{"time [s]", 0, {0.0, 4.0}}, {"T [degC]", 2, {-0.001, 23.456}}}),
              "time [s],T [degC]\n0,0.00\n4,23.46\n");
}

}  // namespace hidden_effects
