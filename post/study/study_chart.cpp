// SPDX-License-Identifier: BSD-3-Clause
// Curves over the sides of a study's grid, or the distribution of its samples.
#include "post/study/study_chart.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "diagnosis/study/study_statistics.hpp"
#include "physics/celsius.hpp"
#include "post/page/charts.hpp"
#include "post/study/study_axis.hpp"

namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered here

namespace {

/// Index of a point of the grid along a side.
std::size_t along(const StudyRecord& study, std::size_t point, std::size_t side) {
    return point / stride(study, side) % study.sides[side];
}

const std::string& text_of(const StudyRecord& study, std::size_t side, std::size_t point) {
    return study.columns[side].texts[point * study.samples];
}

struct StudyCurve {
    std::string name;
    /// x, median, low, high of each point
    std::vector<std::array<double, 4>> points;
};

/// The values of one side against another, at the first value of all further sides.
std::vector<StudyCurve> curves_of(const StudyRecord& study, std::size_t x, const StudyAxis& axis,
                                  const std::vector<std::size_t>& others) {
    std::vector<StudyCurve> curves;
    for (std::size_t point = 0; point < study.points(); ++point) {
        const bool first = std::ranges::all_of(others.begin() + (others.empty() ? 0 : 1), others.end(),
                                               [&](std::size_t side) { return along(study, point, side) == 0; });
        const std::vector<double> hottest = hottest_at(study, point);
        if (!first || hottest.empty()) {
            continue;
        }
        const std::string name = others.empty() ? std::string("hottest temperature") : text_of(study, others[0], point);
        auto curve = std::ranges::find(curves, name, &StudyCurve::name);
        if (curve == curves.end()) {
            curve = curves.insert(curves.end(), StudyCurve{name, {}});
        }
        curve->points.push_back({axis.at[along(study, point, x)], quantile(hottest, 0.5), quantile(hottest, 0.05),
                                 quantile(hottest, 0.95)});
    }
    for (StudyCurve& curve : curves) {
        std::ranges::sort(curve.points, {}, [](const auto& point) { return point[0]; });
    }
    return curves;
}

std::vector<double> column(const StudyCurve& curve, std::size_t index) {
    std::vector<double> values;
    for (const auto& point : curve.points) {
        values.push_back(point[index]);
    }
    return values;
}

std::string level_name(const StudyRecord& study) { return fmt::format("critical {:.5g} °C", celsius(*study.critical)); }

/// Equal steps from a round temperature on. degC
struct Bins {
    double from = 0.0;
    double step = 1.0;
    std::vector<double> count;
};

/// Steps of D. Freedman and P. Diaconis (1981), 2 IQR / n^(1/3), rounded to those of an axis.   @param sorted [samples] degC
Bins bins_of(const std::vector<double>& sorted) {
    const double spread = std::max(sorted.back() - sorted.front(), 1e-3);
    const double wanted =
        2.0 * (quantile(sorted, 0.75) - quantile(sorted, 0.25)) / std::cbrt(static_cast<double>(sorted.size()));
    const int about = wanted > 0.0 ? std::clamp(static_cast<int>(spread / wanted), 4, 40) : 4;
    const double step = round_step(spread / about);
    Bins bins{.from = std::floor(sorted.front() / step) * step, .step = step, .count = {}};
    for (const double value : sorted) {
        const auto i = static_cast<std::size_t>((value - bins.from) / step);
        bins.count.resize(std::max(bins.count.size(), i + 1));
        bins.count[i] += 1.0;
    }
    return bins;
}

/// A line from bottom to top of a panel.
void add_upright(LineChart& chart, const std::string& name, double x, double top) {
    chart.add_curve(name, name, CurveRole::dashed, std::array{x, x}, std::array{0.0, top});
}

ReportSection distribution(const StudyRecord& study) {
    ReportSection section("Distribution");
    const std::vector<double> hottest = hottest_at(study, 0);  // coldest first
    if (hottest.size() < 2) {
        return section;
    }
    std::vector<double> share;
    for (std::size_t i = 0; i < hottest.size(); ++i) {
        share.push_back(100.0 * (static_cast<double>(i) + 0.5) / static_cast<double>(hottest.size()));
    }
    const Bins bins = bins_of(hottest);
    std::vector<double> edges;
    std::vector<double> counts;
    for (std::size_t i = 0; i < bins.count.size(); ++i) {
        const double from = bins.from + static_cast<double>(i) * bins.step;
        edges.insert(edges.end(), {from, from + bins.step});
        counts.insert(counts.end(), {bins.count[i], bins.count[i]});
    }
    double low = edges.front();
    double high = edges.back();
    if (study.critical) {
        low = std::min(low, celsius(*study.critical) - bins.step);
        high = std::max(high, celsius(*study.critical) + bins.step);
    }
    LineChart chart("hottest temperature", "°C", low, high);
    chart.add_panel("samples", "");
    chart.add_band("samples", "samples", edges, std::vector<double>(edges.size(), 0.0), counts);
    if (study.critical) {
        add_upright(chart, level_name(study), celsius(*study.critical), *std::ranges::max_element(counts));
    }
    chart.add_panel("share that stays below", "%");
    chart.add_curve("share of the samples", "samples", CurveRole::line, hottest, share);
    if (study.critical) {
        add_upright(chart, level_name(study), celsius(*study.critical), 100.0);
    }
    std::string caption =
        fmt::format("{} samples: half lie below {:.1f} °C, nine tenths from {:.1f} to {:.1f} °C.", hottest.size(),
                    quantile(hottest, 0.5), quantile(hottest, 0.05), quantile(hottest, 0.95));
    if (study.critical) {
        const Chance c = passes_critical(study, 0);
        caption += fmt::format(" {} of {} pass {:.6g} °C: {:.1f} %, 95 % interval {:.1f} to {:.1f} %.", c.times, c.of,
                               celsius(*study.critical), 100.0 * c.share, 100.0 * c.low, 100.0 * c.high);
    }
    section.chart("Distribution of the hottest temperature", caption, chart.data());
    return section;
}

}  // namespace

