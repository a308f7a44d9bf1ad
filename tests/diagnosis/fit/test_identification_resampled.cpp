// SPDX-License-Identifier: BSD-3-Clause
// An interval from data that were interpolated to four times their rate is that of the data without.

#include <cmath>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "diagnosis/fit/identification.hpp"
#include "input/runs/read_experiment.hpp"
#include "support/written.hpp"

namespace tiretherm::diagnosis {

namespace {

const std::filesystem::path practice = std::filesystem::path(TIRETHERM_SOURCE_DIR) / "cases/practice";

/// A log with this many times its samples, all columns straight in between.
std::string interpolated(const std::filesystem::path& file, int times) {
    std::ifstream log(file);
    std::string line;
    std::getline(log, line);
    std::string text = line + "\n";
    std::vector<double> before;
    char number[40];
    while (std::getline(log, line)) {
        std::istringstream cells(line);
        std::vector<double> now;
        for (std::string cell; std::getline(cells, cell, ',');) {
            now.push_back(std::stod(cell));
        }
        for (int k = before.empty() ? times : 1; k <= times; ++k) {
            for (std::size_t c = 0; c < now.size(); ++c) {
                const double from = before.empty() ? now[c] : before[c];
                std::snprintf(number, sizeof number, c == 0 ? "%.6f" : ",%.6f", from + k * (now[c] - from) / times);
                text += number;
            }
            text += "\n";
        }
        before = now;
    }
    return text;
}

Identification identified(const std::filesystem::path& file, Eigen::Index& values) {
    const input::ExperimentReading reading = input::read_experiment(practice / "two_node_bench.toml", {file});
    EXPECT_TRUE(reading.experiment.has_value());
    const Observations observations = observe(*reading.experiment);
    values = observations.measured.size();
    return identify(*reading.experiment, observations);
}

}  // namespace

// Interpolated values hold nothing that the measured ones do not. Were they counted, an interval would shrink towards half
// of what it is, sqrt(1 / 4), where the noise is white; 10 % is what the estimate of the noise may differ by.
TEST(IdentificationResampled, AnIntervalIsThatOfTheMeasuredValues) {
    const input::Written files;
    Eigen::Index measured = 0;
    Eigen::Index thinned = 0;
    const Identification plain = identified(practice / "run1.csv", measured);
    const Identification dense = identified(files.add("run1.csv", interpolated(practice / "run1.csv", 4)), thinned);
    EXPECT_EQ(thinned, measured);
    ASSERT_EQ(plain.fitted.size(), dense.fitted.size());
    for (std::size_t i = 0; i < plain.fitted.size(); ++i) {
        const double width = plain.fitted[i].high - plain.fitted[i].low;
        EXPECT_NEAR((dense.fitted[i].high - dense.fitted[i].low) / width, 1.0, 0.1) << i;
    }
}

}  // namespace tiretherm::diagnosis
