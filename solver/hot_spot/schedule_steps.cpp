// SPDX-License-Identifier: BSD-3-Clause
// Splits a run at the points of its schedules into steps and ramps, and joins neighbours with the same speed and load.

#include "solver/hot_spot/schedule_steps.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace tiretherm::solver {

namespace {

bool alike(double a, double b) { return std::abs(a - b) <= 1e-9 * std::max({1.0, std::abs(a), std::abs(b)}); }

bool follows_log(const InputSignals& input_signals) {
    return std::ranges::any_of(input_signals.series(), [](const Series& series) {
        return series.logged && (series.signal->name == "speed" || series.signal->name == "vertical_load") &&
               !std::ranges::all_of(series.value, [&](double value) { return value == series.value.front(); });
    });
}

}  // namespace

std::vector<ScheduleStep> schedule_steps(const InputSignals& input_signals, double start, double end) {
    if (follows_log(input_signals)) {
        return recognised_steps(input_signals, start, end);
    }
    std::vector<ScheduleStep> steps;
    std::vector<double> border{start};
    std::ranges::copy_if(input_signals.stops(), std::back_inserter(border),
                         [&](double t) { return t > start && t < end; });
    border.push_back(end);
    for (std::size_t i = 0; i + 1 < border.size(); ++i) {
        const physics::Inputs first = input_signals.at(border[i], JumpSide::after);
        const physics::Inputs last = input_signals.at(border[i + 1], JumpSide::before);
        const bool ramp = !alike(first.speed, last.speed) || !alike(first.vertical_load, last.vertical_load);
        // A stop of another input does not end a step.
        const bool joins = !steps.empty() && !ramp && !steps.back().ramp && alike(steps.back().speed, last.speed) &&
                           alike(steps.back().load, last.vertical_load);
        if (joins) {
            steps.back().to = border[i + 1];
            continue;
        }
        const int before = steps.empty() ? 0 : steps.back().number - (steps.back().ramp ? 1 : 0);
        steps.push_back({.number = before + 1,
                         .ramp = ramp,
                         .from = border[i],
                         .to = border[i + 1],
                         .speed = last.speed,
                         .load = last.vertical_load});
        if (steps.size() > most_schedule_steps) {
            return {};
        }
    }
    return steps;
}

const ScheduleStep* step_at(std::span<const ScheduleStep> steps, double t) {
    const auto found = std::ranges::find_if(steps, [&](const ScheduleStep& step) { return t <= step.to; });
    return found == steps.end() ? nullptr : &*found;
}

}  // namespace tiretherm::solver
