// SPDX-License-Identifier: BSD-3-Clause
// Data check: sensors that never change, or stand still much longer than is typical of their own signal.

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>

#include <fmt/format.h>

#include "input/measurements/data_stretches.hpp"
#include "input/measurements/dead_stretches.hpp"

/// What looks suspicious in a signal that stands still.
namespace tiretherm::input {

namespace {

/// Whether anything else in the recording moves: the tire rolls, or another sensor changes.
bool anything_happens(const Recording& recording, const RecordedColumn& but) {
    return std::ranges::any_of(recording.columns, [&](const RecordedColumn& other) {
        return other.name != but.name && !other.value.empty() &&
               (other.most() > other.least() || (other.name == "speed" && std::abs(other.value.front()) > 0.1));
    });
}

/// Whether a sensor that stands still was surely stuck: it has noise otherwise, or it is let go with a jump that no input
/// explains. What comes to rest on a step of a coarse logger does neither.
bool is_surely_stuck(const Recording& recording, const RecordedColumn& column, const Stretch& stretch) {
    if (has_noise(column, [&](const Stretch& one) { return one.first == stretch.first; })) {
        return true;
    }
    const std::size_t end = stretch.first + stretch.length;
    if (end >= column.value.size()) {
        return false;
    }
    std::vector<double> steps;
    for (std::size_t i = 1; i < column.value.size(); ++i) {
        if (column.value[i] != column.value[i - 1] && i != end) {
            steps.push_back(std::abs(column.value[i] - column.value[i - 1]));
        }
    }
    const double usual = *std::ranges::max_element(steps);
    const double jump = std::abs(column.value[end] - column.value[end - 1]);
    const std::size_t before = end >= 4 ? end - 4 : 0;
    return jump > std::max(coarse * column.resolution(), 2.0 * usual) &&
           !is_eventful(recording, column.time[before], column.time[end]);
}

bool overlaps(const std::vector<Stretch>& those, const Stretch& one) {
    return std::ranges::any_of(those, [&](const Stretch& other) {
        return other.first < one.first + one.length && one.first < other.first + other.length;
    });
}

/// A force or a slip explains a jump of a sensor; that of an input is explained by nothing.
std::vector<Stretch> dead_of(const Recording& recording, const RecordedColumn& column) {
    if (column.is_input) {
        return dead_stretches(column.time, column.value, column.si);
    }
    return dead_stretches(column.time, column.value, column.si,
                          [&](double from, double to) { return is_heated_at_once(recording, from, to); });
}

}  // namespace

std::string find_frozen(const Recording& recording, const RecordedColumn& column) {
    if (column.is_input || column.value.size() < stuck_samples || column.most() > column.least() ||
        !anything_happens(recording, column)) {
        return {};
    }
    return fmt::format(
        "is {} in all {} samples, while the tire rolls or other sensors change: is the sensor connected?{}",
        column.show(column.value.front()), column.value.size(),
        recording.keep_suspicious ? "" : " Fits and diagnoses leave it out");
}

std::string find_stuck(const Recording& recording, const RecordedColumn& column) {
    const std::vector<Stretch>& clipped = clipped_stretches(recording, column);
    std::vector<Stretch> found = too_long(recording, column);
    std::erase_if(found, [&](const Stretch& one) { return overlaps(clipped, one); });
    if (found.empty()) {
        return {};
    }
    const Stretch& longest = found.front();
    const bool surely = !column.is_input && std::ranges::any_of(found, [&](const Stretch& one) {
        return is_surely_stuck(recording, column, one);
    });
    return fmt::format(
        "stands at {} for {} samples, from {:.6g} s to {:.6g} s{}, while it otherwise changes: was it stuck?{}",
        column.show(column.value[longest.first]), longest.length, column.time[longest.first],
        column.time[longest.first + longest.length - 1],
        found.size() == 1 ? "" : fmt::format(", and {} more times", found.size() - 1),
        surely ? left_out(recording) : "");
}

std::string find_dead_stretches(const Recording& recording, const RecordedColumn& column) {
    std::vector<Stretch> dead = dead_of(recording, column);
    std::erase_if(dead, [&](const Stretch& one) {
        return overlaps(clipped_stretches(recording, column), one) || overlaps(too_long(recording, column), one);
    });
    return dead.empty() ? std::string()
                        : fmt::format("{}.{}", sentence_of_dead(dead, column.time, column.value, column.si),
                                      left_out(recording));
}

const std::vector<Stretch>& unusable_stretches(const Recording& recording, const RecordedColumn& column) {
    return column.known.unusable.get([&] {
        std::vector<Stretch> found = clipped_stretches(recording, column);
        std::ranges::move(dead_of(recording, column), std::back_inserter(found));
        std::ranges::move(stuck_together(recording, column, nullptr), std::back_inserter(found));
        std::ranges::copy_if(too_long(recording, column), std::back_inserter(found),
                             [&](const Stretch& one) { return is_surely_stuck(recording, column, one); });
        return found;
    });
}

}  // namespace tiretherm::input
