// SPDX-License-Identifier: BSD-3-Clause
// Curves and maps over the sides of a study's grid, or the distribution of its samples.
#include "post/study/study_chart.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "diagnosis/study/study_statistics.hpp"
#include "post/charts/study_axis.hpp"
#include "post/page/cell_chart.hpp"
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

/// Samples by classes of equal width, as many as the square root of their number: a class with its share, its colour by
/// how often it occurs.
void add_histogram(Section& section, const StudyRecord& study, const std::vector<double>& hottest) {
    const auto classes =
        static_cast<std::size_t>(std::clamp(std::ceil(std::sqrt(static_cast<double>(hottest.size()))), 4.0, 40.0));
    const double width = std::max(hottest.back() - hottest.front(), 1e-3) / static_cast<double>(classes);
    std::vector<double> samples(classes, 0.0);
    for (const double temperature : hottest) {
        const auto i = static_cast<std::size_t>((temperature - hottest.front()) / width);
        samples[std::min(i, classes - 1)] += 1.0;
    }
    const double low = hottest.front();
    const double high = low + width * static_cast<double>(classes);
    LineChart chart("hottest temperature", "°C", low, high);
    chart.add_panel("samples", "");
    std::vector<double> x;
    std::vector<double> zero;
    std::vector<double> count;
    for (std::size_t i = 0; i < classes; ++i) {
        x.insert(x.end(), {low + width * static_cast<double>(i), low + width * static_cast<double>(i + 1)});
        count.insert(count.end(), {samples[i], samples[i]});
        zero.insert(zero.end(), {0.0, 0.0});
    }
    chart.add_band("samples of each class", "samples", x, zero, count);
    chart.add_curve("samples of each class", "samples", CurveRole::line, x, count);
    if (study.critical) {
        const double critical = solver::celsius(*study.critical);
        if (critical > low && critical < high) {
            chart.add_span(level_name(study), critical, high);
        }
    }
    section.chart("Histogram of the hottest temperature",
                  fmt::format("{} samples in {} classes of {:.3g} K.{}", hottest.size(), classes, width,
                              study.critical ? " Shaded: above the critical temperature." : ""),
                  chart.data());
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
    if (study.critical) {
        const double critical = solver::celsius(*study.critical);
        if (critical > hottest.front() - margin && critical < hottest.back() + margin) {
            chart.add_span(level_name(study), critical, hottest.back() + margin);
        }
    }
    add_histogram(section, study, hottest);
    section.chart("Share of the samples that stay below a temperature", fmt::format("{} samples.", hottest.size()),
                  chart.data());
    return section;
}

}  // namespace

namespace {

/// One side of the grid as an axis, and where each of its values lies on it.
struct MapSide {
    CellAxis axis;
    std::vector<double> from;  ///< [side]
    std::vector<double> to;
};

/// Numbers at even distances at their places, all else side by side.
MapSide map_side(const StudyRecord& study, std::size_t side) {
    const StudyColumn& column = study.columns[side];
    const std::size_t n = study.sides[side];
    std::vector<double> numbers;
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t run = i * stride(study, side) * study.samples;
        numbers.push_back(column.numbers[run]);
        texts.push_back(column.texts[run]);
    }
    MapSide found{.axis = {.name = column.key, .unit = column.unit}, .from = {}, .to = {}};
    std::vector<double> sorted = numbers;
    std::ranges::sort(sorted);
    double narrowest = 1e300;
    double widest = 0.0;
    for (std::size_t i = 0; i + 1 < n; ++i) {
        narrowest = std::min(narrowest, sorted[i + 1] - sorted[i]);
        widest = std::max(widest, sorted[i + 1] - sorted[i]);
    }
    if (column.is_number && narrowest > 0.0 && widest <= 4.0 * narrowest) {
        const std::vector<double> borders = borders_between(sorted);
        found.axis.low = borders.front();
        found.axis.high = borders.back();
        for (const double number : numbers) {
            const auto at = static_cast<std::size_t>(std::ranges::lower_bound(sorted, number) - sorted.begin());
            found.from.push_back(borders[at]);
            found.to.push_back(borders[at + 1]);
        }
        return found;
    }
    found.axis.unit.clear();
    found.axis.words = texts;
    for (std::size_t i = 0; i < n; ++i) {
        found.from.push_back(static_cast<double>(i));
        found.to.push_back(static_cast<double>(i) + 1.0);
    }
    return found;
}

/// The hottest temperature over the first two sides, a map for each combination of the others.
void add_maps(Section& section, const StudyRecord& study, const std::vector<std::size_t>& sides) {
    constexpr std::size_t most_maps = 6;
    constexpr std::size_t most_cells = 20'000;
    if (sides.size() < 2 || study.sides[sides[0]] * study.sides[sides[1]] > most_cells) {
        return;
    }
    // The side with more values goes along the longer axis.
    const std::size_t x = study.sides[sides[0]] >= study.sides[sides[1]] ? sides[0] : sides[1];
    const std::size_t y = x == sides[0] ? sides[1] : sides[0];
    const MapSide across = map_side(study, x);
    const MapSide up = map_side(study, y);
    std::vector<std::pair<std::string, std::vector<MapCell>>> maps;  // by the values of the other sides
    for (std::size_t point = 0; point < study.points(); ++point) {
        std::string name;
        for (std::size_t i = 2; i < sides.size(); ++i) {
            name += fmt::format("{}{} {}", name.empty() ? "" : ", ", study.columns[sides[i]].key,
                                text_of(study, sides[i], point));
        }
        auto map = std::ranges::find(maps, name, &std::pair<std::string, std::vector<MapCell>>::first);
        if (map == maps.end()) {
            map = maps.insert(maps.end(), {name, {}});
        }
        const std::vector<double> hottest = hottest_at(study, point);
        if (hottest.empty()) {
            continue;
        }
        const double median = quantile(hottest, 0.5);
        map->second.push_back({.x_from = across.from[along(study, point, x)],
                               .x_to = across.to[along(study, point, x)],
                               .y_from = up.from[along(study, point, y)],
                               .y_to = up.to[along(study, point, y)],
                               .value = median,
                               .is_marked = study.critical && median > solver::celsius(*study.critical)});
    }
    double low = 1e300;  // one scale for all maps
    double high = -1e300;
    for (const auto& [name, cells] : maps) {
        for (const MapCell& cell : cells) {
            low = std::min(low, cell.value);
            high = std::max(high, cell.value);
        }
    }
    for (std::size_t i = 0; i < std::min(maps.size(), most_maps); ++i) {
        const auto& [name, cells] = maps[i];
        section.chart(
            "Map of the hottest temperature" + (name.empty() ? "" : ", " + name),
            fmt::format(
                "{}A cell for each {}; where there is none the run failed.{}",
                study.samples > 1 ? "Median of the samples. " : "", study.samples > 1 ? "point of the grid" : "run",
                study.critical ? fmt::format(" Framed: above {:.5g} °C.", solver::celsius(*study.critical)) : ""),
            cell_chart(across.axis, up.axis,
                       {.name = "hottest temperature",
                        .unit = "°C",
                        .low = low,
                        .high = high,
                        .marked = "above the critical temperature"},
                       cells));
    }
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
    add_maps(section, study, sides);
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
