// SPDX-License-Identifier: BSD-3-Clause
// Bridges short gaps by straight lines and refuses long ones.

#include "input/measurements/logged_signal.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "input/text/units.hpp"
#include "solver/order_statistics.hpp"

namespace tiretherm::input {

namespace {

// Beyond both an input is no longer known: longer than a tire's surface takes to forget (s), and a share of the run.
constexpr double longest_gap = 60.0;
constexpr double longest_share = 0.05;

/// Stretches of missing samples.
struct Missing {
    std::size_t samples = 0;   ///< that the channel's own pace lacks
    std::size_t expected = 0;  ///< samples at its own pace
    double longest = 0.0;      ///< s, from the last value before to the first value after
    double from = 0.0;         ///< s, where the longest begins
};

/// A channel that was recorded more slowly than others has a value in every second or tenth line alone: missing is what its
/// own pace lacks. Of lines without a value at most as many are missing as there are.
Missing find_missing(const std::vector<double>& time, const std::vector<double>& value) {
    Missing missing{.expected = value.size()};
    if (std::ranges::none_of(value, [](double v) { return std::isnan(v); })) {
        return missing;
    }
    missing.expected = 0;
    const double pace = solver::median_step(known_samples(time, value).time);
    double known = time.front();
    std::size_t empty = 0;  // lines without a value since the last one with it
    const auto close = [&](double until, bool at_end) {
        // At an end the next sample would come after it, unless a whole step or more is left.
        const double left = pace > 0.0 ? (until - known) / pace : 0.0;
        const double steps = at_end ? std::floor(left + 1e-6) : std::round(left) - 1.0;
        const std::size_t lacking =
            pace > 0.0 ? static_cast<std::size_t>(std::clamp(steps, 0.0, static_cast<double>(empty))) : empty;
        missing.samples += lacking;
        missing.expected += lacking;
        return lacking > 0;
    };
    for (std::size_t i = 0; i < time.size(); ++i) {
        const bool here = !std::isnan(value[i]);
        missing.expected += here ? 1 : 0;
        empty += here ? 0 : 1;
        if (here || i + 1 == time.size()) {
            const bool at_end = !here || empty == i;  // of the run, whose other side is not known
            const bool gap = empty > 0 && close(time[i], at_end);
            if (gap && time[i] - known > missing.longest) {
                missing.longest = time[i] - known;
                missing.from = known;
            }
            known = time[i];
            empty = 0;
        }
    }
    return missing;
}

}  // namespace

std::string base_unit(const std::optional<std::string>& unit) {
    const std::string base = unit && !unit->empty() ? signature(*unit) : "1";
    return base.empty() ? "1" : base;
}

const UserColumn* find_column(const std::vector<UserColumn>& columns, std::string_view name) {
    const auto found = std::ranges::find(columns, name, &UserColumn::name);
    return found == columns.end() ? nullptr : &*found;
}

solver::SignalHistory known_samples(const std::vector<double>& time, const std::vector<double>& value) {
    solver::SignalHistory known;
    known.time.reserve(time.size());
    known.value.reserve(time.size());
    for (std::size_t k = 0; k < time.size(); ++k) {
        if (!std::isnan(value[k])) {
            known.time.push_back(time[k]);
            known.value.push_back(value[k]);
        }
    }
    return known;
}

namespace {

/// A signal of which each value counts until the next sample: a jump there, as two points at one time.
solver::SignalHistory held(const solver::SignalHistory& samples) {
    solver::SignalHistory steps;
    for (std::size_t i = 0; i < samples.time.size(); ++i) {
        if (i > 0 && samples.value[i] != samples.value[i - 1] && samples.time[i] > samples.time[i - 1]) {
            steps.time.push_back(samples.time[i]);
            steps.value.push_back(samples.value[i - 1]);
        }
        steps.time.push_back(samples.time[i]);
        steps.value.push_back(samples.value[i]);
    }
    return steps;
}

/// Reports gaps in a signal as an error, or as a warning. @returns whether it is known well enough
bool judge_gaps(const std::string& name, const std::vector<double>& time, const std::vector<double>& value,
                const GapRemedy& remedy, InputErrors& errors) {
    if (std::optional<ErrorText> error = gap_error(name, time, value)) {
        const bool splits = remedy.can_split && !error->remedy.empty();
        errors.add(remedy.place, error->what,
                   splits ? fmt::format("{}; or {}", error->remedy, remedy.elsewhere) : remedy.elsewhere);
        return false;
    }
    if (const Missing missing = find_missing(time, value); missing.samples > 0) {
        errors.warn(remedy.place,
                    "{} is missing in {} of {} samples, for at most {:.6g} s from {:.6g} s on: it "
                    "is taken as straight between its neighbours",
                    name, missing.samples, missing.expected, missing.longest, missing.from);
    }
    return true;
}

}  // namespace

std::optional<DrivingSamples> driving_samples(DrivingColumn column, const GapRemedy& remedy, InputErrors& errors) {
    if (!judge_gaps(column.name, column.time, column.value, remedy, errors)) {
        return std::nullopt;
    }
    const bool is_whole = std::ranges::none_of(column.value, [](double v) { return std::isnan(v); });
    if (is_whole && !column.holds && column.before.times == 0) {
        return DrivingSamples{column.time, std::move(column.value)};
    }
    solver::SignalHistory known = column.before.before(known_samples(column.time, column.value));
    known = column.holds ? held(known) : std::move(known);
    return DrivingSamples{std::move(known.time), std::move(known.value)};
}

bool too_long_a_gap(double gap, double length) { return gap > longest_gap && gap > longest_share * length; }

std::optional<ErrorText> gap_error(const std::string& name, const std::vector<double>& time,
                                   const std::vector<double>& value) {
    const Missing missing = find_missing(time, value);
    const double length = time.back() - time.front();
    if (std::ranges::all_of(value, [](double v) { return std::isnan(v); })) {
        return ErrorText{fmt::format("{} has no value in the run", name), ""};
    }
    if (too_long_a_gap(missing.longest, length)) {
        return ErrorText{fmt::format("{} is missing for {:.6g} s from {:.6g} s on, {:.0f} % of the run", name,
                                     missing.longest, missing.from, 100.0 * missing.longest / length),
                         "split the run there: a [[run]] up to the gap and one from its end, with from and to"};
    }
    if (missing.longest > short_gap &&
        static_cast<double>(missing.samples) > most_missing_share * static_cast<double>(missing.expected)) {
        return ErrorText{fmt::format("{} is missing in {} of {} samples", name, missing.samples, missing.expected),
                         "leave out the part where it is missing, with from and to"};
    }
    return std::nullopt;
}

}  // namespace tiretherm::input
