// SPDX-License-Identifier: BSD-3-Clause
// A validation table as a report: decimals by unit, ranges with uncertainty, differences with sign, figures for each model.
#include "post/validation/validation_report.hpp"

#include <cmath>
#include <set>

#include <fmt/format.h>

#include "post/page/html_page.hpp"
#include "post/report/file.hpp"
#include "post/report/number_text.hpp"
#include "post/validation/validation_charts.hpp"

namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered here

namespace {

constexpr const char* data_name = "validation.json";
constexpr const char* legend =
    "Off: model less measured, to the nearest end of a range. In brackets: from where to where the inputs that the "
    "source does not print move the number. u: standard uncertainty of the measured number and of these inputs. Not "
    "decidable: the verdict depends on such an input, or one was inferred from this very number; these numbers count "
    "nowhere below. Bias: mean of off over the temperatures that can be decided for all models; scatter: standard "
    "deviation about it, beyond what u explains.";

std::string number(const ValidationRow& row, double value) { return in_digits_of(row.unit, value); }

/// "47 to 48 +- 4.1", "> 60"; "-" where nothing was measured.
std::string measured_text(const ValidationRow& row, const char* plus_minus) {
    if (!row.is_measured) {
        return "-";
    }
    return range_text(row.unit, row.low, row.high) +
           (row.uncertainty > 0.0 ? fmt::format(" {} {}", plus_minus, number(row, row.uncertainty)) : "");
}

/// "+3.2", "-3.2", "0.0".
std::string signed_number(const ValidationRow& row, double change) {
    const std::string text = number(row, change);
    return (change > 0.0 && text.find_first_of("123456789") != std::string::npos ? "+" : "") + text;
}

/// A value with the decimals of its unit, and in brackets the range that unknown inputs leave; "failed", or empty where
/// the model has no such number.
Cell value_cell(const ValidationRow& row, std::size_t model) {
    const ModelValue& found = row.models[model];
    if (!found.value) {
        return right(found.applicable ? "failed" : "");
    }
    const Reach by_inputs = reach(row, model);
    const std::string low = number(row, *found.value - by_inputs.down);
    const std::string high = number(row, *found.value + by_inputs.up);
    return right(number(row, *found.value) + (low == high ? "" : fmt::format(" ({} to {})", low, high)));
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
        const Reach by_inputs = reach(row, model);
        data.set("low", *found.value - by_inputs.down);
        data.set("high", *found.value + by_inputs.up);
        if (row.uncertainty > 0.0) {
            data.set("uncertainty", total_uncertainty(row, model));
            data.set("in_uncertainties", *off / total_uncertainty(row, model));
        }
        data.set("decidable", judge(row, model) != Judgement::not_decidable);
        data.set("verdict", verdict(row, model));
    }
    if (!found.failure.empty()) {
        data.set("error", found.failure);
    }
    return data;
}

/// What the inputs of a number are, with the number at the ends of their ranges.
Value input_data(const ValidationRecord& record, const ValidationRow& row) {
    Value::List list;
    for (const InputEffect& input : row.inputs) {
        Value data{{"name", input.name},
                   {"meaning", input.meaning},
                   {"standing", std::string(input.standing)},
                   {"inferred_from_it", input.inferred_from_it},
                   {"value", input.value}};
        Value models;
        for (std::size_t m = 0; m < record.models.size(); ++m) {
            if (input.at_ends[m].empty()) {
                continue;
            }
            Value of_model{{"at_ends", Value(input.at_ends[m])}};
            of_model.set("sensitivity", sensitivity(input, m));
            models.set(record.models[m].key, std::move(of_model));
        }
        if (!input.ends.empty()) {
            data.set("range", Value(input.ends));
            data.set("models", std::move(models));
        }
        list.push_back(std::move(data));
    }
    return Value(std::move(list));
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
        cells.push_back(data_only("inputs", input_data(record, row)));
        table.add(std::move(cells));
    }
    return table;
}

DataTable::Row figure_row(const std::string& name, const ModelFigures& f) {
    const bool any = f.temperatures > 0;
    const auto kelvin = [&](const char* format, double value) { return any ? shown(format, value) : Cell(value, "-"); };
    const auto part = [](std::size_t some, std::size_t all) {
        return Cell(some, all > 0 ? fmt::format("{} of {}", some, all) : "-");
    };
    return {page_only("model", name),
            {"temperatures", "temperatures", {f.temperatures, fmt::format("{}", f.temperatures)}},
            {"bias K", "bias", kelvin("{:+.1f}", f.bias)},
            {"rms K", "rms", kelvin("{:.1f}", f.rms)},
            {"scatter K", "scatter", kelvin("{:.1f}", f.scatter)},
            {"within 2 u", "within_2u", part(f.within, f.temperatures)},
            data_only("orders", f.orders),
            {"orders that hold", "holding", part(f.holding, f.orders)},
            {"not decidable", "not_decidable", {f.not_decidable, fmt::format("{}", f.not_decidable)}}};
}

DataTable figure_table(const ValidationRecord& record) {
    DataTable table(figure_row("", {}));
    for (std::size_t m = 0; m < record.models.size(); ++m) {
        const ModelFigures common = figures(record, m, true);
        const ModelFigures all = figures(record, m, false);
        if (common.temperatures + common.orders + common.not_decidable > 0) {
            table.add(figure_row(record.models[m].name, common));
        }
        if (all.temperatures != common.temperatures || all.orders != common.orders) {
            table.add(figure_row(record.models[m].name + ", all", all));
        }
    }
    return table;
}

