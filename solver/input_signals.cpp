// SPDX-License-Identifier: BSD-3-Clause
// Series, their values at a time, and the union of their points.
#include "solver/input_signals.hpp"

#include <algorithm>
#include <iterator>

namespace tiretherm::solver {

namespace {

/// @param all ascending, unique  @param more in any order, with doubles
void merge(std::vector<double>& all, std::vector<double> more) {
    std::ranges::sort(more);
    std::vector<double> merged;
    std::ranges::set_union(all, more, std::back_inserter(merged));
    merged.erase(std::unique(merged.begin(), merged.end()), merged.end());
    all = std::move(merged);
}

/// The first point that comes after a time, or at it if the side before counts. A log's samples are nearly even: it is looked for from where
/// it would then be, farther away each time.
std::vector<double>::const_iterator next_point(const std::vector<double>& time, double t, JumpSide side) {
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
    return std::partition_point(time.begin() + begin, time.begin() + end, is_past);
}

}  // namespace

double Series::at(double t, JumpSide side) const {
    const auto next = next_point(time, t, side);
    if (next == time.begin()) {
        return value.front();
    }
    if (next == time.end()) {
        return value.back();
    }
    const auto i = static_cast<std::size_t>(next - time.begin());
    if (time[i] == t) {  // to the last digit the same from both sides
        return value[i];
    }
    const double width = time[i] - time[i - 1];
    return width > 0.0 ? value[i - 1] + (value[i] - value[i - 1]) * (t - time[i - 1]) / width : value[i];
}

void InputSignals::add(const physics::Signal& signal, double constant) {
    constants_.*signal.member = constant;
    given_.push_back(&signal);
}

void InputSignals::add(Series series) {
    given_.push_back(series.signal);
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

void InputSignals::add_break_times(std::vector<double> times) { merge(stops_, std::move(times)); }

void InputSignals::add_sample_times(std::vector<double> times) { merge(samples_, std::move(times)); }

void InputSignals::advance(const physics::Signal& signal, double delay) {
    for (Series& series : series_) {
        if (series.signal != &signal) {
            continue;
        }
        if (series.logged) {
            const Series late = series;
            for (std::size_t i = 0; i < series.time.size(); ++i) {
                const bool second = i > 0 && series.time[i] == series.time[i - 1];
                series.value[i] = late.at(series.time[i] + delay, second ? JumpSide::after : JumpSide::before);
            }
        } else {
            for (double& t : series.time) {
                t -= delay;
            }
            add_break_times(series.time);
        }
    }
}

void InputSignals::move(const physics::Signal& signal, double factor, double by) {
    if (gives(signal)) {
        constants_.*signal.member = factor * constants_.*signal.member + by;
    }
    for (Series& series : series_) {
        for (double& value : series.value) {
            value = series.signal == &signal ? factor * value + by : value;
        }
    }
}

bool InputSignals::gives(const physics::Signal& signal) const {
    return std::find(given_.begin(), given_.end(), &signal) != given_.end();
}

physics::Inputs InputSignals::at(double t, JumpSide side) const {
    physics::Inputs inputs = constants_;
    inputs.time = t - start_;
    for (const Series& s : series_) {
        inputs.*(s.signal->member) = s.at(t, side);
    }
    return inputs;
}

}  // namespace tiretherm::solver
