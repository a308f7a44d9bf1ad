// SPDX-License-Identifier: BSD-3-Clause
// The charts of a run's page: channels against time with measured values, inputs below, heat by effect.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "post/page/charts.hpp"
#include "post/run/run_sections.hpp"
#include "solver/celsius.hpp"
#include "solver/channel_unit.hpp"

namespace tiretherm::post {

namespace {

std::vector<double> scaled(std::vector<double> values, double factor) {
    for (double& value : values) {
        value *= factor;
    }
    return values;
}

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

void add_measured(LineChart& chart, const RunRecord& run, std::size_t channel, const solver::ShownUnit& unit,
                  const TimeUnit& time) {
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
        chart.add_ranges(name + ", measured", name, t, low, high);
    }
}

}  // namespace

void add_channel_charts(Section& section, const RunRecord& run) {
    if (run.history.rows() < 2 || run.problem.channels.empty()) {
        return;
    }
    const TimeUnit time = time_unit(run.history.time().back() - run.history.time().front());
    const std::vector<double> t = scaled(run.history.time(), 1.0 / time.seconds);
    LineChart chart("time", time.name, t.front(), t.back());
    for (const Group& group : groups_of(run.problem)) {
        const bool is_temperature = axis_unit(group.unit.name) == "°C";
        chart.add_panel(is_temperature ? "temperature" : run.problem.channels[group.channels.front()].name,
                        axis_unit(group.unit.name), !is_temperature);
        for (const std::size_t c : group.channels) {
            std::vector<double> values = run.history.channel(c);
            for (double& value : values) {
                value = group.unit.value(value);
            }
            const std::string& name = run.problem.channels[c].name;
            chart.add_curve(name, name, CurveRole::line, t, values);
            add_measured(chart, run, c, group.unit, time);
        }
        if (is_temperature && run.hot_spots != nullptr) {
            for (const diagnosis::HotSpot& spot : run.hot_spots->spots) {
                std::vector<double> hottest = spot.history.temperature();
                for (double& value : hottest) {
                    value = solver::celsius(value);
                }
                const solver::Critical& critical = spot.history.critical();
                chart.add_curve("hottest, " + critical.name, critical.name, CurveRole::dashed,
                                scaled(spot.history.time(), 1.0 / time.seconds), hottest);
                chart.add_level(
                    fmt::format("{}: critical {:.5g} °C", critical.name, solver::celsius(critical.temperature)),
                    solver::celsius(critical.temperature));
            }
        }
    }
    section.chart("Sensors against time", "Lines are simulated; a bar with circles is a measured value or range.",
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
