// SPDX-License-Identifier: BSD-3-Clause
// Data check: jumps of the time column, and single outliers by the distance from a running median in robust standard
// deviations.

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "input/measurements/data_stretches.hpp"
#include "input/measurements/data_warnings.hpp"
#include "solver/order_statistics.hpp"

/// What looks suspicious in the course of a signal, whatever its unit.
namespace tiretherm::input {

namespace {

constexpr double long_interval = 10.0;   ///< times the median one: the logger was paused
constexpr double long_recording = 2e5;   ///< s; no test of a tire lasts two days at this many samples
constexpr double outlying = 8.0;         ///< robust standard deviations
constexpr double least_scale = 0.0025;   ///< of a sensor's range: what is small beside it is no outlier
constexpr double least_of_input = 0.01;  ///< of an input's range, which may have corners
constexpr double surely_beyond = 3.0;    ///< of the limit: no tire has it
constexpr double least_sure = 10.0;      ///< K
constexpr double steep = 0.75;           ///< of its height that a spike rises and falls at once; a cusp does not
constexpr double lively = 2.0;           ///< steps of an input about its spike, which is higher
constexpr std::size_t half_window = 5;   ///< samples on either side of a running median
constexpr std::size_t widest_spike = 3;  ///< samples; what lasts longer is an event. Of an input a single one

/// How far each sample lies from the median of those about it.
std::vector<double> off_median(const std::vector<double>& value) {
    std::vector<double> off(value.size());
    std::vector<double> about;  // those about a sample, ascending
    const auto place = [&](std::size_t i) { return std::ranges::lower_bound(about, value[i]); };
    const auto exchange = [&](std::size_t old, double fresh) {
        auto at = place(old);
        for (; at + 1 != about.end() && at[1] < fresh; ++at) {
            *at = at[1];
        }
        for (; at != about.begin() && at[-1] > fresh; --at) {
            *at = at[-1];
        }
        *at = fresh;
    };
    for (std::size_t i = 0; i < std::min(half_window, value.size()); ++i) {
        about.insert(place(i), value[i]);
    }
    for (std::size_t i = 0; i < value.size(); ++i) {
        if (i > half_window && i + half_window < value.size()) {
            exchange(i - half_window - 1, value[i + half_window]);
        } else if (i > half_window) {
            about.erase(place(i - half_window - 1));
        } else if (i + half_window < value.size()) {
            about.insert(place(i + half_window), value[i + half_window]);
        }
        off[i] = value[i] - about[about.size() / 2];
    }
    return off;
}

/// A robust standard deviation of the differences, not below what the logger resolves and what would matter.
/// @param counts which samples are measured: one that stands still scatters by nothing
double scale_of(const RecordedColumn& column, const std::vector<double>& off, const std::vector<bool>& counts) {
    std::vector<double> magnitudes;
    magnitudes.reserve(off.size());
    for (std::size_t i = 0; i < off.size(); ++i) {
        if (counts[i]) {
            magnitudes.push_back(std::abs(off[i]));
        }
    }
    if (magnitudes.empty()) {
        return std::numeric_limits<double>::infinity();
    }
    const double least = column.is_input ? least_of_input : least_scale;
    return std::max(
        {1.4826 * solver::median(std::move(magnitudes)), least * (column.high() - column.low()), column.resolution()});
}

/// The largest step between neighbouring samples about a spike, which is left out.
double largest_step_about(const std::vector<double>& value, std::size_t first, std::size_t end) {
    double largest = 0.0;
    for (std::size_t i = first > half_window ? first - half_window : 1; i < std::min(end + half_window, value.size());
         ++i) {
        if (i < first || i > end) {
            largest = std::max(largest, std::abs(value[i] - value[i - 1]));
        }
    }
    return largest;
}

/// Samples that leave the others at once and come back.
std::vector<Outlier> look_for_outliers(const Recording& recording, const RecordedColumn& column) {
    const std::vector<double>& value = column.value;
    if (value.size() < 2 * half_window + 1) {
        return {};
    }
    std::vector<bool> counts(value.size(), true);
    if (!column.is_input) {
        for (const Stretch& stretch : unusable_stretches(recording, column)) {
            std::fill_n(counts.begin() + static_cast<std::ptrdiff_t>(stretch.first), stretch.length, false);
        }
    }
    const std::vector<double> off = off_median(value);
    const double limit = outlying * scale_of(column, off, counts);
    const std::size_t widest = column.is_input ? 1 : widest_spike;
    std::vector<Outlier> found;
    for (std::size_t i = 1; i + 1 < value.size(); ++i) {
        if (std::abs(off[i]) <= limit || !counts[i]) {
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
        // A driver's inputs move from sample to sample: a spike no higher than what they do about it is none.
        const bool usual = column.is_input && back && height <= lively * largest_step_about(value, i, end);
        if (back && !real && !usual && end - i <= widest) {
            const bool is_sure =
                !column.is_input && column.is_temperature() && height > surely_beyond * limit && height > least_sure;
            found.push_back({.where = {.first = i, .length = end - i}, .height = height, .is_sure = is_sure});
        }
        i = end;
    }
    return found;
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
    std::vector<double> between;  // the samples; lines that stand twice have no interval
    between.reserve(time.size());
    std::size_t before_longest = 0;
    for (std::size_t i = 1; i < time.size(); ++i) {
        const double interval = time[i] - time[i - 1];
        if (interval > 0.0) {
            between.push_back(interval);
        }
        before_longest = interval > time[before_longest + 1] - time[before_longest] ? i - 1 : before_longest;
    }
    if (between.empty()) {
        return {};
    }
    const double longest = time[before_longest + 1] - time[before_longest];
    const double usual = solver::median(between);
    const auto jumps = std::ranges::count_if(between, [&](double one) { return one > long_interval * usual; });
    if (jumps == 0) {
        return {};
    }
    const std::string from = fmt::format("{:.6g} s", time[before_longest]);
    const std::string how = jumps == 1
                                ? fmt::format("jumps by {:.6g} s after {}", longest, from)
                                : fmt::format("jumps {} times, at most by {:.6g} s after {}", jumps, longest, from);
    return fmt::format("{}, where a sample mostly comes every {:.6g} s: was the logger paused?", how, usual);
}

const std::vector<Outlier>& outliers_of(const Recording& recording, const RecordedColumn& column) {
    return column.known.outliers.get([&] { return look_for_outliers(recording, column); });
}

std::string find_outliers(const Recording& recording, const RecordedColumn& column) {
    const std::vector<Outlier>& found = outliers_of(recording, column);
    if (found.empty()) {
        return {};
    }
    std::size_t samples = 0;
    std::size_t sure = 0;
    for (const Outlier& one : found) {
        samples += one.where.length;
        sure += one.is_sure ? one.where.length : 0;
    }
    const std::string where =
        fmt::format("at {:.6g} s, {} off the samples about it", column.time[found.front().where.first],
                    column.show_difference(found.front().height));
    const std::string left = sure == 0 || recording.keep_suspicious ? ""
                             : sure == samples
                                 ? fmt::format("; {} left out", sure == 1 ? "it is" : "they are")
                                 : fmt::format("; {} of them {} left out", sure, sure == 1 ? "is" : "are");
    return (samples == 1 ? fmt::format("has an outlier {}", where)
                         : fmt::format("has {} outliers, the first {}", samples, where)) +
           left;
}

}  // namespace tiretherm::input
