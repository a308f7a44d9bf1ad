// SPDX-License-Identifier: BSD-3-Clause
// Merges the times of channels and puts their samples into the rows.

#include "input/tables/channel_rows.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace tiretherm::input {

namespace {

constexpr double same_time = 1e-7;  ///< s; the times of 200 Hz and of 3 Hz are farther apart or the same

}  // namespace

std::vector<double> row_times(const LogTable& table, const std::vector<int>& columns) {
    std::set<std::pair<double, std::size_t>> clocks;  // rate and count, each once
    const auto add = [&](const TableColumn& column) {
        if (column.rate > 0.0) {
            clocks.emplace(column.rate, column.number.size());
        }
    };
    std::ranges::for_each(columns, [&](int column) { add(table.columns[static_cast<std::size_t>(column)]); });
    if (clocks.empty()) {
        std::ranges::for_each(table.columns, add);
    }
    std::vector<double> rows;
    for (const auto& [rate, count] : clocks) {
        for (std::size_t k = 0; k < count; ++k) {
            rows.push_back(static_cast<double>(k) / rate);
        }
    }
    std::ranges::sort(rows);
    rows.erase(std::unique(rows.begin(), rows.end(), [](double a, double b) { return b - a < same_time; }), rows.end());
    return rows;
}

std::vector<double> in_rows(const TableColumn& channel, const std::vector<double>& rows) {
    const std::vector<double>& samples = channel.number;
    std::vector<double> sums(rows.size(), 0.0);
    std::vector<int> counts(rows.size(), 0);
    std::size_t row = 0;
    for (std::size_t k = 0; k < samples.size() && !rows.empty(); ++k) {
        const double time = static_cast<double>(k) / channel.rate;
        while (row + 1 < rows.size() && std::abs(rows[row + 1] - time) <= std::abs(rows[row] - time)) {
            ++row;
        }
        // Before the first and behind the last row there is none to belong to.
        const bool beside = (row + 1 == rows.size() || row == 0) && std::abs(rows[row] - time) > 1.0 / channel.rate;
        if (!beside && std::isfinite(samples[k])) {
            sums[row] += samples[k];
            ++counts[row];
        }
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
        sums[i] = counts[i] == 0 ? std::numeric_limits<double>::quiet_NaN() : sums[i] / counts[i];
    }
    return sums;
}

}  // namespace tiretherm::input
