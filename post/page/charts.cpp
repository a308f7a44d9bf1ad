// SPDX-License-Identifier: BSD-3-Clause
// Thins and rounds what a chart shows.
#include "post/page/charts.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

namespace tiretherm::post {

namespace {

/// Indices of the points of a curve that are shown: all, or the lowest and the highest of each piece.
std::vector<std::size_t> shown_points(std::span<const double> y, std::size_t most_points) {
    std::vector<std::size_t> kept;
    if (y.size() <= most_points) {
        for (std::size_t i = 0; i < y.size(); ++i) {
            kept.push_back(i);
        }
        return kept;
    }
    const std::size_t pieces = most_points / 2;
    for (std::size_t piece = 0; piece < pieces; ++piece) {
        const std::size_t from = piece * y.size() / pieces;
        const std::size_t to = (piece + 1) * y.size() / pieces;
        std::size_t low = from;
        std::size_t high = from;
        for (std::size_t i = from; i < to; ++i) {
            low = !(y[i] >= y[low]) && !std::isnan(y[i]) ? i : low;
            high = !(y[i] <= y[high]) && !std::isnan(y[i]) ? i : high;
        }
        const std::size_t a = std::min(low, high);
        const std::size_t b = std::max(low, high);
        kept.push_back(a);
        if (b != a) {
            kept.push_back(b);
        }
    }
    kept.front() = 0;
    if (kept.back() != y.size() - 1) {
        kept.push_back(y.size() - 1);
    }
    return kept;
}

Value number(double value) { return std::isfinite(value) ? Value(rounded(value)) : Value(); }

const char* word(CurveRole role) {
    switch (role) {
        case CurveRole::dashed:
            return "dashed";
        case CurveRole::dotted:
            return "dotted";
        case CurveRole::faint:
            return "faint";
        case CurveRole::points:
            return "points";
        case CurveRole::line:
            break;
    }
    return "line";
}

}  // namespace

TimeUnit time_unit(double span) {
    return span > 3.0 * 3600.0 ? TimeUnit{"h", 3600.0} : span > 600.0 ? TimeUnit{"min", 60.0} : TimeUnit{"s", 1.0};
}

std::string axis_unit(std::string_view unit) { return unit == "degC" ? "°C" : std::string(unit); }

double rounded(double value, int digits) {
    std::array<char, 64> room;
    const char* const end =
        std::to_chars(room.data(), room.data() + room.size(), value, std::chars_format::general, digits).ptr;
    std::from_chars(room.data(), end, value);
    return value;
}

double round_step(double about) {
    const double power = std::pow(10.0, std::floor(std::log10(about)));
    const double mantissa = about / power;
    for (const double round : {1.0, 2.0, 2.5, 5.0}) {
        if (mantissa <= round) {
            return round * power;
        }
    }
    return 10.0 * power;
}

LineChart::LineChart(std::string x, std::string unit, double low, double high)
    : axis_{{"name", std::move(x)}, {"unit", std::move(unit)}, {"min", number(low)}, {"max", number(high)}} {}

void LineChart::set_labels(const std::vector<std::string>& labels, const std::vector<std::string>& notes) {
    axis_.set({{"labels", Value(labels)}, {"notes", Value(notes)}});
}

void LineChart::add_panel(std::string name, std::string unit, bool is_short) {
    panels_.push_back({.name = std::move(name), .unit = std::move(unit), .is_short = is_short});
}

void LineChart::add_curve(const std::string& name, const std::string& group, CurveRole role, std::span<const double> x,
                          std::span<const double> y) {
    assert(!panels_.empty() && x.size() == y.size());
    Value::List points;
    for (const std::size_t i : shown_points(y, most_points_)) {
        points.emplace_back(Value::List{number(x[i]), number(y[i])});
    }
    panels_.back().series.emplace_back(
        Value{{"name", name}, {"group", group}, {"role", word(role)}, {"points", std::move(points)}});
}

void LineChart::add_areas(const std::string& role, const std::string& name, const std::string& group,
                          std::span<const double> x, std::span<const double> low, std::span<const double> high) {
    assert(!panels_.empty() && x.size() == low.size() && x.size() == high.size());
    Value::List points;
    for (std::size_t i = 0; i < x.size(); ++i) {
        points.emplace_back(Value::List{number(x[i]), number(low[i]), number(high[i])});
    }
    panels_.back().series.emplace_back(
        Value{{"name", name}, {"group", group}, {"role", role}, {"points", std::move(points)}});
}

void LineChart::add_ranges(const std::string& name, const std::string& group, std::span<const double> x,
                           std::span<const double> low, std::span<const double> high) {
    add_areas("range", name, group, x, low, high);
}

void LineChart::add_band(const std::string& name, const std::string& group, std::span<const double> x,
                         std::span<const double> low, std::span<const double> high) {
    add_areas("band", name, group, x, low, high);
}

void LineChart::add_level(const std::string& name, double value) {
    assert(!panels_.empty());
    panels_.back().levels.emplace_back(Value{{"name", name}, {"value", number(value)}});
}

void LineChart::add_mark(const std::string& name, const std::string& group, double x, double y) {
    assert(!panels_.empty());
    panels_.back().marks.emplace_back(Value{{"name", name}, {"group", group}, {"x", number(x)}, {"y", number(y)}});
}

void LineChart::add_span(const std::string& name, double from, double to) {
    spans_.emplace_back(Value{{"name", name}, {"from", number(from)}, {"to", number(to)}});
}

Value LineChart::data() const {
    Value::List panels;
    for (const Panel& panel : panels_) {
        panels.emplace_back(Value{{"name", panel.name},
                                  {"unit", panel.unit},
                                  {"short", panel.is_short},
                                  {"series", panel.series},
                                  {"levels", panel.levels},
                                  {"marks", panel.marks}});
    }
    return {{"kind", "lines"}, {"x", axis_}, {"panels", panels}, {"spans", spans_}, {"link", text_or_null(link_)}};
}

namespace {

Value::List named_values(const std::vector<Bar>& levels) {
    Value::List list;
    for (const Bar& level : levels) {
        list.emplace_back(Value{{"name", level.name}, {"value", number(level.value)}});
    }
    return list;
}

}  // namespace

Value bar_chart(std::string_view what, std::string_view unit, const std::vector<Bar>& bars,
                const std::vector<Bar>& levels) {
    Value::List items;
    for (const Bar& bar : bars) {
        Value item{{"name", bar.name}, {"value", number(bar.value)}};
        if (std::isfinite(bar.low) && std::isfinite(bar.high)) {
            item.set({{"low", number(bar.low)}, {"high", number(bar.high)}});
        }
        if (bar.is_marked) {
            item.set("marked", true);
        }
        items.push_back(std::move(item));
    }
    return {{"kind", "bars"},
            {"x", Value{{"name", what}, {"unit", unit}}},
            {"items", items},
            {"levels", named_values(levels)}};
}

Value grouped_bar_chart(std::string_view what, std::string_view unit, const std::vector<std::string>& series,
                        const std::vector<BarGroup>& groups, const std::vector<Bar>& levels) {
    Value::List items;
    for (const BarGroup& group : groups) {
        assert(group.values.size() == series.size());
        Value::List values;
        for (const double value : group.values) {
            values.push_back(number(value));
        }
        items.emplace_back(Value{{"name", group.name}, {"values", std::move(values)}});
    }
    return {{"kind", "bars"},
            {"x", Value{{"name", what}, {"unit", unit}}},
            {"series", series},
            {"items", items},
            {"levels", named_values(levels)}};
}

}  // namespace tiretherm::post
