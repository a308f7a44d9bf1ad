// SPDX-License-Identifier: BSD-3-Clause
// Spreads lines over the steps of a coarse clock.

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "input/clock/clock_times.hpp"
#include "solver/order_statistics.hpp"

namespace tiretherm::input {

namespace {

/// Lines that follow one another with one time.
struct Tick {
    std::size_t first = 0;
    std::size_t count = 0;
    double time = 0.0;  ///< s
};

std::vector<Tick> ticks_of(const std::vector<double>& times) {
    std::vector<Tick> ticks;
    for (std::size_t i = 0; i < times.size(); ++i) {
        const bool goes_on = !ticks.empty() && times[i] == ticks.back().time;
        if (goes_on && ticks.back().first + ticks.back().count == i) {
            ++ticks.back().count;
        } else if (!std::isnan(times[i])) {
            ticks.push_back({i, 1, times[i]});
        }
    }
    return ticks;
}

/// Of an even number the lower one: one tick among two is not the usual one.
template <typename Value>
Value median_of(std::vector<Value> values) {
    const std::size_t middle = (values.size() - 1) / 2;
    return solver::nth_smallest(std::move(values), middle);
}

/// The coarsest step of a clock that shows all these times; 0 for one that is finer than a millisecond.
double resolution_of(const std::vector<Tick>& ticks) {
    // The steps that clocks of loggers are written in: whole minutes, whole seconds, tenths to thousandths.
    constexpr std::array steps{60.0, 1.0, 0.1, 0.01, 0.001};
    const auto shows = [&](double step) {
        return std::ranges::all_of(ticks, [&](const Tick& tick) {
            const double counted = (tick.time - ticks.front().time) / step;
            return std::abs(counted - std::round(counted)) < 1e-3;
        });
    };
    const auto found = std::ranges::find_if(steps, shows);
    return found == steps.end() ? 0.0 : *found;
}

}  // namespace

std::string share_out(std::vector<double>& times, std::size_t least) {
    const std::vector<Tick> ticks = ticks_of(times);
    std::vector<std::size_t> counts;
    std::vector<double> steps;
    for (std::size_t i = 0; i < ticks.size(); ++i) {
        counts.push_back(ticks[i].count);
        if (i > 0 && ticks[i].time > ticks[i - 1].time) {
            steps.push_back(ticks[i].time - ticks[i - 1].time);
        }
    }
    if (steps.empty()) {
        return {};
    }
    const double step = median_of(steps);
    const std::size_t most = std::ranges::max(counts);
    const std::size_t usual = median_of(counts);
    // Two lines at one time are a jump on purpose where the clock could have told them apart.
    const bool hides = most > 2 || (most == 2 && step < 1.5 * resolution_of(ticks));
    if (!hides || usual < least) {
        return {};
    }
    for (std::size_t i = 0; i < ticks.size(); ++i) {
        const Tick& tick = ticks[i];
        const bool has_next = i + 1 < ticks.size() && ticks[i + 1].time > tick.time;
        const double width = has_next ? std::min(ticks[i + 1].time - tick.time, step) : step;
        // The recording begins and ends within a step: what it has of that stands at the step's end and at its start.
        const bool is_part = tick.count < usual && (i == 0 || i + 1 == ticks.size());
        const double apart = width / static_cast<double>(is_part ? usual : tick.count);
        const std::size_t before = is_part && i == 0 ? usual - tick.count : 0;
        for (std::size_t k = 0; k < tick.count; ++k) {
            times[tick.first + k] = tick.time + static_cast<double>(before + k) * apart;
        }
    }
    return fmt::format("the clock goes on by {:g} s, and up to {} lines have one time: they are spread evenly over it",
                       step, most);
}

}  // namespace tiretherm::input
