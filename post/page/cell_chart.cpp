// SPDX-License-Identifier: BSD-3-Clause
// Rounds the cells of a map and finds the ends of its colour scale.
#include "post/page/cell_chart.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "post/page/charts.hpp"

namespace tiretherm::post {

namespace {

Value axis_data(const CellAxis& axis) {
    Value data{{"name", axis.name}, {"unit", axis.unit}};
    if (axis.words.empty()) {
        data.set({{"min", rounded(axis.low)}, {"max", rounded(axis.high)}});
    } else {
        data.set("words", axis.words);
    }
    return data;
}

}  // namespace

Value cell_chart(const CellAxis& x, const CellAxis& y, const CellScale& scale, const std::vector<MapCell>& cells) {
    Value::List list;
    double low = 1e300;
    double high = -1e300;
    for (const MapCell& cell : cells) {
        if (!std::isfinite(cell.value)) {
            continue;
        }
        low = std::min(low, cell.value);
        high = std::max(high, cell.value);
        Value::List numbers{rounded(cell.x_from), rounded(cell.x_to), rounded(cell.y_from), rounded(cell.y_to),
                            rounded(cell.value)};
        Value one{{"at", std::move(numbers)}};
        if (cell.is_marked) {
            one.set("marked", true);
        }
        if (!cell.text.empty()) {
            one.set("text", cell.text);
        }
        list.push_back(std::move(one));
    }
    if (scale.is_signed) {
        high = scale.reach > 0.0 ? scale.reach : std::max(std::abs(low), std::abs(high));
        low = -high;
    } else if (std::isfinite(scale.low) && std::isfinite(scale.high)) {
        low = scale.low;
        high = scale.high;
    }
    return {{"kind", "cells"},         {"x", axis_data(x)},     {"y", axis_data(y)},
            {"name", scale.name},      {"unit", scale.unit},    {"signed", scale.is_signed},
            {"low", rounded(low)},     {"high", rounded(high)}, {"marked", text_or_null(scale.marked)},
            {"cells", std::move(list)}};
}

std::vector<double> borders_between(const std::vector<double>& at) {
    assert(!at.empty());
    if (at.size() == 1) {
        return {at.front() - 0.5, at.front() + 0.5};
    }
    std::vector<double> borders{1.5 * at[0] - 0.5 * at[1]};
    for (std::size_t i = 0; i + 1 < at.size(); ++i) {
        borders.push_back(0.5 * (at[i] + at[i + 1]));
    }
    borders.push_back(1.5 * at.back() - 0.5 * at[at.size() - 2]);
    return borders;
}

}  // namespace tiretherm::post
