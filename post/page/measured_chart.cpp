// SPDX-License-Identifier: BSD-3-Clause
// Panels by unit, and one of differences below each.
#include "post/page/measured_chart.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "diagnosis/compare/comparison_statistics.hpp"
#include "post/page/charts.hpp"
#include "post/page/input_panels.hpp"
#include "post/report/number_text.hpp"

namespace tiretherm::post {

namespace {

/// Names in the order in which they first appear.
template <typename NameOf>
std::vector<std::string> distinct(const std::vector<const MeasuredSeries*>& series, NameOf name_of) {
    std::vector<std::string> names;
    for (const MeasuredSeries* one : series) {
        if (const std::string name = name_of(*one); std::ranges::find(names, name) == names.end()) {
            names.push_back(name);
        }
    }
    return names;
}

std::string curve_name(const MeasuredSeries& series, const MeasuredSeries::Model& model) {
    return series.models.size() == 1 && model.name == "simulated" ? series.channel : series.channel + ", " + model.name;
}

CurveRole role_of(const MeasuredSeries& series, std::size_t model) {
    return model + 1 < series.models.size() ? CurveRole::dashed : CurveRole::line;
}

constexpr double parts = 40.0;  ///< of a run, over which means are taken
constexpr std::size_t least_for_means = 120;
constexpr double normal_95 = 1.959964;  ///< standard deviations

/// Means over equal parts of the time, which show what the noise hides. @returns [parts with samples] times, values
std::pair<std::vector<double>, std::vector<double>> means(const std::vector<double>& time,
                                                          const std::vector<double>& value) {
    std::map<int, std::array<double, 3>> sums;  // of times, of values, count
    const double width = (time.back() - time.front()) / parts;
    for (std::size_t i = 0; i < time.size(); ++i) {
        std::array<double, 3>& sum = sums[width > 0.0 ? static_cast<int>((time[i] - time.front()) / width) : 0];
        sum = {sum[0] + time[i], sum[1] + value[i], sum[2] + 1.0};
    }
    std::pair<std::vector<double>, std::vector<double>> found;
    for (const auto& [part, sum] : sums) {
        found.first.push_back(sum[0] / sum[2]);
        found.second.push_back(sum[1] / sum[2]);
    }
    return found;
}

/// A curve that ends where nothing was measured for long, as between laps that count, and goes on behind.
void add_in_pieces(LineChart& chart, const std::string& name, const std::string& group, CurveRole role,
                   std::span<const double> x, std::span<const double> y) {
    std::size_t first = 0;
    for (std::size_t i = 1; i <= x.size(); ++i) {
        if (i == x.size() || diagnosis::is_gap(x, i)) {
            chart.add_curve(name, group, role, x.subspan(first, i - first), y.subspan(first, i - first));
            first = i;
        }
    }
}

void add_panels(LineChart& chart, const std::vector<const MeasuredSeries*>& series, double seconds) {
    const std::string_view unit = series.front()->unit.name;
    const bool is_temperature = unit == "degC";
    chart.add_panel(is_temperature ? "temperature" : series.front()->channel, axis_unit(unit));
    for (const MeasuredSeries* one : series) {
        const std::vector<double> t = scaled(one->time, 1.0 / seconds);
        const auto value = [&](double si) { return one->unit.value(si); };
        chart.add_curve(one->channel + ", measured", one->channel, CurveRole::points, t,
                        converted(one->measured, value));
        for (std::size_t m = 0; m < one->models.size(); ++m) {
            add_in_pieces(chart, curve_name(*one, one->models[m]), one->channel, role_of(*one, m), t,
                          converted(one->models[m].simulated, value));
        }
    }
    chart.add_panel("simulated - measured", difference_unit(unit), true);
    for (const MeasuredSeries* one : series) {
        const std::vector<double> t = scaled(one->time, 1.0 / seconds);
        for (std::size_t m = 0; m < one->models.size(); ++m) {
            std::vector<double> difference;
            for (std::size_t i = 0; i < one->measured.size(); ++i) {
                difference.push_back(one->unit.difference(one->models[m].simulated[i] - one->measured[i]));
            }
            const std::string name = curve_name(*one, one->models[m]);
            if (one->noise > 0.0 && t.size() > least_for_means) {
                const auto [middle, mean] = means(t, difference);
                add_in_pieces(chart, name, one->channel, CurveRole::faint, t, difference);
                add_in_pieces(chart, name, one->channel, role_of(*one, m), middle, mean);
            } else {
                add_in_pieces(chart, name, one->channel, role_of(*one, m), t, difference);
            }
        }
        if (one->noise > 0.0) {
            const double reach = normal_95 * one->unit.difference(one->noise);
            chart.add_band(one->channel + ", noise 95 %", one->channel, std::array{t.front(), t.back()},
                           std::array{-reach, -reach}, std::array{reach, reach});
        }
    }
    chart.add_level("", 0.0);
}

constexpr std::size_t points_on_the_page = 120'000;

}  // namespace

std::vector<RunInputs> inputs_of_runs(const input::Experiment& experiment) {
    std::vector<RunInputs> inputs;
    for (const input::MeasuredRun& run : experiment.runs) {
        inputs.push_back({.run = run.name, .inputs = &run.problem.input_signals, .laps = run.laps});
    }
    return inputs;
}

Section measured_section(const std::vector<MeasuredSeries>& series, const std::vector<RunInputs>& inputs) {
    Section section("Measured and simulated");
    std::vector<const MeasuredSeries*> all;
    double low = 1e300;
    double high = -1e300;
    std::size_t curves = 1;
    for (const MeasuredSeries& one : series) {
        if (one.time.size() > 1) {
            curves += 1 + 2 * one.models.size();
            all.push_back(&one);
            low = std::min(low, one.time.front());
            high = std::max(high, one.time.back());
        }
    }
    const std::vector<std::string> runs = distinct(all, [](const MeasuredSeries& one) { return one.run; });
    const TimeUnit unit = time_unit(high - low);
    for (const std::string& run : runs) {
        std::vector<const MeasuredSeries*> own;
        std::ranges::copy_if(all, std::back_inserter(own), [&](const MeasuredSeries* one) { return one->run == run; });
        LineChart chart("time", unit.name, low / unit.seconds, high / unit.seconds);
        chart.share_points(points_on_the_page, curves);
        for (const std::string& name :
             distinct(own, [](const MeasuredSeries& one) { return std::string(one.unit.name); })) {
            std::vector<const MeasuredSeries*> of_unit;
            std::ranges::copy_if(own, std::back_inserter(of_unit),
                                 [&](const MeasuredSeries* one) { return one->unit.name == name; });
            add_panels(chart, of_unit, unit.seconds);
        }
        const auto put_in = std::ranges::find(inputs, run, &RunInputs::run);
        const char* bands = "";
        if (put_in != inputs.end()) {
            double start = 1e300;
            double end = -1e300;
            for (const MeasuredSeries* one : own) {
                start = std::min(start, one->time.front());
                end = std::max(end, one->time.back());
            }
            add_input_panels(chart, *put_in->inputs, start, end, unit.seconds);
            if (put_in->laps.size() > 1) {
                add_lap_bands(chart, put_in->laps, unit.seconds);
                bands = " The bands are laps.";
            } else {
                const std::vector<solver::ScheduleStep> steps = solver::schedule_steps(*put_in->inputs, start, end);
                add_step_bands(chart, steps, unit.seconds);
                if (std::ranges::count(steps, false, &solver::ScheduleStep::ramp) > 1) {
                    bands = " The bands are steps of speed and load.";
                }
            }
        }
        chart.set_link("time");
        const bool several = own.front()->models.size() > 1;
        section.chart(run.empty() ? "Measured and simulated" : run,
                      fmt::format("Points are measured; {}.{}{}{}",
                                  several ? fmt::format("dashed: {}, solid: {}", own.front()->models.front().name,
                                                        own.front()->models.back().name)
                                          : "lines are simulated",
                                  own.front()->noise > 0.0
                                      ? " Of many samples the differences are faint and their means over a fortieth of "
                                        "the run are drawn over them; the band is the sensor's noise, 95 %."
                                      : "",
                                  bands, runs.size() > 1 ? " All runs zoom together." : ""),
                      chart.data());
    }
    return section;
}

}  // namespace tiretherm::post
