// SPDX-License-Identifier: BSD-3-Clause
// Decimals by unit, ranges with uncertainty, differences with sign, and the rows of figures for each model.

#include "post/validation/validation_cells.hpp"

#include <cmath>

#include <fmt/format.h>

namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered here

namespace {

int decimals(const std::string& unit) {
    if (unit == "1") {
        return 3;
    }
    return unit == "s" || unit == "N/rad" ? 0 : 1;
}

std::string number(const ValidationRow& row, double value) {
    // No "-0.0" for what rounds to nothing.
    const std::string text = fmt::format("{:.{}f}", value, decimals(row.unit));
    return text.find_first_not_of("-0.") == std::string::npos && text.front() == '-' ? text.substr(1) : text;
}

std::vector<std::string> figure_cells(const std::string& name, const ModelFigures& f) {
    const bool any = f.temperatures > 0;
    return {name,
            fmt::format("{}", f.temperatures),
            any ? fmt::format("{:+.1f}", f.bias) : "-",
            any ? fmt::format("{:.1f}", f.rms) : "-",
            any ? fmt::format("{:.1f}", f.scatter) : "-",
            any ? fmt::format("{} of {}", f.within, f.temperatures) : "-",
            f.orders > 0 ? fmt::format("{} of {}", f.holding, f.orders) : "-"};
}

}  // namespace

std::string measured_text(const ValidationRow& row, const char* plus_minus) {
    if (!row.is_measured) {
        return "-";
    }
    const std::string spread =
        row.uncertainty > 0.0 ? fmt::format(" {} {}", plus_minus, number(row, row.uncertainty)) : "";
    if (std::isinf(row.low)) {
        return "< " + number(row, row.high) + spread;
    }
    if (std::isinf(row.high)) {
        return "> " + number(row, row.low) + spread;
    }
    return (row.low == row.high ? number(row, row.low)
                                : fmt::format("{} to {}", number(row, row.low), number(row, row.high))) +
           spread;
}

std::string value_text(const ValidationRow& row, std::size_t model) {
    const ModelValue& found = row.models[model];
    return found.value ? number(row, *found.value) : found.applicable ? "failed" : "";
}

std::string difference_text(const ValidationRow& row, std::size_t model) {
    const std::optional<double> off = difference(row, model);
    if (!off || (row.is_open() && *off == 0.0)) {
        return "";
    }
    return (*off > 0.0 ? "+" : "") + number(row, *off);
}

std::vector<std::vector<std::string>> figure_rows(const ValidationRecord& record) {
    std::vector<std::vector<std::string>> rows{
        {"model", "temperatures", "bias K", "rms K", "scatter K", "within 2 u", "orders that hold"}};
    for (std::size_t m = 0; m < record.models.size(); ++m) {
        const ModelFigures common = figures(record, m, true);
        const ModelFigures all = figures(record, m, false);
        if (common.temperatures + common.orders > 0) {
            rows.push_back(figure_cells(record.models[m].name, common));
        }
        if (all.temperatures != common.temperatures || all.orders != common.orders) {
            rows.push_back(figure_cells(record.models[m].name + ", all", all));
        }
    }
    return rows;
}

}  // namespace tiretherm::post
