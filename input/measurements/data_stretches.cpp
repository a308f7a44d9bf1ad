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
std::size_t typical_length(const std::vector<Stretch>& all, const std::function<bool(std::size_t)>& without) {
    std::map<std::size_t, std::size_t> in_length;  // samples in stretches of a length
    std::size_t samples = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (!without(i)) {
            in_length[all[i].length] += all[i].length;
            samples += all[i].length;
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

std::vector<Stretch> stretches(const std::vector<double>& value) {
    std::size_t n = 1;
    for (std::size_t i = 1; i < value.size(); ++i) {
        n += value[i] != value[i - 1] ? 1 : 0;
    }
    std::vector<Stretch> found;
    found.reserve(n);
    for (std::size_t i = 0; i < value.size(); ++i) {
        if (i > 0 && value[i] == value[i - 1]) {
            ++found.back().length;
        } else {
            found.push_back({i, 1});
        }
    }
    return found;
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

bool has_noise(const std::vector<Stretch>& all, const std::function<bool(std::size_t)>& without,
               const std::vector<double>& value) {
    std::size_t turns = 0;
    std::size_t counted = 0;
    for (std::size_t s = 1; s + 1 < all.size(); ++s) {
        if (!without(s)) {
            const std::size_t i = all[s].first;
            const std::size_t next = all[s + 1].first;
            turns += (value[i] - value[i - 1]) * (value[next] - value[i]) < 0.0 ? 1 : 0;
            counted += all[s].length;
        }
    }
    return counted >= stuck_samples && typical_length(all, without) <= 1 &&
           static_cast<double>(turns) > noisy * static_cast<double>(counted);
}

std::vector<std::size_t> too_long(const Recording& recording, const RecordedColumn& column,
                                  const std::vector<Stretch>& all) {
    std::vector<std::size_t> found;
    const auto least =
        std::max(static_cast<double>(stuck_samples), stuck_share * static_cast<double>(column.value.size()));
    if (all.size() < 2 || column.high() - column.low() <= coarse * column.resolution()) {
        return found;
    }
    for (std::size_t s = 0; s < all.size(); ++s) {
        const auto length = static_cast<double>(all[s].length);
        if (length <= least || is_soak(recording, column, all[s]) ||
            length <= stuck_factor *
                          static_cast<double>(typical_length(all, [&](std::size_t other) { return other == s; }))) {
            continue;
        }
        // An input that rests at zero or is held by a controller is no sensor that hangs.
        const double value = column.value[all[s].first];
        if (!column.is_input || (value != 0.0 && reversals(column.value, all[s]) >= noisy)) {
            found.push_back(s);
        }
    }
    std::ranges::stable_sort(found, std::greater{}, [&](std::size_t s) { return all[s].length; });
    return found;
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