ReportSection study_chart_section(const StudyRecord& study) {
    const std::vector<std::size_t> sides = wide_sides(study);
    if (sides.empty()) {
        return distribution(study);
    }
    ReportSection section("Hottest temperature");
    // The side with the most values is the axis: fewer curves say the same.
    const std::size_t x = *std::ranges::max_element(sides, {}, [&](std::size_t side) { return study.sides[side]; });
    std::vector<std::size_t> others = sides;
    std::erase(others, x);
    const StudyAxis axis = study_axis(study, x);
    LineChart chart(axis.name, axis_unit(axis.unit), axis.low, axis.high);
    if (!axis.is_number) {
        chart.set_labels(axis.labels_in_order());
    }
    chart.add_panel("hottest temperature", "°C");
    for (const StudyCurve& curve : curves_of(study, x, axis, others)) {
        if (study.samples > 1 && axis.is_number) {
            chart.add_band(curve.name, curve.name, column(curve, 0), column(curve, 2), column(curve, 3));
        } else if (study.samples > 1) {
            chart.add_ranges(curve.name, curve.name, column(curve, 0), column(curve, 2), column(curve, 3));
        }
        if (axis.is_number) {
            chart.add_curve(curve.name, curve.name, CurveRole::line, column(curve, 0), column(curve, 1));
        }
        chart.add_curve(curve.name, curve.name, CurveRole::points, column(curve, 0), column(curve, 1));
    }
    if (study.critical) {
        chart.add_level(level_name(study), celsius(*study.critical));
    }
    std::string caption;
    if (!others.empty()) {
        caption += fmt::format("A curve for each value of {}. ", study.columns[others[0]].key);
    }
    for (std::size_t i = 1; i < others.size(); ++i) {
        caption += fmt::format("{} is at its first value. ", study.columns[others[i]].key);
    }
    if (study.samples > 1) {
        caption += fmt::format("Median of {} samples; nine tenths of them lie in the band.", study.samples);
    }
    section.chart("Hottest temperature over the run", caption, chart.data());
    if (!others.empty()) {
        add_study_maps(section, study);
    }
    return section;
}

}  // namespace tiretherm::post
