#include "input/model/law.hpp"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "input/tables/columns.hpp"
#include "input/text/wanted.hpp"

namespace tiretherm::input {

namespace {

using physics::Curve;

/// A slope or curvature may have either sign and needs no bounds: the law's values are judged later.
Wanted derivative(const std::string& unit) { return {.unit = unit}; }

std::optional<Curve> about_point(Section& law, const Wanted& value) {
    const std::string slope_unit = std::string(value.unit) + " K-1";
    const std::string curvature_unit = std::string(value.unit) + " K-2";
    const auto a = law.quantity("value", value, Need::required);
    const auto b = law.quantity("slope", derivative(slope_unit));
    const auto c = law.quantity("curvature", derivative(curvature_unit));
    // Without a slope there is nothing that a temperature could be the origin of.
    const bool varies = law.has("slope") || law.has("curvature");
    const auto origin = law.quantity("at", wanted::temperature, varies ? Need::required : Need::optional);
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

std::optional<Curve> read_points(Section& law, const Wanted& value) {
    const Node* points = law.value("through");
    constexpr std::string_view remedy = "write through = [[\"20 degC\", \"...\"], [\"90 degC\", \"...\"]]";
    if (points->kind != Node::Kind::array || points->items.size() < 2 || points->items.size() > 3) {
        law.mistake("through", "a law goes through two points (a line) or three (a parabola)", std::string(remedy));
        return std::nullopt;
    }
    std::vector<double> x;
    std::vector<double> y;
    for (const Node& point : points->items) {
        if (point.kind != Node::Kind::array || point.items.size() != 2 || point.items[0].kind != Node::Kind::text ||
            point.items[1].kind != Node::Kind::text) {
            law.mistakes().add(point.place, "a point is a temperature and a value, each with its unit",
                               std::string(remedy));
            continue;
        }
        const std::array judged{quantity(point.items[0].text, wanted::temperature, "temperature"),
                                quantity(point.items[1].text, value, "value")};
        for (std::size_t i = 0; i < 2; ++i) {
            if (judged[i].fault) {
                law.mistakes().add(point.items[i].place, *judged[i].fault);
            }
        }
        for (const double known : x) {
            if (!judged[0].fault && known == judged[0].value) {
                law.mistakes().add(point.items[0].place, "two points have the same temperature", "move or remove one");
                return std::nullopt;
            }
        }
        if (!judged[0].fault && !judged[1].fault) {
            x.push_back(judged[0].value);
            y.push_back(judged[1].value);
        }
    }
    return x.size() == points->items.size() ? std::optional(through_points(x, y)) : std::nullopt;
}

std::optional<Curve> read_table(Section& section, const Wanted& variable, const Wanted& value) {
    const std::vector<Column> columns = read_columns(section);
    if (columns.empty()) {
        return std::nullopt;
    }
    if (columns.size() != 2) {
        section.mistake("columns", fmt::format("a law has two columns, here are {}", columns.size()));
        return std::nullopt;
    }
    const std::vector<double> x = read_numbers(columns[0], variable, section.mistakes());
    const std::vector<double> y = read_numbers(columns[1], value, section.mistakes());
    if (x.empty() || y.empty()) {
        return std::nullopt;
    }
    for (std::size_t i = 1; i < x.size(); ++i) {
        if (x[i] <= x[i - 1]) {
            section.mistakes().add(columns[0].cells[i]->place,
                                   fmt::format("{} must ascend from row to row", columns[0].heading.name),
                                   "sort the rows");
            return std::nullopt;
        }
    }
    return Curve::table(x, y);
}

}  // namespace

std::optional<Curve> read_law(Section& section, std::string_view key, const Wanted& value, Need need) {
    const Node* node = section.value(key, Need::optional);
    if (node == nullptr || node->kind != Node::Kind::table) {
        const auto constant = section.quantity(key, value, need);
        return constant ? std::optional(Curve::constant(*constant)) : std::nullopt;
    }
    Section law = section.section(key);
    if (law.has("through")) {
        return read_points(law, value);
    }
    if (law.has("columns") || law.has("rows")) {
        return read_table(law, wanted::temperature, value);
    }
    return about_point(law, value);
}

std::optional<Curve> read_curve(Section& section, std::string_view key, const Wanted& variable, const Wanted& value) {
    Section curve = section.section(key);
    return curve.exists() ? read_table(curve, variable, value) : std::nullopt;
}

}  // namespace tiretherm::input
