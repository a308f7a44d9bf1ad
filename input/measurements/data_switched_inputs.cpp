// SPDX-License-Identifier: BSD-3-Clause
// Data check: inputs that are switched between samples, which straight lines between the samples smear.

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include <fmt/format.h>

#include "input/measurements/data_warnings.hpp"
#include "solver/order_statistics.hpp"

namespace tiretherm::input {

namespace {

constexpr std::size_t least_changes = 6;  ///< three pulses
constexpr std::size_t most_levels = 4;    ///< of a signal that is on, off, or on in a few steps
constexpr double least_share = 0.05;      ///< of the samples, where there are more levels: fewer make no difference
constexpr double most_share = 0.5;        ///< likewise: more are a signal that moves
constexpr double least_change = 0.3;      ///< of the range, for the typical change
constexpr double least_range = 0.2;       ///< of the largest value: less is a coarse logger

/// How often a column jumps between two samples, and over what time at most; nothing where it moves like a measured one.
struct Switching {
    std::size_t times = 0;
    double width = 0.0;  ///< s
};

Switching switching_of(const RecordedColumn& column) {
    if (!column.is_input) {
        return {};
    }
    std::vector<double> changes;
    Switching found;
    for (std::size_t i = 1; i < column.value.size(); ++i) {
        if (column.time[i] == column.time[i - 1]) {
            return {};  // it has true jumps: nothing is smeared
        }
        if (column.value[i] != column.value[i - 1]) {
            changes.push_back(std::abs(column.value[i] - column.value[i - 1]));
            found.width = std::max(found.width, column.time[i] - column.time[i - 1]);
        }
    }
    const auto samples = static_cast<double>(column.value.size());
    found.times = changes.size();
    std::set<double> levels;
    for (auto value = column.value.begin(); value != column.value.end() && levels.size() <= most_levels; ++value) {
        levels.insert(*value);
    }
    const bool few = levels.size() <= most_levels;
    const double share = static_cast<double>(changes.size()) / samples;
    if (changes.size() < least_changes || (!few && (share < least_share || share > most_share))) {
        return {};
    }
    const double low = column.least();
    const double high = column.most();
    const bool coarse = high - low < least_range * std::max(std::abs(high), std::abs(low));
    return coarse || solver::median(std::move(changes)) < least_change * (high - low) ? Switching{} : found;
}

}  // namespace

std::string find_switched(const Recording& recording) {
    std::vector<std::string> names;
    Switching most;
    for (const RecordedColumn& column : recording.columns) {
        if (const Switching found = switching_of(column); found.times > 0) {
            names.push_back(column.name);
            most.times = std::max(most.times, found.times);
            most.width = std::max(most.width, found.width);
        }
    }
    if (names.empty()) {
        return {};
    }
    return fmt::format(
        "{} {} between samples, up to {} times, and {} read as straight in between, over {:.3g} s. What is switched "
        "can "
        "hold each value until the next sample: hold = [\"{}\"]",
        fmt::join(names, ", "), names.size() == 1 ? "jumps" : "jump", most.times, names.size() == 1 ? "is" : "are",
        most.width, names.front());
}

}  // namespace tiretherm::input
