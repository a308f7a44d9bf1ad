// SPDX-License-Identifier: BSD-3-Clause
// Runs a case of the library and returns its channels row by row, to be compared with an independent truth.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "solver/time_integration/march.hpp"
#include "support/written.hpp"

namespace hidden_effects {

inline constexpr double celsius = 273.15;

inline double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
    double largest = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        largest = std::max(largest, std::abs(a[i] - b[i]));
    }
    return a.size() == b.size() ? largest : HUGE_VAL;
}

/// The rows of a case of the library: [channel][row], degC, at its output times without the first.
/// @param tolerance K, local error of a step; 0: the case's
inline std::vector<std::vector<double>> run_case(const std::string& name, double tolerance = 0.0) {
    namespace input = tiretherm::input;
    input::Reading reading = input::read_case(input::source_folder() / "cases" / (name + ".toml"));
    if (!reading.problem) {
        ADD_FAILURE() << input::render(reading);
        return {};
    }
    if (tolerance > 0.0) {
        reading.problem->settings.tolerance = tolerance;
    }
    std::vector<std::vector<double>> rows(reading.problem->channels.size());
    const auto report = tiretherm::solver::run(*reading.problem, [&](const tiretherm::solver::Snapshot& now) {
        for (std::size_t c = 0; c < rows.size() && now.time > 0.0; ++c) {
            rows[c].push_back(now.channels[c] - celsius);
        }
        return true;
    });
    EXPECT_TRUE(report.status.ok()) << report.status.message;
    return rows;
}

}  // namespace hidden_effects
