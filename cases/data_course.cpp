#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "cases/data_findings.hpp"

/// Suspicions that the course of a signal raises, whatever its unit.
namespace tiretherm::cases {

namespace {

constexpr double long_interval = 10.0;  ///< times the median one: the logger was paused
constexpr double long_recording = 2e5;  ///< s; no test of a tire lasts two days at this many samples
constexpr std::size_t stuck_samples = 20;
constexpr double stuck_share = 0.02;
constexpr double stuck_factor = 5.0;     ///< over the stretch of equal values in which a typical sample lies
constexpr double coarse = 3.0;           ///< steps of the logger; a signal that moves no further hardly moves
constexpr double noisy = 0.2;            ///< reversals a sample; a ramp has none, white noise two thirds
constexpr double outlying = 8.0;         ///< robust standard deviations
constexpr double least_scale = 0.0025;   ///< of a sensor's range: what is small beside it is no outlier
constexpr double least_of_input = 0.01;  ///< of an input's range, which may have corners
constexpr double steep = 0.75;           ///< of its height that a spike rises and falls at once; a cusp does not
constexpr double eventful = 0.1;         ///< of an input's range; where it changes by that, a sensor may jump
constexpr std::size_t half_window = 5;   ///< samples on either side of a running median
constexpr std::size_t widest_spike = 3;  ///< samples; what lasts longer is an event. Of an input a single one

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

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

/// How far each sample lies from the median of those about it.
std::vector<double> off_median(const std::vector<double>& value) {
    std::vector<double> off(value.size());
    for (std::size_t i = 0; i < value.size(); ++i) {
        const std::size_t first = i < half_window ? 0 : i - half_window;
        const std::size_t last = std::min(value.size(), i + half_window + 1);
        const auto begin = value.begin();
        off[i] =
            value[i] - median({begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(last)});
    }
    return off;
}

/// The smallest step between two samples; 0 where there is none.
double resolution_of(const std::vector<double>& value) {
    double resolution = 0.0;
    for (std::size_t i = 1; i < value.size(); ++i) {
        const double step = std::abs(value[i] - value[i - 1]);
        resolution = step > 0.0 && (resolution == 0.0 || step < resolution) ? step : resolution;
    }
    return resolution;
}

/// Whether the run has not begun yet: a stretch from its first sample on in which the tire stands.
bool is_soak(const Recording& recording, const Watched& column, const Stretch& stretch) {
    const Watched* speed = recording.find("speed");
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

/// A robust standard deviation of the differences, not below what the logger resolves and what would matter.
double scale_of(const Watched& column, const std::vector<double>& off) {
    std::vector<double> magnitudes(off.size());
    std::transform(off.begin(), off.end(), magnitudes.begin(), [](double v) { return std::abs(v); });
    const double least = column.is_input ? least_of_input : least_scale;
    return std::max(
        {1.4826 * median(std::move(magnitudes)), least * (column.high() - column.low()), resolution_of(column.value)});
}

/// Whether an input changes so much between two times that a sensor's jump may be real.
bool is_eventful(const Recording& recording, double from, double to) {
    return std::ranges::any_of(recording.columns, [&](const Watched& column) {
        const auto first = std::lower_bound(column.time.begin(), column.time.end(), from);
        const auto last = std::upper_bound(first, column.time.end(), to);
        if (!column.is_input || first == last) {
            return false;
        }
        const auto begin = column.value.begin() + (first - column.time.begin());
        const auto [low, high] = std::minmax_element(begin, begin + (last - first));
        const auto [lowest, highest] = std::minmax_element(column.value.begin(), column.value.end());
        return *high - *low > eventful * (*highest - *lowest);
    });
}

}  // namespace

std::string find_time_jumps(const Recording& recording) {
    const std::vector<double>& time = recording.time;
    if (time.size() < 3) {
        return {};
    }
    const double length = time.back() - time.front();
    if (recording.time_unit == "s" && length > long_recording && time.size() >= 50) {
        return fmt::format("goes on for {} h, and {} ms would be {} s: is the column in ms?",
                           three_digits(length / 3600.0), three_digits(length), three_digits(length / 1000.0));
    }
    std::vector<double> intervals;
    for (std::size_t i = 1; i < time.size(); ++i) {
        intervals.push_back(time[i] - time[i - 1]);
    }
    const double usual = median(intervals);
    const auto longest = std::max_element(intervals.begin(), intervals.end());
    const auto jumps = std::count_if(intervals.begin(), intervals.end(),
                                     [&](double interval) { return interval > long_interval * usual; });
    if (jumps == 0) {
        return {};
    }
    const std::string from = fmt::format("{:.6g} s", time[static_cast<std::size_t>(longest - intervals.begin())]);
    const std::string how = jumps == 1
                                ? fmt::format("jumps by {:.6g} s after {}", *longest, from)
                                : fmt::format("jumps {} times, at most by {:.6g} s after {}", jumps, *longest, from);
    return fmt::format("{}, where a sample mostly comes every {:.6g} s: was the logger paused?", how, usual);
}

std::string find_stuck(const Recording& recording, const Watched& column) {
    const std::vector<Stretch> all = stretches(column.value);
    const auto longest = std::max_element(all.begin(), all.end(),
                                          [](const Stretch& a, const Stretch& b) { return a.length < b.length; });
    const auto least =
        std::max(static_cast<double>(stuck_samples), stuck_share * static_cast<double>(column.value.size()));
    const std::size_t typical = typical_length(all, static_cast<std::size_t>(longest - all.begin()));
    const double value = column.value[longest->first];
    // An input that rests at zero or is held by a controller is no sensor that hangs.
    const bool held = column.is_input && (value == 0.0 || reversals(column.value, *longest) < noisy);
    const bool coarsely = column.high() - column.low() <= coarse * resolution_of(column.value);
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

std::string find_outliers(const Recording& recording, const Watched& column) {
    const std::vector<double>& value = column.value;
    if (value.size() < 2 * half_window + 1) {
        return {};
    }
    const std::vector<double> off = off_median(value);
    const double limit = outlying * scale_of(column, off);
    const std::size_t widest = column.is_input ? 1 : widest_spike;
    std::size_t outliers = 0;
    std::size_t first = 0;
    for (std::size_t i = 1; i + 1 < value.size(); ++i) {
        if (std::abs(off[i]) <= limit) {
            continue;
        }
        std::size_t end = i;
        while (end < value.size() && std::abs(off[end]) > limit) {
            ++end;
        }
        // A spike leaves at once and comes back to where it left.
        const double height = std::abs(off[i]);
        const bool back = end < value.size() && std::abs(value[end] - value[i - 1]) < 0.5 * height &&
                          std::abs(value[i] - value[i - 1]) > steep * height &&
                          std::abs(value[end] - value[end - 1]) > steep * height;
        const bool real = !column.is_input && back && is_eventful(recording, column.time[i - 1], column.time[end]);
        if (back && !real && end - i <= widest) {
            first = outliers == 0 ? i : first;
            outliers += end - i;
        }
        i = end;
    }
    if (outliers == 0) {
        return {};
    }
    const std::string where = fmt::format("at {:.6g} s, {} off the samples about it", column.time[first],
                                          column.show_difference(std::abs(off[first])));
    return outliers == 1 ? fmt::format("has an outlier {}", where)
                         : fmt::format("has {} outliers, the first {}", outliers, where);
}

}  // namespace tiretherm::cases
