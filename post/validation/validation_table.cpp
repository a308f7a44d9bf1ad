// SPDX-License-Identifier: BSD-3-Clause
// Sets a validation table as aligned text for a terminal and as Markdown, with its legend and figures.

#include "post/validation/validation_table.hpp"

#include <fmt/format.h>

#include "post/report/table.hpp"
#include "post/validation/validation_cells.hpp"

namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered here

namespace {

const char* markdown_unit(const std::string& unit) { return unit == "degC" ? "°C" : unit == "1" ? "" : unit.c_str(); }

constexpr const char* legend =
    "Off: model less measured, to the nearest end of a range. u: standard uncertainty of the measured number. Bias: "
    "mean "
    "of off over the temperatures that all models give; scatter: standard deviation about it, beyond what u explains.";

std::string markdown_line(const std::vector<std::string>& cells) {
    return fmt::format("| {} |\n", fmt::join(cells, " | "));
}

}  // namespace

std::string validation_text(const ValidationRecord& record, bool bold) {
    const auto strong = [&](const std::string& line) {
        return bold ? fmt::format("\033[1m{}\033[0m\n", line) : line + "\n";
    };
    std::vector<bool> left{true, true, true, false};
    std::vector<std::string> heading{"id", "what", "unit", "measured"};
    for (const ModelName& model : record.models) {
        left.insert(left.end(), {false, true});
        heading.insert(heading.end(), {model.name, "verdict"});
    }
    // The difference in units stands for the last model alone: a line must fit on a screen.
    left.insert(left.end() - 1, false);
    heading.insert(heading.end() - 1, "off");
    Table table(left);
    table.add(heading);
    std::string failures;
    for (const ValidationRow& row : record.rows) {
        std::vector<std::string> cells{row.id, row.what, row.unit, measured_text(row, "+-")};
        for (std::size_t m = 0; m < row.models.size(); ++m) {
            cells.insert(cells.end(), {value_text(row, m), verdict(row, m)});
            const std::string failure = wrap(row.models[m].failure, 2);
            failures += failures.find(failure) == std::string::npos ? failure : "";
        }
        cells.insert(cells.end() - 1, difference_text(row, row.models.size() - 1));
        table.add(std::move(cells));
    }
    Table summary({true, false, false, false, false, false, false});
    for (const std::vector<std::string>& row : figure_rows(record)) {
        summary.add(row);
    }
    std::string text = strong(record.title) + table.text(2);
    text += "\n" + strong("Model against experiment") + summary.text(2) + "\n" + wrap(legend, 2);
    std::string warnings;
    for (const std::string& warning : record.warnings) {
        warnings += wrap(warning, 2);
    }
    text += warnings.empty() ? "" : "\n" + strong("Warnings") + warnings;
    text += failures.empty() ? "" : "\n" + strong("Runs that failed") + failures;
    text += fmt::format("\n  {} runs in {:.1f} s; energy closes to {:.1e} at worst\n", record.runs, record.seconds,
                        record.energy_closure);
    return text;
}

std::string validation_markdown(const ValidationRecord& record) {
    std::vector<std::string> names{"", "what", "measured"};
    for (const ModelName& model : record.models) {
        names.insert(names.end(), {model.name, "verdict"});
    }
    std::string text = markdown_line(names) + markdown_line(std::vector<std::string>(names.size(), "---"));
    for (const ValidationRow& row : record.rows) {
        std::vector<std::string> cells{row.id, row.what,
                                       fmt::format("{} {}", measured_text(row, "±"), markdown_unit(row.unit))};
        for (std::size_t m = 0; m < row.models.size(); ++m) {
            cells.insert(cells.end(), {value_text(row, m), verdict(row, m)});
        }
        text += markdown_line(cells);
    }
    text += "\n";
    const std::vector<std::vector<std::string>> summary = figure_rows(record);
    text += markdown_line(summary[0]) + markdown_line(std::vector<std::string>(summary[0].size(), "---"));
    for (std::size_t i = 1; i < summary.size(); ++i) {
        text += markdown_line(summary[i]);
    }
    return text;
}

}  // namespace tiretherm::post
