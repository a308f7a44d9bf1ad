// SPDX-License-Identifier: BSD-3-Clause
// Numbers side by side, in the order of the table; the models of a number stand a little apart.
#include "post/validation/validation_charts.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "post/page/charts.hpp"
#include "post/report/number_text.hpp"

namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered here

namespace {

constexpr double apart = 0.16;  ///< models of one number, in steps of the axis

/// Ranges or points over the axis of numbers.
struct Marks {
    std::vector<double> x;
    std::vector<double> low;
    std::vector<double> high;

    void add(double at, double from, double to) {
        x.push_back(at);
        low.push_back(from);
        high.push_back(to);
    }
};

double place_of(std::size_t number, std::size_t model, std::size_t models) {
    return static_cast<double>(number) +
           apart * (static_cast<double>(model + 1) - 0.5 * static_cast<double>(models - 1));
}

std::string quantity_of(const std::string& unit) {
    return unit == "degC" ? "temperature"
           : unit == "K"  ? "temperature difference"
           : unit == "1"  ? "ratio"
           : unit == "s"  ? "time"
           : unit == "m"  ? "length"
                          : "value";
}

void add_values(LineChart& chart, const ValidationRecord& record, const std::vector<const ValidationRow*>& rows) {
    Marks measured;
    Marks limits;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const ValidationRow& row = *rows[i];
        if (row.is_open()) {
            const double limit = std::isinf(row.low) ? row.high : row.low;
            limits.add(place_of(i, 0, record.models.size()) - apart, limit, limit);
        } else if (row.is_measured) {
            measured.add(place_of(i, 0, record.models.size()) - apart, row.low - row.uncertainty,
                         row.high + row.uncertainty);
        }
    }
    if (!measured.x.empty()) {
        chart.add_ranges("measured, from - u to + u", "measured", measured.x, measured.low, measured.high);
    }
    if (!limits.x.empty()) {
        chart.add_ranges("measured limit", "limit", limits.x, limits.low, limits.high);
    }
    for (std::size_t m = 0; m < record.models.size(); ++m) {
        Marks values;
        Marks reaches;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            if (const std::optional<double>& value = rows[i]->models[m].value) {
                const Reach by_inputs = reach(*rows[i], m);
                const double at = place_of(i, m, record.models.size());
                values.add(at, *value, *value);
                if (by_inputs.down > 0.0 || by_inputs.up > 0.0) {
                    reaches.add(at, *value - by_inputs.down, *value + by_inputs.up);
                }
            }
        }
        const std::string& name = record.models[m].name;
        if (!reaches.x.empty()) {
            chart.add_ranges(name + ", reach of inputs that are not printed", name, reaches.x, reaches.low,
                             reaches.high);
        }
        if (!values.x.empty()) {
            chart.add_curve(name, name, CurveRole::points, values.x, values.low);
        }
    }
}

void add_differences(LineChart& chart, const ValidationRecord& record, const std::vector<const ValidationRow*>& rows) {
    for (std::size_t m = 0; m < record.models.size(); ++m) {
        const std::string& name = record.models[m].name;
        Marks differences;
        Marks bounds;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            if (const std::optional<double> off = difference(*rows[i], m)) {
                const double at = place_of(i, m, record.models.size());
                differences.add(at, *off, *off);
                if (rows[i]->uncertainty > 0.0) {
                    const double u = total_uncertainty(*rows[i], m);
                    bounds.add(at, -2.0 * u, 2.0 * u);
                }
            }
        }
        if (!bounds.x.empty()) {
            chart.add_ranges(name + ", within 2 u", name, bounds.x, bounds.low, bounds.high);
        }
        if (!differences.x.empty()) {
            chart.add_curve(name, name, CurveRole::points, differences.x, differences.low);
        }
    }
    chart.add_level("", 0.0);
}

}  // namespace

ReportSection validation_charts(const ValidationRecord& record) {
    ReportSection section("Measured and simulated");
    std::vector<std::string> units;
    for (const ValidationRow& row : record.rows) {
        if (std::ranges::find(units, row.unit) == units.end()) {
            units.push_back(row.unit);
        }
    }
    for (const std::string& unit : units) {
        std::vector<const ValidationRow*> rows;
        std::vector<std::string> labels;
        std::vector<std::string> notes;
        bool any_difference = false;
        for (const ValidationRow& row : record.rows) {
            if (row.unit == unit) {
                rows.push_back(&row);
                labels.push_back(row.id);
                notes.push_back(fmt::format("{}: {}", row.id, row.what));
                for (std::size_t m = 0; m < record.models.size(); ++m) {
                    any_difference = any_difference || difference(row, m).has_value();
                }
            }
        }
        LineChart chart("experiment", "", -0.5, static_cast<double>(rows.size()) - 0.5);
        chart.set_labels(labels, notes);
        const std::string shown = unit == "1" ? "" : axis_unit(unit);
        chart.add_panel(quantity_of(unit), shown);
        add_values(chart, record, rows);
        if (any_difference) {
            chart.add_panel("simulated - measured", unit == "1" ? "" : difference_unit(unit), true);
            add_differences(chart, record, rows);
        }
        section.chart(fmt::format("Measured and simulated: {}{}", quantity_of(unit),
                                  shown.empty() ? "" : fmt::format(" ({})", shown)),
                      "A bar with circles is a measured number with its standard uncertainty u, a point a simulated "
                      "one. Below: a difference within its bar is within 2 u, with what is not printed counted in u. "
                      "To the nearest end of a measured range; 0 inside it.",
                      chart.data());
    }
    return section;
}

std::vector<std::string> validation_verdict(const ValidationRecord& record) {
    std::vector<std::string> sentences;
    for (std::size_t m = 0; m < record.models.size(); ++m) {
        const ModelFigures f = figures(record, m, false);
        if (f.temperatures + f.orders + f.not_decidable == 0) {
            continue;
        }
        std::vector<std::string> parts;
        if (f.temperatures > 0) {
            parts.push_back(fmt::format("{} of {} within 2 u, mean difference {:+.1f} K{}", f.within,
                                        plural(f.temperatures, "temperature"), f.bias,
                                        f.temperatures > 1 ? fmt::format(", scatter {:.1f} K", f.scatter) : ""));
        }
        if (f.orders > 0) {
            parts.push_back(fmt::format("{} of {} of order or sign {}", f.holding, plural(f.orders, "statement"),
                                        f.orders == 1 ? "holds" : "hold"));
        }
        if (f.not_decidable > 0) {
            parts.push_back(fmt::format("{} not decidable, since inputs that the source does not print decide them",
                                        plural(f.not_decidable, "number")));
        }
        sentences.push_back(fmt::format("{}: {}.", record.models[m].name, fmt::join(parts, "; ")));
    }
    return sentences;
}

}  // namespace tiretherm::post
