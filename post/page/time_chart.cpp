// SPDX-License-Identifier: BSD-3-Clause
// Groups the channels by their units and converts them to what is shown.
#include "post/page/time_chart.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <tuple>

#include "post/page/input_panels.hpp"
#include "post/report/number_text.hpp"

namespace tiretherm::post {

namespace {

constexpr std::size_t points_of_a_page = 90'000;
constexpr double normal_95 = 1.959964;  ///< standard deviations

using Panel = std::vector<const TimeSeries*>;

/// Series of one unit, and of one panel where that has a name.
std::vector<Panel> panels_of(const std::vector<TimeSeries>& series) {
    const auto kind_of = [](const TimeSeries& one) {
        return std::tuple(std::string_view(one.unit.name), one.panel, one.is_input);
    };
    std::vector<Panel> panels;
    for (const TimeSeries& one : series) {
        auto panel =
            std::ranges::find(panels, kind_of(one), [&](const Panel& those) { return kind_of(*those.front()); });
        if (panel == panels.end()) {
            panel = panels.insert(panels.end(), Panel());
        }
        panel->push_back(&one);
    }
    return panels;
}

void begin_panel(LineChart& lines, const Panel& panel, bool has_differences) {
    const TimeSeries& first = *panel.front();
    const bool is_temperature = std::string_view(first.unit.name) == "degC";
    const std::string name = first.is_input && panel.size() > 1 ? "inputs"
                             : is_temperature                   ? "temperature"
                                                                : first.channel;
    lines.add_panel(first.panel.empty() ? name : first.panel, axis_unit(first.unit.name),
                    !has_differences && !is_temperature && first.panel.empty());
}

void add_values(LineChart& lines, const TimeSeries& series, double seconds) {
    const auto shown = [&](double si) { return series.unit.value(si); };
    for (const TimeCurve& curve : series.curves) {
        lines.add_curve(curve.name, series.channel, curve.role, scaled(curve.time, 1.0 / seconds),
                        converted(curve.value, shown));
    }
    if (!series.measured.time.empty()) {
        lines.add_ranges(series.channel + ", measured", series.channel, scaled(series.measured.time, 1.0 / seconds),
                         converted(series.measured.low, shown), converted(series.measured.high, shown));
    }
    for (const TimeMark& level : series.levels) {
        lines.add_level(level.name, shown(level.value));
    }
    for (const TimeMark& mark : series.marks) {
        lines.add_mark(mark.name, series.channel, mark.time / seconds, shown(mark.value));
    }
}

void add_differences(LineChart& lines, const TimeSeries& series, double seconds) {
    for (const TimeCurve& curve : series.differences) {
        lines.add_curve(curve.name, series.channel, curve.role, scaled(curve.time, 1.0 / seconds),
                        scaled(curve.value, series.unit.factor));
    }
    if (series.noise > 0.0) {
        const double reach = normal_95 * series.unit.difference(series.noise);
        const std::vector<double>& time = series.curves.front().time;
        lines.add_band(series.channel + ", noise 95 %", series.channel,
                       std::array{time.front() / seconds, time.back() / seconds}, std::array{-reach, -reach},
                       std::array{reach, reach});
    }
}

/// @returns what the bands are, for the caption
std::string add_bands(LineChart& lines, const TimeChart& chart, double from, double to, double seconds) {
    if (chart.laps.size() > 1) {
        add_lap_bands(lines, chart.laps, seconds);
        return " The bands are laps.";
    }
    if (chart.inputs == nullptr) {
        return "";
    }
    const std::vector<solver::ScheduleStep> steps = solver::schedule_steps(*chart.inputs, from, to);
    add_step_bands(lines, steps, seconds);
    if (std::ranges::count(steps, false, &solver::ScheduleStep::ramp) < 2) {
        return "";
    }
    return steps.front().recognised ? " The bands are steps of speed and load, recognised in the log."
                                    : " The bands are the steps of the schedule.";
}

}  // namespace

void add_time_chart(ReportSection& section, const std::string& title, const std::string& caption, TimeChart chart) {
    double from = 1e300;
    double to = -1e300;
    std::size_t curves = 0;
    for (const TimeSeries& series : chart.series) {
        curves += series.curves.size() + series.differences.size();
        for (const TimeCurve& curve : series.curves) {
            from = std::min(from, curve.time.front());
            to = std::max(to, curve.time.back());
        }
    }
    const auto [start, end] = chart.axis.value_or(std::pair(from, to));
    if (!(end > start)) {
        return;
    }
    const TimeUnit unit = time_unit(end - start);
    LineChart lines("time", unit.name, start / unit.seconds, end / unit.seconds);
    lines.share_points(points_of_a_page, chart.curves_of_page > 0 ? chart.curves_of_page : curves);
    if (chart.inputs != nullptr && chart.has_input_panels) {
        std::ranges::move(changing_inputs(*chart.inputs, from, to), std::back_inserter(chart.series));
    }
    for (const Panel& panel : panels_of(chart.series)) {
        const bool has_differences = !std::ranges::all_of(panel, [](auto* one) { return one->differences.empty(); });
        begin_panel(lines, panel, has_differences);
        for (const TimeSeries* series : panel) {
            add_values(lines, *series, unit.seconds);
        }
        if (has_differences) {
            lines.add_panel(chart.difference, difference_unit(panel.front()->unit.name), true);
            for (const TimeSeries* series : panel) {
                add_differences(lines, *series, unit.seconds);
            }
            lines.add_level("", 0.0);
        }
    }
    const std::string bands = add_bands(lines, chart, from, to, unit.seconds);
    lines.set_link("time");
    section.chart(title, caption + bands, lines.data());
}

}  // namespace tiretherm::post
