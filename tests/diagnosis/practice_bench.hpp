// SPDX-License-Identifier: BSD-3-Clause
// Reads the shipped logs of cases/practice, changes them, and fits the practice case, for tests of the identification.
#pragma once

#include <cmath>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "diagnosis/fit/identification.hpp"
#include "input/measurements/measured_bench.hpp"

namespace tiretherm::diagnosis::sample {

/// A log as text keeps it.
struct Log {
    std::vector<std::string> headings;
    std::vector<std::vector<double>> columns;

    [[nodiscard]] std::string text() const {
        std::string out = fmt::format("{}\n", fmt::join(headings, ","));
        for (std::size_t row = 0; row < columns.front().size(); ++row) {
            for (std::size_t c = 0; c < columns.size(); ++c) {
                out += fmt::format("{}{}", c > 0 ? "," : "", columns[c][row]);  // every digit
            }
            out += '\n';
        }
        return out;
    }
};

inline Log read_log(const std::filesystem::path& file) {
    std::ifstream in(file);
    Log log;
    std::string line;
    std::getline(in, line);
    std::istringstream headings(line);
    for (std::string cell; std::getline(headings, cell, ',');) {
        log.headings.push_back(cell);
    }
    log.columns.resize(log.headings.size());
    while (std::getline(in, line)) {
        std::istringstream cells(line);
        std::size_t c = 0;
        for (std::string cell; std::getline(cells, cell, ',');) {
            log.columns.at(c++).push_back(std::stod(cell));
        }
    }
    return log;
}

inline std::filesystem::path practice() { return input::source_folder() / "cases/practice"; }

/// The three runs of cases/practice: made up with lambda_h = 1.05 and lambda_SEL = 0.93, a sample every 4 s.
inline std::vector<Log> practice_logs() {
    return {read_log(practice() / "run1.csv"), read_log(practice() / "run2.csv"), read_log(practice() / "run3.csv")};
}

inline input::Experiment read_bench(const std::filesystem::path& file,
                                    const std::vector<std::filesystem::path>& data = {}) {
    input::ExperimentReading reading = input::read_experiment(file, data);
    EXPECT_TRUE(reading.experiment) << input::error_report(reading);
    return reading.experiment ? std::move(*reading.experiment) : input::Experiment{};
}

inline input::Experiment practice_bench() { return read_bench(practice() / "two_node_bench.toml"); }

/// The text of the practice case, its files named so that it can lie anywhere.
inline std::string practice_text() {
    std::ifstream in(practice() / "two_node_bench.toml");
    std::string text{std::istreambuf_iterator<char>(in), {}};
    text = input::replaced(text, "../tires", (input::source_folder() / "cases/tires").string());
    return input::replaced(text, "file = \"run", "file = \"" + (practice() / "run").string());
}

/// The case of cases/practice with other logs.
inline input::Experiment practice_bench(const std::vector<Log>& logs) {
    const input::Written written;
    std::vector<std::filesystem::path> data;
    data.reserve(logs.size());
    for (const Log& log : logs) {
        data.push_back(written.add(fmt::format("run{}.csv", data.size() + 1), log.text()));
    }
    return read_bench(practice() / "two_node_bench.toml", data);
}

inline Identification fit(const input::Experiment& experiment, const IdentificationOptions& choice = {}) {
    Identification result = identify(experiment, observe(experiment), choice);
    EXPECT_TRUE(result.status.ok()) << result.status.message;
    EXPECT_TRUE(result.converged);
    return result;
}

inline std::size_t index_of(const input::Experiment& experiment, std::string_view name) {
    for (std::size_t j = 0; j < experiment.parameters.size(); ++j) {
        if (experiment.parameters[j].name == name) {
            return j;
        }
    }
    ADD_FAILURE() << "no parameter " << name;
    return 0;
}

inline constexpr std::string_view film = "air_convection.lambda_h";
inline constexpr std::string_view loss = "strain_energy_loss.tan_delta_a";

/// The same numbers in two experiments, by their names: how far apart values and intervals are, in standard deviations
/// of the first.
inline double apart(const input::Experiment& first, const Identification& one, const input::Experiment& second,
                    const Identification& other) {
    EXPECT_EQ(first.parameters.size(), second.parameters.size());
    double most = 0.0;
    for (std::size_t j = 0; j < first.parameters.size(); ++j) {
        const Fitted& a = one.fitted[j];
        const Fitted& b = other.fitted[index_of(second, first.parameters[j].name)];
        most = std::max({most, std::abs(a.value - b.value) / a.standard_deviation,
                         std::abs(a.standard_deviation / b.standard_deviation - 1.0)});
    }
    return most;
}

}  // namespace tiretherm::diagnosis::sample
