// SPDX-License-Identifier: BSD-3-Clause
// Data check: sensors that stand still much longer than is typical of their own signal.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "input/measurements/data_warnings.hpp"

/// What looks suspicious in a signal that stands still.
namespace tiretherm::input {

namespace {

constexpr std::size_t stuck_samples = 20;
constexpr double stuck_share = 0.02;
constexpr double stuck_factor = 5.0;  ///< over the stretch of equal values in which a typical sample lies
constexpr double coarse = 3.0;        ///< steps of the logger; a signal that moves no further hardly moves
constexpr double noisy = 0.2;         ///< reversals a sample; a ramp has none, white noise two thirds

/// Samples of one value, one after another.
struct Stretch {
    std::size_t first = 0;
    std::size_t length = 0;
};

std::vector<Stretch> stretches(const std::vector<double>& value) {
    std::vector<Stretch> found;
    for (std::size_t i = 0; i < value.size(); ++i) {
        if (i > 0 && value[i] == value[i - 1]) {
            ++found.back().length;
        } else {
            found.push_back({i, 1});
        }
    }
    return found;
}

/// The length of the stretch in which the middle sample lies when they are sorted by length, one left out.
std::size_t typical_length(const std::vector<Stretch>& all, std::size_t without) {
    std::vector<std::size_t> lengths;
    std::size_t samples = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (i != without) {
            lengths.push_back(all[i].length);
            samples += all[i].length;
        }
    }
    std::sort(lengths.begin(), lengths.end());
    std::size_t counted = 0;
    for (const std::size_t length : lengths) {
        counted += length;
        if (2 * counted >= samples) {
            return length;
        }
    }
    return 0;
}

/// How often, a sample, a signal turns round outside a stretch. A setpoint and a ramp hardly ever do.
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

/// Whether the run has not begun yet: a stretch from its first sample on in which the tire stands.
bool is_soak(const Recording& recording, const RecordedColumn& column, const Stretch& stretch) {
    const RecordedColumn* speed = recording.find("speed");
    if (stretch.first != 0 || speed == nullptr) {
        return false;
    }
    const double last = column.time[stretch.length - 1];
    std::size_t i = 0;
    while (i < speed->time.size() && speed->time[i] <= last) {
        if (std::abs(speed->value[i]) > 0.1) {
            return false;
        }
        ++i;
    }
    return true;
}

/// Whether anything else in the recording moves: the tire rolls, or another sensor changes.
bool anything_happens(const Recording& recording, const RecordedColumn& but) {
    return std::ranges::any_of(recording.columns, [&](const RecordedColumn& other) {
        const bool changes = std::ranges::adjacent_find(other.value, std::ranges::not_equal_to{}) != other.value.end();
        return other.name != but.name && !other.value.empty() &&
               (changes || (other.name == "speed" && std::abs(other.value.front()) > 0.1));
    });
}

}  // namespace

std::string find_frozen(const Recording& recording, const RecordedColumn& column) {
    const bool constant = std::ranges::adjacent_find(column.value, std::ranges::not_equal_to{}) == column.value.end();
    if (column.value.empty() || column.is_input || !constant || column.value.size() < stuck_samples ||
        !anything_happens(recording, column)) {
        return {};
    }
    return fmt::format(
        "is {} in all {} samples, while the tire rolls or other sensors change: is the sensor connected? "
        "Fits and diagnoses leave it out",
        column.show(column.value.front()), column.value.size());
}

std::string find_stuck(const Recording& recording, const RecordedColumn& column) {
    const std::vector<Stretch> all = stretches(column.value);
    const auto longest = std::max_element(all.begin(), all.end(),
                                          [](const Stretch& a, const Stretch& b) { return a.length < b.length; });
    const auto least =
        std::max(static_cast<double>(stuck_samples), stuck_share * static_cast<double>(column.value.size()));
    const std::size_t typical = typical_length(all, static_cast<std::size_t>(longest - all.begin()));
    const double value = column.value[longest->first];
    // An input that rests at zero or is held by a controller is no sensor that hangs.
    const bool held = column.is_input && (value == 0.0 || reversals(column.value, *longest) < noisy);
    const bool coarsely = column.high() - column.low() <= coarse * column.resolution();
    if (all.size() < 2 || held || coarsely || is_soak(recording, column, *longest) ||
        static_cast<double>(longest->length) <= least ||
        static_cast<double>(longest->length) <= stuck_factor * static_cast<double>(typical)) {
        return {};
    }
    return fmt::format(
        "stands at {} for {} samples, from {:.6g} s to {:.6g} s, while it otherwise changes: was it stuck?",
        column.show(value), longest->length, column.time[longest->first],
        column.time[longest->first + longest->length - 1]);
}

}  // namespace tiretherm::input
