// SPDX-License-Identifier: BSD-3-Clause
// Finds stretches of equal values and judges their length by the signal's own.

#include "input/measurements/data_stretches.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "physics/signals.hpp"

namespace tiretherm::input {

namespace {

constexpr double stuck_share = 0.02;
constexpr double stuck_factor = 5.0;  ///< over the stretch of equal values in which a typical sample lies
constexpr double eventful = 0.1;      ///< of an input's range; where it changes by that, a sensor may jump
constexpr double noisy = 0.2;         ///< reversals a sample; a ramp has none, white noise two thirds

/// The length of the stretch in which the middle sample lies when they are sorted by length, some left out.
std::size_t typical_length(const RecordedColumn& column, const std::function<bool(const Stretch&)>& without) {
    std::map<std::size_t, std::size_t> in_length;  // samples in stretches of a length
    std::size_t samples = 0;
    for (const Stretch& one : stretches(column)) {
        if (!without(one)) {
            in_length[one.length] += one.length;
            samples += one.length;
        }
    }
    std::size_t counted = 0;
    for (const auto& [length, of_length] : in_length) {
        counted += of_length;
        if (2 * counted >= samples) {
            return length;
        }
    }
    return 0;
}

}  // namespace

const std::vector<Stretch>& stretches(const RecordedColumn& column) {
    return column.known.stretches.get([&] {
        const std::vector<double>& value = column.value;
        std::vector<Stretch> found;
        for (std::size_t i = 0; i < value.size(); ++i) {
            if (i > 0 && value[i] == value[i - 1]) {
                ++found.back().length;
            } else {
                found.push_back({i, 1});
            }
        }
        return found;
    });
}

double reversals(const std::vector<double>& value, const Stretch& without) {
    std::size_t turns = 0;
    std::size_t counted = 0;
    for (std::size_t i = 1; i + 1 < value.size(); ++i) {
        if (i + 1 < without.first || i > without.first + without.length) {
            turns += (value[i] - value[i - 1]) * (value[i + 1] - value[i]) < 0.0 ? 1 : 0;
            ++counted;
        }
    }
    return counted == 0 ? 0.0 : static_cast<double>(turns) / static_cast<double>(counted);
}

bool is_soak(const Recording& recording, const RecordedColumn& column, const Stretch& stretch) {
    const RecordedColumn* speed = recording.find("speed");
    if (speed == nullptr || speed->time.empty()) {
        return false;
    }
    const auto begin = std::ranges::lower_bound(speed->time, column.time[stretch.first]);
    const auto end = std::ranges::upper_bound(speed->time, column.time[stretch.first + stretch.length - 1]);
    return begin < end && std::all_of(begin, end, [&](const double& time) {
               return std::abs(speed->value[static_cast<std::size_t>(&time - speed->time.data())]) <= 0.1;
           });
}

bool has_noise(const RecordedColumn& column, const std::function<bool(const Stretch&)>& without) {
    const std::vector<double>& value = column.value;
    const std::vector<Stretch>& all = stretches(column);
    std::size_t turns = 0;
    std::size_t counted = 0;
    for (std::size_t s = 1; s + 1 < all.size(); ++s) {
        if (!without(all[s])) {
            const std::size_t i = all[s].first;
            const std::size_t next = all[s + 1].first;
            turns += (value[i] - value[i - 1]) * (value[next] - value[i]) < 0.0 ? 1 : 0;
            counted += all[s].length;
        }
    }
    return counted >= stuck_samples && static_cast<double>(turns) > noisy * static_cast<double>(counted) &&
           typical_length(column, without) <= 1;
}

namespace {

/// What stands still for too long.
std::vector<Stretch> find_too_long(const Recording& recording, const RecordedColumn& column) {
    std::vector<Stretch> found;
    const auto least =
        std::max(static_cast<double>(stuck_samples), stuck_share * static_cast<double>(column.value.size()));
    const std::vector<Stretch>& all = stretches(column);
    if (all.size() < 2 || column.high() - column.low() <= coarse * column.resolution()) {
        return found;
    }
    for (const Stretch& one : all) {
        const auto length = static_cast<double>(one.length);
        const auto is_it = [&](const Stretch& other) { return other.first == one.first; };
        if (length <= least || is_soak(recording, column, one) ||
            length <= stuck_factor * static_cast<double>(typical_length(column, is_it))) {
            continue;
        }
        // An input that rests at zero or is held by a controller is no sensor that hangs.
        const double value = column.value[one.first];
        if (!column.is_input || (value != 0.0 && reversals(column.value, one) >= noisy)) {
            found.push_back(one);
        }
    }
    std::ranges::stable_sort(found, std::greater{}, &Stretch::length);
    return found;
}

}  // namespace

const std::vector<Stretch>& too_long(const Recording& recording, const RecordedColumn& column) {
    return column.known.too_long.get([&] { return find_too_long(recording, column); });
}

namespace {

bool changes(const RecordedColumn& column, double from, double to) {
    const auto first = std::ranges::lower_bound(column.time, from) - column.time.begin();
    const auto last = std::ranges::upper_bound(column.time, to) - column.time.begin();
    if (first >= last) {
        return false;
    }
    const auto [least, most] = std::minmax_element(column.value.begin() + first, column.value.begin() + last);
    return *most - *least > eventful * (column.most() - column.least());
}

/// Accelerations of the car are noise at every sample, and heat the tire through its load and slips alone.
bool drives_the_tire(const RecordedColumn& column) {
    return column.is_input && !column.value.empty() && physics::find_signal(column.name) != nullptr;
}

}  // namespace

bool is_eventful(const Recording& recording, double from, double to) {
    return std::ranges::any_of(recording.columns, [&](const RecordedColumn& column) {
        return drives_the_tire(column) && changes(column, from, to);
    });
}

bool is_heated_at_once(const Recording& recording, double from, double to) {
    return std::ranges::any_of(recording.columns, [&](const RecordedColumn& column) {
        return drives_the_tire(column) && column.name != "speed" && !column.name.ends_with("_temperature") &&
               changes(column, from, to);
    });
}

std::string_view left_out(const Recording& recording) {
    return recording.keep_suspicious ? "" : " Fits and diagnoses leave these samples out";
}

}  // namespace tiretherm::input
