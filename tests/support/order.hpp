// SPDX-License-Identifier: BSD-3-Clause
// Observed order of convergence, and assertions on orders and errors that also report their figures.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

namespace tiretherm::support {

/// Order p of each refinement, from e = C h^p:   p = ln(e_coarse / e_fine) / ln(h_coarse / h_fine).
inline std::vector<double> orders(const std::vector<double>& errors, double refinement = 2.0) {
    std::vector<double> result;
    for (std::size_t i = 0; i + 1 < errors.size(); ++i) {
        result.push_back(std::log(std::abs(errors[i] / errors[i + 1])) / std::log(refinement));
    }
    return result;
}

inline std::string formatted(const std::vector<double>& values) {
    std::ostringstream text;
    text.precision(4);
    for (const double value : values) {
        text << value << ' ';
    }
    return text.str();
}

/// Every refinement must show an order inside [low, high]. The figures also go to the test's XML report.
inline void expect_order(std::string_view name, const std::vector<double>& errors, double low, double high,
                         double refinement = 2.0) {
    const std::vector<double> observed = orders(errors, refinement);
    const std::string figures = "errors " + formatted(errors) + "orders " + formatted(observed);
    testing::Test::RecordProperty(std::string(name), figures);
    for (const double order : observed) {
        EXPECT_GE(order, low) << name << ": " << figures;
        EXPECT_LE(order, high) << name << ": " << figures;
    }
}

/// An error that must stay below a bound; the figure also goes to the test's XML report.
inline void expect_below(std::string_view name, double error, double bound) {
    testing::Test::RecordProperty(std::string(name), formatted({error, bound}));
    EXPECT_LE(std::abs(error), bound) << name;
}

}  // namespace tiretherm::support