/// Every input once, in the order in which the numbers name them.
DataTable input_table(const ValidationRecord& record) {
    DataTable table;
    std::set<std::string> known;
    for (const ValidationRow& row : record.rows) {
        for (const InputEffect& input : row.inputs) {
            if (known.insert(input.name).second) {
                table.add({page_only("input", input.name), page_only("standing", std::string(input.standing)),
                           page_only("value", input.value),
                           page_only("range", fmt::format("{}", fmt::join(input.ends, ", "))),
                           page_only("meaning", input.meaning)});
            }
        }
    }
    return table;
}

/// " K" of a temperature, of which a sensitivity is for a difference.
std::string step_unit(const InputEffect& input) {
    return input.unit.empty() ? "" : input.unit == "degC" ? " K" : " " + input.unit;
}

/// "ramp 0.0 to +13.7 (0.051 for 1 s)": how unknown inputs change what a model gives.
std::string changes(const ValidationRow& row, std::size_t model) {
    std::vector<std::string> words;
    for (const InputEffect& input : row.inputs) {
        const std::optional<double>& value = row.models[model].value;
        if (!value || input.at_ends[model].empty()) {
            continue;
        }
        std::vector<std::string> ends;
        bool changes_it = false;
        for (const std::optional<double>& end : input.at_ends[model]) {
            ends.push_back(end ? signed_number(row, *end - *value) : "failed");
            changes_it = changes_it || ends.back().find_first_of("123456789f") != std::string::npos;
        }
        const std::optional<double> slope = changes_it ? sensitivity(input, model) : std::nullopt;
        words.push_back(
            fmt::format("{} {}", input.name, changes_it ? fmt::format("{}", fmt::join(ends, " to ")) : "0") +
            (slope ? fmt::format(" ({:.2g} for 1{})", *slope, step_unit(input)) : ""));
    }
    return fmt::format("{}", fmt::join(words, "; "));
}

std::string names(const ValidationRow& row, std::string_view standing) {
    std::vector<std::string> found;
    for (const InputEffect& input : row.inputs) {
        if (input.standing == standing) {
            found.push_back(input.name);
        }
    }
    return fmt::format("{}", fmt::join(found, ", "));
}

/// For each number its printed inputs, and what the others change.
DataTable change_table(const ValidationRecord& record) {
    DataTable table;
    for (const ValidationRow& row : record.rows) {
        if (row.inputs.empty()) {
            continue;
        }
        DataTable::Row cells{page_only("", row.id), page_only("what", row.what),
                             page_only("printed", names(row, "printed")), page_only("inferred", names(row, "inferred")),
                             page_only("assumed", names(row, "assumed"))};
        for (std::size_t m = 0; m < record.models.size(); ++m) {
            cells.push_back(page_only(record.models[m].name + ", change", changes(row, m)));
        }
        table.add(std::move(cells));
    }
    return table;
}

ReportSection failures(const ValidationRecord& record) {
    ReportSection section("Runs that failed");
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

std::vector<std::string> validation_names() {
    std::vector<std::string> names = page_names();
    names.push_back(data_name);
    return names;
}

std::vector<std::filesystem::path> write_validation(const ValidationRecord& record,
                                                    const std::filesystem::path& directory) {
    const std::filesystem::path file = directory / data_name;
    replace_file(file, json_text(validation_report(record, false).data));
    return {file};
}

Report validation_report(const ValidationRecord& record, bool with_inputs,
                         const std::vector<std::filesystem::path>& files) {
    DataTable of_numbers = numbers(record);
    Value summary;
    for (std::size_t m = 0; m < record.models.size(); ++m) {
        summary.set(record.models[m].key, {{"common", object_of(figure_row("", figures(record, m, true)))},
                                           {"all", object_of(figure_row("", figures(record, m, false)))}});
    }
    Report report{.title = record.title};
    report.data = {{"title", record.title}, {"numbers", of_numbers.data()}, {"summary", std::move(summary)},
                   {"runs", record.runs},   {"seconds", record.seconds},    {"energy_closure", record.energy_closure}};
    report.add_verdict(validation_verdict(record));
    report.add(validation_charts(record));
    report.add(ReportSection("Numbers", std::move(of_numbers)));
    ReportSection of_models("Model against experiment", figure_table(record));
    of_models.gap();
    of_models.say(legend);
    report.add(std::move(of_models));
    if (DataTable inputs = input_table(record); with_inputs && !inputs.empty()) {
        report.add(ReportSection("Inputs of the experiments", std::move(inputs)));
        ReportSection effect("Change at the ends of the ranges of inputs");
        for (const ValidationRow& row : record.rows) {
            for (std::size_t m = 0; m < record.models.size(); ++m) {
                if (const std::string words = changes(row, m); !words.empty()) {
                    effect.item(fmt::format("{} {}, {}: {}", row.id, row.what, record.models[m].name, words));
                }
            }
        }
        report.add(std::move(effect));
    }
    report.add("Warnings", "warnings", record.warnings);
    report.add(failures(record));
    ReportSection cost("");
    cost.line(fmt::format("{} runs in {:.1f} s; energy closes to {:.1e} at worst", record.runs, record.seconds,
                          record.energy_closure));
    report.add(std::move(cost));
    if (!files.empty()) {
        report.add(files);
    }
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

std::string validation_inputs_markdown(const ValidationRecord& record) {
    return markdown_text(input_table(record)) + "\n" + markdown_text(change_table(record));
}

}  // namespace tiretherm::post
