// SPDX-License-Identifier: BSD-3-Clause
// The charts of a run's page: channels against time with measured values, inputs below, heat by effect.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "physics/celsius.hpp"
#include "post/page/charts.hpp"
#include "post/page/input_panels.hpp"
#include "post/run/run_sections.hpp"
#include "solver/channel_unit.hpp"

namespace tiretherm::post {

namespace {

/// Channels of one unit, in the order of their first.
struct Group {
    solver::ShownUnit unit;
    std::vector<std::size_t> channels;
};

std::vector<Group> groups_of(const solver::Problem& problem) {
    std::vector<Group> groups;
    for (std::size_t c = 0; c < problem.channels.size(); ++c) {
        const solver::ShownUnit unit = solver::shown_unit(problem.channels[c].quantity);
        auto group =
            std::ranges::find_if(groups, [&](const Group& g) { return std::string_view(g.unit.name) == unit.name; });
        if (group == groups.end()) {
            group = groups.insert(groups.end(), Group{unit, {}});
        }
        group->channels.push_back(c);
    }
    return groups;
}

/// @param called the channel's curve
void add_measured(LineChart& chart, const RunRecord& run, std::size_t channel, const std::string& called,
                  const solver::ShownUnit& unit, const TimeUnit& time) {
    std::vector<double> t;
    std::vector<double> low;
    std::vector<double> high;
    const std::string& name = run.problem.channels[channel].name;
    for (const solver::Measured& measured : run.problem.measured) {
        const double at = std::isfinite(measured.time) ? measured.time : run.history.time().back();
        if (measured.channel == name && at <= run.history.time().back()) {
            t.push_back(at / time.seconds);
            low.push_back(unit.value(measured.low));
            high.push_back(unit.value(measured.high));
        }
    }
    if (!t.empty()) {
        chart.add_ranges(called + ", measured", called, t, low, high);
    }
}

/// Of each hot spot its course, its critical temperature, and the moment at which it passes that.
void add_hot_spots(LineChart& chart, const diagnosis::HotSpots& hot_spots, const TimeUnit& time) {
    for (const diagnosis::HotSpot& spot : hot_spots.spots) {
        const solver::Critical& critical = spot.history.critical();
        const double level = celsius(critical.temperature);
        chart.add_curve("hottest, " + critical.name, critical.name, CurveRole::dashed,
                        scaled(spot.history.time(), 1.0 / time.seconds),
                        converted(spot.history.temperature(), celsius));
        chart.add_level(fmt::format("{}: critical {:.5g} °C", critical.name, level), level);
        if (spot.passing) {
            std::string text = fmt::format("{} passes {:.5g} °C: {:.4g} {}", critical.name, level,
                                           spot.passing->time / time.seconds, time.name);
            if (spot.passing->step && !spot.passing->step->ramp) {
                text += fmt::format(", step {}", spot.passing->step->number);
            }
            text += fmt::format(", {:.0f} km/h", 3.6 * spot.passing->speed);
            chart.add_mark(text, critical.name, spot.passing->time / time.seconds, level);
        }
    }
}

constexpr std::size_t points_of_a_chart = 60'000;

std::string caption_of(const RunRecord& run, const std::vector<solver::ScheduleStep>& steps) {
    std::string text = "Lines are simulated";
    text += run.problem.measured.empty() ? "." : "; a bar with circles is a measured value or range.";
    if (run.laps.size() > 1) {
        text += " The bands are laps.";
    } else if (std::ranges::count(steps, false, &solver::ScheduleStep::ramp) > 1) {
        text += steps.front().recognised ? " The bands are steps of speed and load, recognised in the log."
                                         : " The bands are the steps of the schedule.";
    }
    if (run.hot_spots != nullptr) {
        text += " A circle marks where a hot spot passes its critical temperature.";
    }
    return text;
}

}  // namespace

void add_channel_charts(Section& section, std::span<const RunRecord> runs) {
    const RunRecord& run = runs.front();
    const bool is_single = runs.size() == 1;
    if (run.history.rows() < 2 || (run.problem.channels.empty() && run.hot_spots == nullptr)) {
        return;
    }
    const double start = run.history.time().front();
    const double end = run.history.time().back();
    const TimeUnit time = time_unit(end - start);
    LineChart chart("time", time.name, start / time.seconds, end / time.seconds);
    chart.share_points(points_of_a_chart, runs.size() * run.problem.channels.size());
    for (const Group& group : groups_of(run.problem)) {
        const bool is_temperature = axis_unit(group.unit.name) == "°C";
        chart.add_panel(is_temperature ? "temperature" : run.problem.channels[group.channels.front()].name,
                        axis_unit(group.unit.name), !is_temperature);
        for (const RunRecord& one : runs) {
            const std::vector<double> t = scaled(one.history.time(), 1.0 / time.seconds);
            for (const std::size_t c : group.channels) {
                const auto value = [&](double si) { return group.unit.value(si); };
                const std::string& channel = one.problem.channels[c].name;
                const std::string name = is_single ? channel : channel + " " + one.corner;
                chart.add_curve(name, name, CurveRole::line, t, converted(one.history.channel(c), value));
                add_measured(chart, one, c, name, group.unit, time);
            }
        }
        if (is_temperature && is_single && run.hot_spots != nullptr) {
            add_hot_spots(chart, *run.hot_spots, time);
        }
    }
    std::vector<solver::ScheduleStep> steps;
    if (is_single) {
        add_input_panels(chart, run.problem.input_signals, start, end, time.seconds);
    }
    if (run.laps.size() > 1) {
        add_lap_bands(chart, run.laps, time.seconds);
    } else if (is_single) {
        steps = solver::schedule_steps(run.problem.input_signals, start, end);
        add_step_bands(chart, steps, time.seconds);
    }
    chart.set_link("time");
    section.chart("Sensors against time", caption_of(run, steps), chart.data());
}

void add_heat_course(Section& section, const RunRecord& run) {
    if (run.history.rows() < 2 || run.problem.settings.steady) {
        return;
    }
    const TimeUnit time = time_unit(run.history.time().back() - run.history.time().front());
    const std::vector<double> t = scaled(run.history.time(), 1.0 / time.seconds);
    LineChart chart("time", time.name, t.front(), t.back());
    chart.share_points(points_of_a_chart, run.problem.effects.size());
    chart.add_panel("heat into it", "W");
    std::vector<double> sum(t.size(), 0.0);
    bool any = false;
    for (std::size_t e = 0; e < run.problem.effects.size(); ++e) {
        const std::vector<double> watts = scaled(run.history.watts(e), run.problem.symmetry);
        if (std::ranges::all_of(watts, [](double value) { return value == 0.0; })) {
            continue;
        }
        any = true;
        for (std::size_t row = 0; row < t.size(); ++row) {
            sum[row] += watts[row];
        }
        const std::string name(run.problem.effects[e].title());
        chart.add_curve(name, "heat of " + name, CurveRole::line, t, watts);
    }
    if (!any) {
        return;
    }
    chart.add_curve("sum: what is stored", "sum of heat", CurveRole::dashed, t, sum);
    chart.add_level("", 0.0);
    const double start = run.history.time().front();
    const double end = run.history.time().back();
    add_step_bands(chart, solver::schedule_steps(run.problem.input_signals, start, end), time.seconds);
    chart.set_link("time");
    section.chart("Heat of each path against time",
                  "Above zero a path brings heat in, below zero it takes heat out; the sum is what warms the tire or "
                  "specimen.",
                  chart.data());
}

void add_heat_charts(Section& section, const RunRecord& run) {
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
