// SPDX-License-Identifier: BSD-3-Clause
// Data check: inputs that are switched between samples, which straight lines between the samples smear.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "input/measurements/data_warnings.hpp"

namespace tiretherm::input {

namespace {

constexpr std::size_t least_changes = 6;  ///< three pulses
constexpr double least_share = 0.01;      ///< of the samples: fewer changes make no difference
constexpr double most_share = 0.5;        ///< more are a signal that moves
constexpr double least_change = 0.3;      ///< of the range, for the typical change
constexpr double least_range = 0.2;       ///< of the largest value: less is a coarse logger

}  // namespace

std::string find_switched(const Recording& /*recording*/, const RecordedColumn& column) {
    std::vector<double> changes;
    double width = 0.0;
    for (std::size_t i = 1; i < column.value.size(); ++i) {
        if (column.time[i] == column.time[i - 1]) {
            return {};  // it has true jumps: nothing is smeared
        }
        if (column.value[i] != column.value[i - 1]) {
            changes.push_back(std::abs(column.value[i] - column.value[i - 1]));
            width = std::max(width, column.time[i] - column.time[i - 1]);
        }
    }
    const auto samples = static_cast<double>(column.value.size());
    const auto [low, high] = std::ranges::minmax(column.value);
    if (!column.is_input || changes.size() < least_changes ||
        static_cast<double>(changes.size()) < least_share * samples ||
        static_cast<double>(changes.size()) > most_share * samples) {
        return {};
    }
    const auto middle = changes.begin() + static_cast<std::ptrdiff_t>(changes.size() / 2);
    std::nth_element(changes.begin(), middle, changes.end());
    if (*middle < least_change * (high - low) || high - low < least_range * std::max(std::abs(high), std::abs(low))) {
        return {};
    }
    return fmt::format(
        "jumps between samples, {} times, and is read as straight in between, over {:.3g} s. If it is switched, let "
        "each "
        "value hold until the next sample: hold = [\"{}\"]",
        changes.size(), width, column.name);
}

}  // namespace tiretherm::input
