// SPDX-License-Identifier: BSD-3-Clause
// Cuts the series of inputs to a run.
#include "post/page/input_panels.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string_view>

#include <fmt/format.h>

#include "physics/celsius.hpp"

namespace tiretherm::post {

namespace {

constexpr std::size_t most_panels = 3;

/// A series between two times, its ends included.
TimeCurve curve_of(const solver::Series& series, double start, double end) {
    TimeCurve curve{.name = std::string(series.signal->name), .time = {}, .value = {}};
    std::ranges::replace(curve.name, '_', ' ');
    const auto add = [&](double t, double value) {
        curve.time.push_back(t);
        curve.value.push_back(value);
    };
    add(start, series.at(start, solver::JumpSide::after));
    for (std::size_t i = 0; i < series.time.size(); ++i) {
        if (series.time[i] > start && series.time[i] < end) {
            add(series.time[i], series.value[i]);
        }
    }
    add(end, series.at(end, solver::JumpSide::before));
    return curve;
}

/// As it is shown: of a temperature a change beside degrees Celsius.
bool stands_still(const TimeCurve& curve, const solver::ShownUnit& unit) {
    const auto [low, high] = std::ranges::minmax(curve.value);
    return !(unit.difference(high - low) > 1e-9 * std::max(1.0, std::abs(unit.value(high))));
}

bool differ(std::span<const solver::ScheduleStep> steps, double solver::ScheduleStep::*member) {
    const solver::ScheduleStep* first = nullptr;
    for (const solver::ScheduleStep& step : steps) {
        if (step.ramp) {
            continue;
        }
        first = first == nullptr ? &step : first;
        if (std::abs(step.*member - first->*member) > 1e-3 * std::max(1.0, std::abs(first->*member))) {
            return true;
        }
    }
    return false;
}

}  // namespace

solver::ShownUnit shown_unit(const physics::Signal& signal) {
    if (signal.unit == "m s-1") {
        return {"km/h", 3.6};
    }
    if (signal.unit == "radian") {
        return {"°", 180.0 / std::numbers::pi};
    }
    if (signal.unit == "Pa") {
        return {"kPa", 1e-3};
    }
    if (signal.unit == "K") {
        return {"°C", 1.0, zero_celsius};
    }
    return {signal.unit == "1" ? "" : signal.unit.data()};
}

std::vector<std::string> step_names(std::span<const solver::ScheduleStep> steps) {
    const bool by_load = differ(steps, &solver::ScheduleStep::load);
    const bool by_speed = differ(steps, &solver::ScheduleStep::speed) || !by_load;
    std::vector<std::string> names;
    for (const solver::ScheduleStep& step : steps) {
        std::string name;
        if (!step.ramp && by_speed) {
            name = fmt::format("{:.0f} km/h", 3.6 * step.speed);
        }
        if (!step.ramp && by_load) {
            name += fmt::format("{}{:.0f} N", name.empty() ? "" : ", ", step.load);
        }
        names.push_back(std::move(name));
    }
    return names;
}

std::vector<TimeSeries> changing_inputs(const solver::InputSignals& inputs, double start, double end) {
    std::vector<TimeSeries> found;
    std::set<std::string_view> units;
    for (const physics::Signal& signal : physics::signals()) {  // speed and load come first in this order
        const solver::ShownUnit unit = shown_unit(signal);
        for (const solver::Series& series : inputs.series()) {
            if (series.signal != &signal || series.time.empty() || signal.name == "wheel_angle" ||
                (units.size() == most_panels && !units.contains(unit.name))) {
                continue;
            }
            if (TimeCurve curve = curve_of(series, start, end); !stands_still(curve, unit)) {
                units.insert(unit.name);
                found.push_back({.channel = curve.name, .unit = unit, .is_input = true, .curves = {std::move(curve)}});
            }
        }
    }
    return found;
}

void add_step_bands(LineChart& chart, std::span<const solver::ScheduleStep> steps, double seconds) {
    if (std::ranges::count(steps, false, &solver::ScheduleStep::ramp) < 2) {
        return;
    }
    const std::vector<std::string> names = step_names(steps);
    for (std::size_t s = 0; s < steps.size(); ++s) {
        chart.add_span(names[s], steps[s].from / seconds, steps[s].to / seconds);
    }
}

void add_lap_bands(LineChart& chart, std::span<const input::Lap> laps, double seconds) {
    for (const input::Lap& lap : laps) {
        const std::string name = lap.kind == input::LapKind::out  ? "out"
                                 : lap.kind == input::LapKind::in ? "in"
                                                                  : fmt::format("lap {}", lap.number);
        chart.add_span(name, lap.start / seconds, lap.end / seconds);
    }
}

}  // namespace tiretherm::post
