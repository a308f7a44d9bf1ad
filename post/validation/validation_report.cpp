// SPDX-License-Identifier: BSD-3-Clause
// A validation table as a report: decimals by unit, ranges with uncertainty, differences with sign, figures for each model.
#include "post/validation/validation_report.hpp"

#include <cmath>
#include <set>

#include <fmt/format.h>

namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered here

namespace {

constexpr const char* legend =
    "Off: model less measured, to the nearest end of a range. u: standard uncertainty of the measured number. Bias: "
    "mean "
    "of off over the temperatures that all models give; scatter: standard deviation about it, beyond what u explains.";

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

/// "47 to 48 +- 4.1", "> 60"; "-" where nothing was measured.
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

/// A value with the decimals of its unit; "failed", or empty where the model has no such number.
Cell value_cell(const ValidationRow& row, std::size_t model) {
    const ModelValue& found = row.models[model];
    return right(found.value ? number(row, *found.value) : found.applicable ? "failed" : "");
}

/// "+3.2"; empty where there is no difference.
Cell difference_cell(const ValidationRow& row, std::size_t model) {
    const std::optional<double> off = difference(row, model);
    const bool none = !off || (row.is_open() && *off == 0.0);
    return right(none ? "" : (*off > 0.0 ? "+" : "") + number(row, *off));
}

Value measured_data(const ValidationRow& row) {
    if (!row.is_measured) {
        return {};
    }
    Value data{{"low", row.low}, {"high", row.high}, {"source", row.source}};
    if (row.uncertainty > 0.0) {
        data.set("uncertainty", row.uncertainty);
        Value parts;
        for (const auto& [name, part] : row.parts) {
            parts.set(name, part);
        }
        if (!row.parts.empty()) {
            data.set("uncertainty_parts", std::move(parts));
        }
    }
    return data;
}

Value model_data(const ValidationRow& row, std::size_t model) {
    const ModelValue& found = row.models[model];
    if (!found.applicable) {
        return {};
    }
    Value data;
    data.set("value", found.value);
    if (const std::optional<double> off = difference(row, model)) {
        data.set("difference", *off);
        if (row.uncertainty > 0.0) {
            data.set("in_uncertainties", *off / row.uncertainty);
        }
        data.set("verdict", verdict(row, model));
    }
    if (!found.failure.empty()) {
        data.set("error", found.failure);
    }
    return data;
}

DataTable numbers(const ValidationRecord& record) {
    DataTable table;
    for (const ValidationRow& row : record.rows) {
        DataTable::Row cells{{"id", "id", row.id},
                             {"what", "what", row.what},
                             {"unit", "unit", row.unit},
                             data_only("measured", measured_data(row)),
                             page_only("measured", right(measured_text(row, "+-")))};
        Value models;
        for (std::size_t m = 0; m < record.models.size(); ++m) {
            cells.push_back(page_only(record.models[m].name, value_cell(row, m)));
            // The difference in units stands for the last model alone: a line must fit on a screen.
            if (m + 1 == record.models.size()) {
                cells.push_back(page_only("off", difference_cell(row, m)));
            }
            cells.push_back(page_only("verdict", verdict(row, m)));
            models.set(record.models[m].key, model_data(row, m));
        }
        cells.push_back(data_only("models", std::move(models)));
        table.add(std::move(cells));
    }
    return table;
}

DataTable::Row figure_row(const std::string& name, const ModelFigures& f) {
    const bool any = f.temperatures > 0;
    return {page_only("model", name),
            page_only("temperatures", right(fmt::format("{}", f.temperatures))),
            page_only("bias K", right(any ? fmt::format("{:+.1f}", f.bias) : "-")),
            page_only("rms K", right(any ? fmt::format("{:.1f}", f.rms) : "-")),
            page_only("scatter K", right(any ? fmt::format("{:.1f}", f.scatter) : "-")),
            page_only("within 2 u", right(any ? fmt::format("{} of {}", f.within, f.temperatures) : "-")),
            page_only("orders that hold", right(f.orders > 0 ? fmt::format("{} of {}", f.holding, f.orders) : "-"))};
}

DataTable figure_table(const ValidationRecord& record) {
    DataTable table(figure_row("", {}));
    for (std::size_t m = 0; m < record.models.size(); ++m) {
        const ModelFigures common = figures(record, m, true);
        const ModelFigures all = figures(record, m, false);
        if (common.temperatures + common.orders > 0) {
            table.add(figure_row(record.models[m].name, common));
        }
        if (all.temperatures != common.temperatures || all.orders != common.orders) {
            table.add(figure_row(record.models[m].name + ", all", all));
        }
    }
    return table;
}

Value figure_data(const ModelFigures& f) {
    return {{"temperatures", f.temperatures}, {"bias", f.bias},     {"rms", f.rms},        {"scatter", f.scatter},
            {"within_2u", f.within},          {"orders", f.orders}, {"holding", f.holding}};
}

Section failures(const ValidationRecord& record) {
    Section section("Runs that failed");
    std::set<std::string> said;
    for (const ValidationRow& row : record.rows) {
        for (const ModelValue& model : row.models) {
            if (said.insert(model.failure).second) {
                section.say(model.failure);
            }
        }
    }
    return section;
}

}  // namespace

Report validation_report(const ValidationRecord& record) {
    DataTable of_numbers = numbers(record);
    Value summary;
    for (std::size_t m = 0; m < record.models.size(); ++m) {
        summary.set(record.models[m].key, {{"common", figure_data(figures(record, m, true))},
                                           {"all", figure_data(figures(record, m, false))}});
    }
    Report report{.title = record.title};
    report.data = {{"title", record.title}, {"numbers", of_numbers.data()}, {"summary", std::move(summary)},
                   {"runs", record.runs},   {"seconds", record.seconds},    {"energy_closure", record.energy_closure}};
    report.add(Section("", std::move(of_numbers)));
    Section of_models("Model against experiment", figure_table(record));
    of_models.gap();
    of_models.say(legend);
    report.add(std::move(of_models));
    report.add("Warnings", "warnings", record.warnings);
    report.add(failures(record));
    Section cost("");
    cost.line(fmt::format("{} runs in {:.1f} s; energy closes to {:.1e} at worst", record.runs, record.seconds,
                          record.energy_closure));
    report.add(std::move(cost));
    return report;
}

std::string validation_markdown(const ValidationRecord& record) {
    DataTable table;
    for (const ValidationRow& row : record.rows) {
        const std::string unit = row.unit == "degC" ? "°C" : row.unit == "1" ? "" : row.unit;
        DataTable::Row cells{page_only("", row.id), page_only("what", row.what),
                             page_only("measured", fmt::format("{} {}", measured_text(row, "±"), unit))};
        for (std::size_t m = 0; m < record.models.size(); ++m) {
            cells.push_back(page_only(record.models[m].name, value_cell(row, m)));
            cells.push_back(page_only("verdict", verdict(row, m)));
        }
        table.add(std::move(cells));
    }
    return markdown_text(table) + "\n" + markdown_text(figure_table(record));
}

}  // namespace tiretherm::post
