// SPDX-License-Identifier: BSD-3-Clause
// The charts of a run's page: channels against time with measured values, inputs below, heat by effect.
#include <algorithm>
#include <cmath>
#include <functional>

#include <fmt/format.h>

#include "physics/celsius.hpp"
#include "post/page/time_chart.hpp"
#include "post/run/run_sections.hpp"

namespace tiretherm::post {

namespace {

TimeRanges measured_of(const RunRecord& run, std::size_t channel) {
    TimeRanges ranges;
    for (const solver::Measured& measured : run.problem.measured) {
        const double at = std::isfinite(measured.time) ? measured.time : run.history.time().back();
        if (measured.channel == run.problem.channels[channel].name && at <= run.history.time().back()) {
            ranges.time.push_back(at);
            ranges.low.push_back(measured.low);
            ranges.high.push_back(measured.high);
        }
    }
    return ranges;
}

/// Of a hot spot its course, its critical temperature, and the moment at which it passes that.
TimeSeries series_of(const diagnosis::HotSpot& spot) {
    const solver::Critical& critical = spot.history.critical();
    const double level = celsius(critical.temperature);
    TimeSeries series{.channel = critical.name, .unit = solver::shown_unit(solver::Quantity::temperature)};
    series.curves = {{"hottest, " + critical.name, CurveRole::dashed, spot.history.time(), spot.history.temperature()}};
    series.levels = {{fmt::format("{}: critical {:.5g} °C", critical.name, level), critical.temperature}};
    if (spot.passing) {
        const TimeUnit time = time_unit(spot.history.time().back() - spot.history.time().front());
        std::string text = fmt::format("{} passes {:.5g} °C: {:.4g} {}", critical.name, level,
                                       spot.passing->time / time.seconds, time.name);
        if (spot.passing->step && !spot.passing->step->ramp) {
            text += fmt::format(", step {}", spot.passing->step->number);
        }
        text += fmt::format(", {:.0f} km/h", 3.6 * spot.passing->speed);
        series.marks = {{text, critical.temperature, spot.passing->time}};
    }
    return series;
}

std::string caption_of(const RunRecord& run) {
    std::string text = "Lines are simulated";
    text += run.problem.measured.empty() ? "." : "; a bar with circles is a measured value or range.";
    if (run.hot_spots != nullptr) {
        text += " A circle marks where a hot spot passes its critical temperature.";
    }
    return text;
}

}  // namespace

void add_channel_charts(ReportSection& section, std::span<const RunRecord> runs) {
    const RunRecord& run = runs.front();
    const bool is_single = runs.size() == 1;
    if (run.history.rows() < 2 || (run.problem.channels.empty() && run.hot_spots == nullptr)) {
        return;
    }
    TimeChart chart{.laps = run.laps};
    for (const RunRecord& one : runs) {
        for (std::size_t c = 0; c < one.problem.channels.size(); ++c) {
            const solver::Channel& channel = one.problem.channels[c];
            const std::string name = is_single ? channel.name : channel.name + " " + one.corner;
            chart.series.push_back({.channel = name,
                                    .unit = solver::shown_unit(channel.quantity),
                                    .curves = {{name, CurveRole::line, one.history.time(), one.history.channel(c)}},
                                    .measured = measured_of(one, c)});
        }
    }
    if (is_single) {
        chart.inputs = &run.problem.input_signals;
        for (std::size_t i = 0; run.hot_spots != nullptr && i < run.hot_spots->spots.size(); ++i) {
            chart.series.push_back(series_of(run.hot_spots->spots[i]));
        }
    }
    add_time_chart(section, "Sensors against time", caption_of(run), std::move(chart));
}

void add_heat_course(ReportSection& section, const RunRecord& run) {
    if (run.history.rows() < 2 || run.problem.settings.steady) {
        return;
    }
    const std::vector<double>& time = run.history.time();
    TimeChart chart{.inputs = &run.problem.input_signals, .has_input_panels = false, .laps = run.laps};
    std::vector<double> sum(time.size(), 0.0);
    const auto add = [&](const std::string& name, const std::string& colour, CurveRole role,
                         std::vector<double> watts) {
        chart.series.push_back({.channel = colour,
                                .unit = {"W"},
                                .panel = "heat into it",
                                .curves = {{name, role, time, std::move(watts)}}});
    };
    for (std::size_t e = 0; e < run.problem.effects.size(); ++e) {
        std::vector<double> watts = scaled(run.history.watts(e), run.problem.symmetry);
        if (std::ranges::all_of(watts, [](double value) { return value == 0.0; })) {
            continue;
        }
        std::ranges::transform(sum, watts, sum.begin(), std::plus<>());
        const std::string name(run.problem.effects[e].title());
        add(name, "heat of " + name, CurveRole::line, std::move(watts));
    }
    if (chart.series.empty()) {
        return;
    }
    add("sum: what is stored", "sum of heat", CurveRole::dashed, std::move(sum));
    chart.series.back().levels = {{"", 0.0}};
    add_time_chart(section, "Heat of each path against time",
                   "Above zero a path brings heat in, below zero it takes heat out; the sum is what warms the tire or "
                   "specimen.",
                   std::move(chart));
}

void add_heat_charts(ReportSection& section, const RunRecord& run) {
    std::vector<Bar> watts;
    std::vector<Bar> kilojoules;
    for (std::size_t e = 0; e < run.problem.effects.size(); ++e) {
        if (run.report.watts[e] == 0.0 && run.report.joules[e] == 0.0) {
            continue;
        }
        const std::string name(run.problem.effects[e].title());
        watts.push_back({name, run.problem.symmetry * run.report.watts[e]});
        kilojoules.push_back({name, run.problem.symmetry * run.report.joules[e] / 1e3});
    }
    if (watts.empty()) {
        return;
    }
    section.chart("Heat at the end", "What each path brings in; below zero it takes out.",
                  bar_chart("heat", "W", watts));
    if (!run.problem.settings.steady) {
        section.chart("Heat in all", "Summed over the run.", bar_chart("heat", "kJ", kilojoules));
    }
}

}  // namespace tiretherm::post
