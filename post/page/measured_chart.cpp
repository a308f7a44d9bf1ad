// SPDX-License-Identifier: BSD-3-Clause
// Takes points, models and their differences as series over time, a chart for each run.
#include "post/page/measured_chart.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "diagnosis/compare/comparison_statistics.hpp"
#include "post/page/time_chart.hpp"

namespace tiretherm::post {

namespace {

std::string curve_name(const MeasuredSeries& series, const MeasuredSeries::Model& model) {
    return series.models.size() == 1 && model.name == "simulated" ? series.channel : series.channel + ", " + model.name;
}

constexpr double parts = 40.0;  ///< of a run, over which means are taken
constexpr std::size_t least_for_means = 120;

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
void add_in_pieces(std::vector<TimeCurve>& curves, const std::string& name, CurveRole role,
                   const std::vector<double>& time, const std::vector<double>& value) {
    std::size_t first = 0;
    const auto piece = [&](const std::vector<double>& all, std::size_t end) {
        return std::vector(all.begin() + static_cast<std::ptrdiff_t>(first),
                           all.begin() + static_cast<std::ptrdiff_t>(end));
    };
    for (std::size_t i = 1; i <= time.size(); ++i) {
        if (i == time.size() || diagnosis::is_gap(time, i)) {
            curves.push_back({name, role, piece(time, i), piece(value, i)});
            first = i;
        }
    }
}

TimeSeries time_series_of(const MeasuredSeries& one) {
    TimeSeries series{.channel = one.channel, .unit = one.unit, .noise = one.noise};
    series.curves.push_back({one.channel + ", measured", CurveRole::points, one.time, one.measured});
    for (std::size_t m = 0; m < one.models.size(); ++m) {
        const std::string name = curve_name(one, one.models[m]);
        const CurveRole role = m + 1 < one.models.size() ? CurveRole::dashed : CurveRole::line;
        add_in_pieces(series.curves, name, role, one.time, one.models[m].simulated);
        std::vector<double> difference = one.models[m].simulated;
        std::ranges::transform(difference, one.measured, difference.begin(), std::minus<>());
        const bool has_means = one.noise > 0.0 && one.time.size() > least_for_means;
        add_in_pieces(series.differences, name, has_means ? CurveRole::faint : role, one.time, difference);
        if (has_means) {
            const auto [middle, mean] = means(one.time, difference);
            add_in_pieces(series.differences, name, role, middle, mean);
        }
    }
    return series;
}

std::string caption_of(const MeasuredSeries& first, bool is_alone) {
    return fmt::format(
        "Points are measured; {}.{}{}",
        first.models.size() > 1
            ? fmt::format("dashed: {}, solid: {}", first.models.front().name, first.models.back().name)
            : "lines are simulated",
        first.noise > 0.0 ? " Of many samples the differences are faint and their means over a fortieth of the run are "
                            "drawn over them; the band is the sensor's noise, 95 %."
                          : "",
        is_alone ? "" : " All runs zoom together.");
}

}  // namespace

std::vector<RunInputs> inputs_of_runs(const input::Experiment& experiment) {
    std::vector<RunInputs> inputs;
    for (const input::MeasuredRun& run : experiment.runs) {
        inputs.push_back({.run = run.name, .inputs = &run.problem.input_signals, .laps = run.laps});
    }
    return inputs;
}

ReportSection measured_section(const std::vector<MeasuredSeries>& series, const std::vector<RunInputs>& inputs) {
    ReportSection section("Measured and simulated");
    struct Run {
        const MeasuredSeries* first;
        TimeChart chart;
    };
    std::vector<Run> runs;
    double low = 1e300;
    double high = -1e300;
    std::size_t curves = 1;
    for (const MeasuredSeries& one : series) {
        if (one.time.size() < 2) {
            continue;
        }
        auto run = std::ranges::find(runs, one.run, [](const Run& known) { return known.first->run; });
        if (run == runs.end()) {
            run = runs.insert(runs.end(), {.first = &one, .chart = {}});
        }
        run->chart.series.push_back(time_series_of(one));
        curves += 1 + 2 * one.models.size();
        low = std::min(low, one.time.front());
        high = std::max(high, one.time.back());
    }
    for (auto& [first, chart] : runs) {
        chart.axis = {low, high};
        chart.curves_of_page = curves;
        if (const auto put_in = std::ranges::find(inputs, first->run, &RunInputs::run); put_in != inputs.end()) {
            chart.inputs = put_in->inputs;
            chart.laps = put_in->laps;
        }
        add_time_chart(section, first->run.empty() ? "Measured and simulated" : first->run,
                       caption_of(*first, runs.size() == 1), std::move(chart));
    }
    return section;
}

}  // namespace tiretherm::post
