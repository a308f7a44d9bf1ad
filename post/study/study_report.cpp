// SPDX-License-Identifier: BSD-3-Clause
// A study as a report: hottest temperatures over its grid, extremes, failed runs and cost.
#include "post/study/study_report.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "diagnosis/study/study_statistics.hpp"
#include "physics/celsius.hpp"
#include "post/study/study_chart.hpp"
#include "post/study/study_sections.hpp"

namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered here

namespace {

// What a page holds.
constexpr std::size_t most_columns = 9;
constexpr std::size_t most_failures = 10;

/// All that differs between runs: a run's own values; what was drawn with four digits.
std::string values_text(const StudyRecord& study, std::size_t run) {
    std::string text;
    for (const StudyColumn& column : study.columns) {
        const bool is_drawn = column.is_drawn && column.is_number;
        text += fmt::format(
            "{}{} = {}", text.empty() ? "" : ", ", column.key,
            is_drawn ? fmt::format("{:.4g}{}{}", column.numbers[run], column.unit.empty() ? "" : " ", column.unit)
                     : column.texts[run]);
    }
    return text;
}

Value run_data(const StudyRecord& study, std::size_t run) {
    const StudyOutcome& outcome = study.outcomes[run];
    Value data{{"run", run + 1}, {"values", study_values(study, run, false)}};
    if (!outcome.ok()) {
        data.set("error", outcome.failure);
        return data;
    }
    data.set({{"temperature", celsius(outcome.hottest)},
              {"unit", "degC"},
              {"time", outcome.hottest_time},
              {"layer", outcome.hottest_layer},
              {"zone", text_or_null(outcome.hottest_zone)}});
    return data;
}

/// Rows: the first side of the grid, columns: the second one. Empty where a page would not hold it.
ReportSection grid_section(const StudyRecord& study) {
    ReportSection section(study.is_sampled ? "Hottest temperature [degC], median of the samples"
                                           : "Hottest temperature [degC]");
    if (study.sides.size() != 2 || study.sides[0] > most_rows || study.sides[1] > most_columns) {
        return section;
    }
    const auto value = [&](std::size_t side, std::size_t point) {
        const StudyColumn& column = study.columns[side];
        const std::size_t run = point * study.samples;
        return column.is_number ? fmt::format("{:.6g}", column.numbers[run]) : column.texts[run];
    };
    DataTable table;
    for (std::size_t i = 0; i < study.sides[0]; ++i) {
        DataTable::Row row{page_only("", right(value(0, i * study.sides[1])))};
        for (std::size_t j = 0; j < study.sides[1]; ++j) {
            row.push_back(page_only(value(1, j), right(median_text(hottest_at(study, i * study.sides[1] + j)))));
        }
        table.add(std::move(row));
    }
    section.line(fmt::format("down: {}; across: {}", study.columns[0].heading(), study.columns[1].heading()));
    section.add(std::move(table));
    return section;
}

std::string extreme_text(const StudyRecord& study, const char* name, std::size_t run) {
    const StudyOutcome& found = study.outcomes[run];
    const std::string zone = found.hottest_zone.empty() ? "" : ", " + found.hottest_zone;
    return fmt::format("{} run: {:.1f} degC in {}{} at {:.6g} s; run {}: {}", name, celsius(found.hottest),
                       found.hottest_layer, zone, found.hottest_time, run + 1, values_text(study, run));
}

/// On the page, and "hottest" and "coldest" of the data; nothing where all runs failed.
ReportSection extremes_section(const StudyRecord& study, Value& data) {
    ReportSection section("Extremes");
    std::vector<std::size_t> done;
    for (std::size_t run = 0; run < study.outcomes.size(); ++run) {
        if (study.outcomes[run].ok()) {
            done.push_back(run);
        }
    }
    if (done.empty()) {
        return section;
    }
    const auto temperature = [&](std::size_t run) { return study.outcomes[run].hottest; };
    // Of equally hot runs the first; minmax_element would give the last.
    const auto hottest = std::ranges::max_element(done, {}, temperature);
    const auto coldest = std::ranges::min_element(done, {}, temperature);
    data.set({{"hottest", run_data(study, *hottest)}, {"coldest", run_data(study, *coldest)}});
    section.say(extreme_text(study, "hottest", *hottest));
    section.say(extreme_text(study, "coldest", *coldest));
    return section;
}

/// On the page, and "failed" of the data.
ReportSection failures_section(const StudyRecord& study, Value::List& data) {
    ReportSection section("Runs that failed");
    for (const std::size_t run : study.failed()) {
        data.push_back(run_data(study, run));
        if (data.size() <= most_failures) {
            section.say(fmt::format("run {} ({}): {}", run + 1, values_text(study, run), study.outcomes[run].failure));
        }
    }
    if (data.size() > most_failures) {
        section.say(fmt::format("and {} more; all are in the tables", data.size() - most_failures));
    }
    return section;
}

ReportSection cost_section(const StudyRecord& study, const StudyCall& call) {
    const std::size_t made = study.outcomes.size() - call.kept;
    std::string cost = fmt::format("{} kept, {} made now in {:.1f} s", call.kept, made, call.seconds);
    if (made > 0) {
        cost +=
            fmt::format(" ({:.3f} s a run, {} at a time)", call.run_seconds / static_cast<double>(made), call.threads);
    }
    ReportSection section("Cost");
    section.line(std::move(cost));
    if (call.outdated > 0) {
        section.line(fmt::format("{} of another build of tiretherm are not used", plural(call.outdated, "run")));
    }
    if (call.damaged > 0) {
        section.line(fmt::format("{} of runs.jsonl could not be read and {} dropped; what {} for was run anew",
                                 plural(call.damaged, "damaged line"), call.damaged == 1 ? "was" : "were",
                                 call.damaged == 1 ? "it stood" : "they stood"));
    }
    return section;
}

std::string lead(const StudyRecord& study) {
    const std::string samples =
        fmt::format(", {} at each of {}", plural(study.samples, "sample"), plural(study.points(), "point"));
    return fmt::format("{} of {}{}", plural(study.outcomes.size(), "run"), study.case_name,
                       study.is_sampled && study.points() > 1 ? samples : "");
}

}  // namespace

