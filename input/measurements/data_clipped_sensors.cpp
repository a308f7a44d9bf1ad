// SPDX-License-Identifier: BSD-3-Clause
// Data check: sensors that stand at a rail, have two values in all, or are constant together.

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "input/measurements/data_stretches.hpp"

namespace tiretherm::input {

namespace {

constexpr std::size_t at_rail = 5;         ///< samples, one after another, of a noisy signal's highest or lowest value
constexpr std::size_t least_at_rail = 10;  ///< in all such stretches
constexpr double dropped = 0.3;            ///< of the range, that a sensor jumps by when it is disconnected
constexpr double longer = 10.0;      ///< times its neighbours: a stretch at a round rail, of a signal without noise
constexpr double moves_more = 10.0;  ///< times the two values' distance, that others move by
constexpr double alike = 0.2;        ///< difference of the higher value's share in the first and in the last third

/// Values at which amplifiers and loggers end, and what they write of a wire that is broken.
constexpr std::array rails{-999.0, -273.15, -273.1, -50.0, -40.0, 0.0,    100.0,  120.0,  125.0,  150.0,   200.0,
                           250.0,  255.0,   300.0,  400.0, 999.0, 1000.0, 1023.0, 4095.0, 9999.0, 32767.0, 65535.0};

/// Stretches at the highest or the lowest value that are no stay there: a noisy signal is cut off, or one without noise goes
/// straight to a round number and stays.
std::vector<Stretch> at_the_rail(const Recording& recording, const RecordedColumn& column, double rail) {
    const std::vector<Stretch>& all = stretches(column);
    std::vector<Stretch> found;
    const double written = column.conversion.from_si(rail);
    const bool round = std::ranges::any_of(rails, [&](double known) { return std::abs(written - known) < 1e-6; });
    const auto is_there = [&](const Stretch& one) { return column.value[one.first] == rail; };
    const bool noise = has_noise(column, is_there);
    // What comes to its extreme once, at an odd number, is stuck.
    const auto visits = std::ranges::count_if(all, is_there);
    std::size_t samples = 0;
    for (std::size_t s = 0; s < all.size(); ++s) {
        if (!is_there(all[s]) || all[s].length < at_rail || is_soak(recording, column, all[s])) {
            continue;
        }
        std::size_t beside = s > 0 ? all[s - 1].length : 0;
        beside = s + 1 < all.size() ? std::max(beside, all[s + 1].length) : beside;
        const bool sudden =
            all[s].length >= stuck_samples && static_cast<double>(all[s].length) > longer * static_cast<double>(beside);
        if ((noise && (round || visits > 1)) || (round && sudden)) {
            found.push_back(all[s]);
            samples += all[s].length;
        }
    }
    return samples < least_at_rail ? std::vector<Stretch>{} : found;
}

}  // namespace

const std::vector<Stretch>& clipped_stretches(const Recording& recording, const RecordedColumn& column) {
    return column.known.clipped.get([&] {
        const double low = column.least();
        const double high = column.most();
        std::vector<Stretch> found;
        if (!column.is_input && low != high && column.high() - column.low() > coarse * column.resolution()) {
            found = at_the_rail(recording, column, low);
            std::ranges::move(at_the_rail(recording, column, high), std::back_inserter(found));
            std::ranges::sort(found, {}, &Stretch::first);
        }
        return found;
    });
}

namespace {

/// Whether a column has one value from one sample to another, and others before and after.
bool stands_alike(const RecordedColumn& column, double from, double to) {
    const auto first = std::ranges::lower_bound(column.time, from) - column.time.begin();
    const auto last = std::ranges::lower_bound(column.time, to) - column.time.begin();
    const auto begin = column.value.begin();
    const auto n = std::ssize(column.value);
    return first < n && last < n && column.time[static_cast<std::size_t>(first)] == from &&
           column.time[static_cast<std::size_t>(last)] == to &&
           std::all_of(begin + first, begin + last, [&](double value) { return value == begin[last]; });
}

}  // namespace

std::vector<Stretch> stuck_together(const Recording& recording, const RecordedColumn& column,
                                    std::vector<std::string>* sensors) {
    std::vector<Stretch> found;
    for (const Stretch& one : too_long(recording, column)) {
        const double from = column.time[one.first];
        const double to = column.time[one.first + one.length - 1];
        std::vector<std::string> same{column.name};
        for (const RecordedColumn& other : recording.columns) {
            if (other.is_input || other.name == column.name || !stands_alike(other, from, to)) {
                continue;
            }
            if (std::ranges::any_of(too_long(recording, other),
                                    [&](const Stretch& theirs) { return other.time[theirs.first] == from; })) {
                same.push_back(other.name);
                if (sensors == nullptr) {
                    break;  // one will do
                }
            }
        }
        if (!column.is_input && same.size() > 1) {
            found.push_back(one);
            if (sensors != nullptr) {
                *sensors = same;
            }
        }
    }
    return found;
}

std::string find_dead(const Recording& recording, const RecordedColumn& column) {
    const double low = column.least();
    const double high = column.most();
    const auto is_either = [&](double value) { return value == low || value == high; };
    const std::size_t n = column.value.size();
    if (column.is_input || n < stuck_samples || low == high || !column.is_temperature() ||
        !std::ranges::all_of(column.value, is_either) || reversals(column.value, {n, 0}) == 0.0) {
        return {};
    }
    const auto third = static_cast<std::ptrdiff_t>(n / 3);
    const auto first = static_cast<double>(std::count(column.value.begin(), column.value.begin() + third, high));
    const auto last = static_cast<double>(std::count(column.value.end() - third, column.value.end(), high));
    const bool others_move = std::ranges::any_of(recording.columns, [&](const RecordedColumn& other) {
        return !other.is_input && other.is_temperature() && !other.value.empty() &&
               other.high() - other.low() > moves_more * (high - low);
    });
    if (std::abs(first - last) > alike * static_cast<double>(third) || !others_move) {
        return {};
    }
    return fmt::format(
        "has two values in all its {} samples, {} and {}, while others move by more than {} times as much: is the "
        "sensor connected?{}",
        n, column.show(low), column.show(high), moves_more,
        recording.keep_suspicious ? "" : " Fits and diagnoses leave it out");
}

std::string find_clipped(const Recording& recording, const RecordedColumn& column) {
    const std::vector<Stretch>& found = clipped_stretches(recording, column);
    if (found.empty()) {
        return {};
    }
    std::size_t samples = 0;
    for (const Stretch& stretch : found) {
        samples += stretch.length;
    }
    const Stretch& first = found.front();
    const double rail = column.value[first.first];
    const double high = column.most();
    const double entry = first.first > 0 ? std::abs(rail - column.value[first.first - 1]) : 0.0;
    return fmt::format("stands at its {} value, {}, for {} samples in {}, first from {:.6g} s to {:.6g} s: {}?{}",
                       rail == high ? "highest" : "lowest", column.show(rail), samples,
                       found.size() == 1 ? std::string("one stretch") : fmt::format("{} stretches", found.size()),
                       column.time[first.first], column.time[first.first + first.length - 1],
                       entry > dropped * (high - column.least()) ? "was it disconnected" : "is it clipped",
                       left_out(recording));
}

std::string find_stuck_together(const Recording& recording) {
    for (const RecordedColumn& column : recording.columns) {
        std::vector<std::string> sensors;
        const std::vector<Stretch> found =
            column.value.empty() ? std::vector<Stretch>{} : stuck_together(recording, column, &sensors);
        if (!found.empty()) {
            return fmt::format("{} are constant together, from {:.6g} s to {:.6g} s: did the logger stop?{}",
                               fmt::join(sensors, ", "), column.time[found.back().first],
                               column.time[found.back().first + found.back().length - 1], left_out(recording));
        }
    }
    return {};
}

}  // namespace tiretherm::input
