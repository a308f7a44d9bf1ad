// SPDX-License-Identifier: BSD-3-Clause
// Series, their values at a time, and the union of their points.
#include "solver/input_signals.hpp"

#include <algorithm>
#include <functional>
#include <iterator>

namespace tiretherm::solver {

namespace {

/// @param all ascending, unique  @param more in any order, with doubles; those of a log's next column are mostly the same
void merge(SharedSamples& all, const SharedSamples& more) {
    if (more.empty() || more == all) {
        return;
    }
    if (all.empty() && std::ranges::adjacent_find(more, std::greater_equal{}) == more.end()) {
        all = more;
        return;
    }
    std::vector<double> sorted = more;
    std::ranges::sort(sorted);
    std::vector<double> merged;
    merged.reserve(all.size() + sorted.size());
    std::ranges::set_union(all, sorted, std::back_inserter(merged));
    merged.erase(std::unique(merged.begin(), merged.end()), merged.end());
    all = std::move(merged);
}

/// The first point that comes after a time, or at it if the side before counts. A log's samples are nearly even: it is looked for from where
/// it would then be, farther away each time.
std::size_t next_point(const std::vector<double>& time, double t, JumpSide side) {
    const auto is_past = [&](double point) { return side == JumpSide::after ? point <= t : point < t; };
    const double share = (t - time.front()) / (time.back() - time.front());
    const auto n = std::ssize(time);
    std::ptrdiff_t begin = share >= 1.0  ? n
                           : share > 0.0 ? static_cast<std::ptrdiff_t>(share * static_cast<double>(n))
                                         : 0;
    std::ptrdiff_t end = begin;
    for (std::ptrdiff_t step = 1; begin > 0 && !is_past(time[static_cast<std::size_t>(begin - 1)]); step *= 2) {
        end = begin - 1;
        begin -= std::min(step, begin);
    }
    for (std::ptrdiff_t step = 1; end < n && is_past(time[static_cast<std::size_t>(end)]); step *= 2) {
        begin = end + 1;
        end += std::min(step, n - end);
    }
    const auto next = std::partition_point(time.begin() + begin, time.begin() + end, is_past);
    return static_cast<std::size_t>(next - time.begin());
}

/// @param next the first point after `t`
double value_before(const std::vector<double>& time, const std::vector<double>& value, std::size_t next, double t) {
    if (next == 0) {
        return value.front();
    }
    if (next == time.size()) {
        return value.back();
    }
    if (time[next] == t) {  // to the last digit the same from both sides
        return value[next];
    }
    const double width = time[next] - time[next - 1];
    return width > 0.0 ? value[next - 1] + (value[next] - value[next - 1]) * (t - time[next - 1]) / width : value[next];
}

}  // namespace

double Series::at(double t, JumpSide side) const { return value_before(time, value, next_point(time, t, side), t); }

void InputSignals::add(const physics::Signal& signal, double constant) {
    constants_.*signal.member = constant;
    given_.push_back(&signal);
}

void InputSignals::add(Series series) {
    given_.push_back(series.signal);
    const auto has_jumps = [&] { return std::ranges::adjacent_find(series.time) != series.time.end(); };
    if (series.logged && !has_jumps()) {
        add_sample_times(series.time);
        series_.push_back(std::move(series));
        return;
    }
    std::vector<double> stops;
    std::vector<double> samples;
    for (std::size_t i = 0; i < series.time.size(); ++i) {
        const bool jump = i > 0 && series.time[i] == series.time[i - 1];
        (series.logged && !jump ? samples : stops).push_back(series.time[i]);
    }
    add_break_times(std::move(stops));
    add_sample_times(std::move(samples));
    series_.push_back(std::move(series));
}

void InputSignals::replace(Series series) {
    std::erase_if(series_, [&](const Series& other) { return other.signal == series.signal; });
    std::erase(given_, series.signal);
    add(std::move(series));
}

void InputSignals::add_break_times(SharedSamples times) { merge(stops_, times); }

void InputSignals::add_sample_times(SharedSamples times) { merge(samples_, times); }

void InputSignals::advance(const physics::Signal& signal, double delay) {
    for (Series& series : series_) {
        if (series.signal != &signal) {
            continue;
        }
        if (series.logged) {
            std::vector<double> in_time(series.time.size());
            for (std::size_t i = 0; i < in_time.size(); ++i) {
                const bool second = i > 0 && series.time[i] == series.time[i - 1];
                in_time[i] = series.at(series.time[i] + delay, second ? JumpSide::after : JumpSide::before);
            }
            series.value = std::move(in_time);
        } else {
            std::vector<double> earlier = series.time;
            std::ranges::for_each(earlier, [&](double& t) { t -= delay; });
            series.time = std::move(earlier);
            add_break_times(series.time);
        }
    }
}

void InputSignals::move(const physics::Signal& signal, double factor, double by) {
    if (gives(signal)) {
        constants_.*signal.member = factor * constants_.*signal.member + by;
    }
    for (Series& series : series_) {
        if (series.signal == &signal) {
            std::vector<double> moved = series.value;
            std::ranges::for_each(moved, [&](double& value) { value = factor * value + by; });
            series.value = std::move(moved);
        }
    }
}

bool InputSignals::gives(const physics::Signal& signal) const {
    return std::find(given_.begin(), given_.end(), &signal) != given_.end();
}

physics::Inputs InputSignals::at(double t, JumpSide side) const {
    physics::Inputs inputs = constants_;
    inputs.time = t - start_;
    const double* times = nullptr;  // of the column before, which those of one log share
    std::size_t next = 0;
    for (const Series& s : series_) {
        if (s.time.data() != times) {
            times = s.time.data();
            next = next_point(s.time, t, side);
        }
        inputs.*(s.signal->member) = value_before(s.time, s.value, next, t);
    }
    return inputs;
}

}  // namespace tiretherm::solver