Report study_report(const StudyRecord& study, const StudyCall& call) {
    Report report{.title = study.title, .lead = {lead(study)}};
    Value::List failed;
    ReportSection failures = failures_section(study, failed);
    report.data = {{"title", study.title},
                   {"case", study.case_name},
                   {"version", study.version},
                   {"runs", study.outcomes.size()},
                   {"kept", call.kept},
                   {"made", study.outcomes.size() - call.kept},
                   {"seconds", call.seconds},
                   {"threads", call.threads},
                   {"critical", study.critical ? Value(celsius(*study.critical)) : Value()},
                   {"failed", std::move(failed)}};
    ReportSection extremes = extremes_section(study, report.data);
    DataTable of_points = study_points(study);
    ReportSection grid = grid_section(study);
    const bool with_points = (grid.blocks().empty() || study.is_sampled) && study.points() <= most_rows;
    if (study.is_sampled) {
        report.data.set("points", of_points.data());
    }
    report.add(study_chart_section(study));
    report.add(std::move(grid));
    if (with_points) {
        report.add(
            ReportSection(study.is_sampled ? "Hottest temperature [degC] of the samples" : "Hottest temperature [degC]",
                          std::move(of_points)));
    }
    report.add(drivers_section(study));
    report.verdict = study_headline(study);
    report.add(std::move(extremes));
    report.add("Warnings", "warnings", study.warnings);
    report.add(std::move(failures));
    report.add(cost_section(study, call));
    report.add(call.files);
    return report;
}

}  // namespace tiretherm::post
