// SPDX-License-Identifier: BSD-3-Clause
// The runs of a study as a CSV table, one row for each run.

#include <iterator>

#include <fmt/format.h>

#include "post/study/study_tables.hpp"
#include "solver/celsius.hpp"
#include "solver/channel_unit.hpp"

namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered here

namespace {

/// A cell as it may stand between commas.
std::string cell(const std::string& text) {
    if (text.find_first_of(",\"\n") == std::string::npos) {
        return text;
    }
    std::string quoted = "\"";
    for (const char c : text) {
        quoted += c == '"' ? "\"\"" : c == '\n' ? " " : std::string(1, c);
    }
    return quoted + "\"";
}

std::string headings(const StudyRecord& study) {
    std::string row = "run";
    for (const StudyColumn& column : study.columns) {
        row += "," + cell(column.heading());
    }
    row += ",outcome,hottest [degC],hottest_time [s],hottest_layer,hottest_zone";
    for (const solver::Channel& channel : study.channels) {
        for (const char* what : {"final", "min", "max"}) {
            row += "," + cell(fmt::format("{}_{} [{}]", channel.name, what, solver::shown_unit(channel.quantity).name));
        }
    }
    return row + ",energy_closure [-],steps [-]\n";
}

}  // namespace

std::string study_csv(const StudyRecord& study) {
    std::string text = headings(study);
    for (std::size_t r = 0; r < study.outcomes.size(); ++r) {
        const StudyOutcome& run = study.outcomes[r];
        text += fmt::format("{}", r + 1);
        for (const StudyColumn& column : study.columns) {
            text += "," + (column.is_number ? fmt::format("{:.10g}", column.numbers[r]) : cell(column.texts[r]));
        }
        if (!run.ok()) {
            text += "," + cell(run.failure) + std::string(6 + 3 * study.channels.size(), ',') + "\n";
            continue;
        }
        fmt::format_to(std::back_inserter(text), ",ok,{:.4f},{:.6g},{},{}", solver::celsius(run.hottest),
                       run.hottest_time, cell(run.hottest_layer), cell(run.hottest_zone));
        for (std::size_t c = 0; c < study.channels.size(); ++c) {
            const solver::ShownUnit unit = solver::shown_unit(study.channels[c].quantity);
            for (const double value : {run.channel_final[c], run.channel_min[c], run.channel_max[c]}) {
                fmt::format_to(std::back_inserter(text), ",{:.4f}", unit.value(value));
            }
        }
        fmt::format_to(std::back_inserter(text), ",{:.2e},{}\n", run.energy_closure, run.steps);
    }
    return text;
}

}  // namespace tiretherm::post
