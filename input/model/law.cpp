// SPDX-License-Identifier: BSD-3-Clause
// Reads the four forms of a law into curves: constant, line or parabola about a point or through points (divided
// differences), both with a range beyond which they are held, and table.

#include "input/model/law.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "input/tables/columns.hpp"
#include "input/text/quantity_specs.hpp"

namespace tiretherm::input {

namespace {

using physics::Curve;

/// A slope or curvature may have either sign and needs no bounds: the law's values are checked later.
QuantitySpec derivative(const std::string& unit) { return {.unit = unit}; }

std::optional<Curve> about_point(TomlTable& law, const QuantitySpec& value) {
    const std::string slope_unit = std::string(value.unit) + " K-1";
    const std::string curvature_unit = std::string(value.unit) + " K-2";
    const auto a = law.quantity("value", value, Need::required);
    const auto b = law.quantity("slope", derivative(slope_unit));
    const auto c = law.quantity("curvature", derivative(curvature_unit));
    // Without a slope there is nothing that a temperature could be the origin of.
    const bool varies = law.has("slope") || law.has("curvature");
    const auto origin = law.quantity("at", varies ? Need::required : Need::optional);
    if (!a || (varies && !origin)) {
        return std::nullopt;
    }
    return varies ? Curve::quadratic_about(*origin, *a, b.value_or(0.0), c.value_or(0.0)) : Curve::constant(*a);
}

/// The line or parabola through points (x, y), by Newton's divided differences about the first.
Curve through_points(const std::vector<double>& x, const std::vector<double>& y) {
    const double first = (y[1] - y[0]) / (x[1] - x[0]);
    if (x.size() == 2) {
        return Curve::quadratic_about(x[0], y[0], first, 0.0);
    }
    const double second = ((y[2] - y[1]) / (x[2] - x[1]) - first) / (x[2] - x[0]);
    return Curve::quadratic_about(x[0], y[0], first + second * (x[0] - x[1]), second);
}

std::optional<Curve> read_points(TomlTable& law, const QuantitySpec& value) {
    const TomlValue* points = law.value("through");
    constexpr std::string_view remedy = "write through = [[\"20 degC\", \"...\"], [\"90 degC\", \"...\"]]";
    if (points->kind != TomlValue::Kind::array || points->items.size() < 2 || points->items.size() > 3) {
        return law.add_error("through", "a law goes through two points (a line) or three (a parabola)",
                             std::string(remedy));
    }
    std::vector<double> x;
    std::vector<double> y;
    for (const TomlValue& point : points->items) {
        if (point.kind != TomlValue::Kind::array || point.items.size() != 2 ||
            point.items[0].kind != TomlValue::Kind::text || point.items[1].kind != TomlValue::Kind::text) {
            law.errors().add(point.place, "a point is a temperature and a value, each with its unit",
                             std::string(remedy));
            continue;
        }
        const auto read = [&](const TomlValue& item, const QuantitySpec& spec, std::string_view name) {
            return read_quantity({item.text, item.place}, spec, name, law.errors());
        };
        const std::optional<double> at = read(point.items[0], quantity_specs::temperature, "temperature");
        const std::optional<double> of = read(point.items[1], value, "value");
        if (at && std::ranges::find(x, *at) != x.end()) {
            return law.errors().add(point.items[0].place, "two points have the same temperature", "move or remove one");
        }
        if (at && of) {
            x.push_back(*at);
            y.push_back(*of);
        }
    }
    return x.size() == points->items.size() ? std::optional(through_points(x, y)) : std::nullopt;
}

/// The key `range` of a law: two temperatures, the lower one first; beyond them the law is held.
std::optional<Curve> read_range(TomlTable& law, std::optional<Curve> curve) {
    const auto ends = law.range("range", quantity_specs::temperature);
    if (ends && (*ends)[0] == (*ends)[1]) {
        law.add_error("range", "the range ends where it begins");
        return curve;
    }
    return curve && ends ? std::optional(curve->within((*ends)[0], (*ends)[1])) : curve;
}

std::optional<Curve> read_table(TomlTable& table, const QuantitySpec& variable, const QuantitySpec& value) {
    const std::vector<Column> columns = read_columns(table);
    if (columns.empty()) {
        return std::nullopt;
    }
    if (columns.size() != 2) {
        return table.add_error("columns", fmt::format("a law has two columns, here are {}", columns.size()));
    }
    const std::vector<double> x = read_numbers(columns[0], variable, table.errors());
    const std::vector<double> y = read_numbers(columns[1], value, table.errors());
    if (x.empty() || y.empty()) {
        return std::nullopt;
    }
    for (std::size_t i = 1; i < x.size(); ++i) {
        if (x[i] <= x[i - 1]) {
            return table.errors().add(columns[0].cells[i]->place,
                                      fmt::format("{} must ascend from row to row", columns[0].heading.name),
                                      "sort the rows");
        }
    }
    return Curve::table(x, y);
}

}  // namespace

std::optional<Curve> read_law(TomlTable& table, std::string_view key, const QuantitySpec& value, Need need) {
    const TomlValue* node = table.value(key, Need::optional);
    if (node == nullptr || node->kind != TomlValue::Kind::table) {
        const auto constant = table.quantity(key, value, need);
        return constant ? std::optional(Curve::constant(*constant)) : std::nullopt;
    }
    TomlTable law = table.subtable(key);
    if (law.has("through")) {
        std::optional<Curve> curve = read_points(law, value);
        return read_range(law, std::move(curve));
    }
    if (law.has("columns") || law.has("rows")) {
        if (law.has("range")) {
            law.declare_keys({"range"});
            law.add_error("range", "a table needs no range: it is held beyond its ends", "remove range");
        }
        return read_table(law, quantity_specs::temperature, value);
    }
    std::optional<Curve> curve = about_point(law, value);
    return read_range(law, std::move(curve));
}

std::optional<Curve> read_curve(TomlTable& table, std::string_view key, const QuantitySpec& variable,
                                const QuantitySpec& value) {
    TomlTable curve = table.subtable(key);
    return curve.exists() ? read_table(curve, variable, value) : std::nullopt;
}

}  // namespace tiretherm::input
