// SPDX-License-Identifier: BSD-3-Clause
// Curves over the sides of a study's grid, or the distribution of its samples.
#include "post/study/study_chart.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "diagnosis/study/study_statistics.hpp"
#include "post/charts/study_axis.hpp"
#include "post/page/charts.hpp"
#include "solver/celsius.hpp"

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

struct Curve {
    std::string name;
    /// x, median, low, high of each point
    std::vector<std::array<double, 4>> points;
};

/// The values of one side against another, at the first value of all further sides.
std::vector<Curve> curves_of(const StudyRecord& study, std::size_t x, const std::vector<std::size_t>& others) {
    std::vector<Curve> curves;
    for (std::size_t point = 0; point < study.points(); ++point) {
        const bool first = std::ranges::all_of(others.begin() + (others.empty() ? 0 : 1), others.end(),
                                               [&](std::size_t side) { return along(study, point, side) == 0; });
        const std::vector<double> hottest = hottest_at(study, point);
        if (!first || hottest.empty()) {
            continue;
        }
        const std::string name = others.empty() ? std::string("hottest temperature") : text_of(study, others[0], point);
        auto curve = std::ranges::find(curves, name, &Curve::name);
        if (curve == curves.end()) {
            curve = curves.insert(curves.end(), Curve{name, {}});
        }
        curve->points.push_back({study.columns[x].numbers[point * study.samples], quantile(hottest, 0.5),
                                 quantile(hottest, 0.05), quantile(hottest, 0.95)});
    }
    for (Curve& curve : curves) {
        std::ranges::sort(curve.points, {}, [](const auto& point) { return point[0]; });
    }
    return curves;
}

std::vector<double> column(const Curve& curve, std::size_t index) {
    std::vector<double> values;
    for (const auto& point : curve.points) {
        values.push_back(point[index]);
    }
    return values;
}

std::string level_name(const StudyRecord& study) {
    return fmt::format("critical {:.5g} °C", solver::celsius(*study.critical));
}

Section distribution(const StudyRecord& study) {
    Section section("Distribution");
    const std::vector<double> hottest = hottest_at(study, 0);  // coldest first
    if (hottest.size() < 2) {
        return section;
    }
    std::vector<double> share;
    for (std::size_t i = 0; i < hottest.size(); ++i) {
        share.push_back(100.0 * (static_cast<double>(i) + 0.5) / static_cast<double>(hottest.size()));
    }
    const double margin = 0.02 * std::max(hottest.back() - hottest.front(), 1e-3);
    LineChart chart("hottest temperature", "°C", hottest.front() - margin, hottest.back() + margin);
    chart.add_panel("runs that stay below", "%");
    chart.add_curve("share of runs", "", CurveRole::line, hottest, share);
    section.chart("Distribution of the hottest temperature", fmt::format("{} samples.", hottest.size()), chart.data());
    return section;
}

}  // namespace

Section study_chart_section(const StudyRecord& study) {
    const std::vector<std::size_t> sides = wide_sides(study);
    if (sides.empty()) {
        return distribution(study);
    }
    Section section("Hottest temperature");
    // The side with the most values is the axis: fewer curves say the same.
    const std::size_t x = *std::ranges::max_element(sides, {}, [&](std::size_t side) { return study.sides[side]; });
    std::vector<std::size_t> others = sides;
    std::erase(others, x);
    const std::vector<double>& numbers = study.columns[x].numbers;
    if (std::ranges::any_of(numbers, [](double value) { return !std::isfinite(value); })) {
        return section;
    }
    const auto [low, high] = std::ranges::minmax(numbers);
    LineChart chart(study.columns[x].key, study.columns[x].unit, low, high);
    chart.add_panel("hottest temperature", "°C");
    for (const Curve& curve : curves_of(study, x, others)) {
        if (study.samples > 1) {
            chart.add_band(curve.name, curve.name, column(curve, 0), column(curve, 2), column(curve, 3));
        }
        chart.add_curve(curve.name, curve.name, CurveRole::line, column(curve, 0), column(curve, 1));
    }
    if (study.critical) {
        chart.add_level(level_name(study), solver::celsius(*study.critical));
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
    return section;
}

}  // namespace tiretherm::post
