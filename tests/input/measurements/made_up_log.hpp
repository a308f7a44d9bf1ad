// SPDX-License-Identifier: BSD-3-Clause
// A log of made-up columns and the case that reads it.
#pragma once

#include <cstdio>
#include <functional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "input/measurements/measured_bench.hpp"

namespace tiretherm::input {

/// Columns of numbers at even times, as a file writes them.
class MadeUpLog {
public:
    struct Column {
        std::string name;
        std::string unit;
        std::vector<double> value;
    };

    /// @param n samples  @param interval s
    MadeUpLog(std::size_t n, double interval) {
        for (std::size_t i = 0; i < n; ++i) {
            time.push_back(interval * static_cast<double>(i));
        }
    }

    /// A column by a function of the time in seconds.
    std::vector<double>& add(std::string name, std::string unit, const std::function<double(double)>& value) {
        Column column{.name = std::move(name), .unit = std::move(unit), .value = {}};
        for (const double t : time) {
            column.value.push_back(value(t));
        }
        columns.push_back(std::move(column));
        return columns.back().value;
    }

    /// A missing number is left empty.
    [[nodiscard]] std::string text() const {
        std::string log = "time [s]";
        for (const Column& column : columns) {
            log += "," + column.name + " [" + column.unit + "]";
        }
        char number[40];
        for (std::size_t i = 0; i < time.size(); ++i) {
            std::snprintf(number, sizeof number, "\n%.10g", time[i]);
            log += number;
            for (const Column& column : columns) {
                std::snprintf(number, sizeof number, ",%.10g", column.value[i]);
                log += std::isnan(column.value[i]) ? "," : number;
            }
        }
        return log + "\n";
    }

    std::vector<double> time;  ///< s
    std::vector<Column> columns;
};

/// The bench of two nodes under logs. @param more of the case, after [[run]] tables
inline ExperimentReading read_logs(const std::vector<MadeUpLog>& logs, const std::string& more = "") {
    const Written files;
    std::string text(bench);
    for (std::size_t i = 0; i < logs.size(); ++i) {
        const std::string name = "run" + std::to_string(i + 1) + ".csv";
        files.add(name, logs[i].text());
        text += "[[run]]\nfile = \"" + name + "\"\n";
    }
    ExperimentReading reading = read_experiment(files.add("case.toml", text + more));
    const std::string folder = files.folder().generic_string() + "/";
    for (std::string& sentence : reading.data_warnings) {
        sentence = replaced(sentence, folder, "");
    }
    for (std::string& sentence : reading.warnings) {
        sentence = replaced(sentence, folder, "");
    }
    return reading;
}

/// White noise, the same in every run of a test.
class Noise {
public:
    explicit Noise(double deviation, unsigned seed = 5) : random_(seed), deviation_(deviation) {}
    double operator()() { return deviation_ * noise_(random_); }

private:
    std::mt19937 random_;
    std::normal_distribution<double> noise_{0.0, 1.0};
    double deviation_;
};

}  // namespace tiretherm::input
