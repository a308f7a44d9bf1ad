// SPDX-License-Identifier: BSD-3-Clause
// The survey of a logger's file as a report.

#include "app/commands/check_log.hpp"

#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "app/commands.hpp"
#include "app/given_units.hpp"
#include "app/messages.hpp"
#include "calls/doing.hpp"
#include "input/log_survey/log_survey.hpp"
#include "input/text/characters.hpp"
#include "post/report/report.hpp"
#include "post/report/table.hpp"

namespace tiretherm::app {

namespace {

using post::Cell;
using post::DataTable;
using post::Value;

std::string use_text(const input::ColumnSurvey& column) {
    if (!column.use.empty()) {
        return column.use == "time"     ? "time"
               : column.used_as.empty() ? std::string(input::text_of_other_use(column.use))
                                        : fmt::format("{} {}", column.use, column.used_as);
    }
    const bool guess = !column.suggestion.empty() && column.suggestion != column.name && !column.is_dropped;
    return guess ? fmt::format("not used; is it {}?", column.suggestion) : fmt::format("not used: {}", column.reason);
}

/// "20 Hz", "0.5 Hz"; empty without a rate.
std::string rate_text(double rate) { return rate > 0.0 ? fmt::format("{:.4g} Hz", rate) : ""; }

DataTable channels(const input::LogSurvey& survey) {
    DataTable table;
    for (const input::ColumnSurvey& column : survey.columns) {
        const auto bound = [](const std::optional<double>& value) {
            return Cell(Value(value), value ? fmt::format("{:.6g}", *value) : "");
        };
        table.add(
            {{"channel", "name", input::printable(column.name)},
             {"unit", "unit", input::printable(column.unit)},
             {"rate", "rate", Cell(Value(column.rate), rate_text(column.rate))},
             {"from", "low", bound(column.low)},
             {"to", "high", bound(column.high)},
             {"missing", "missing",
              Cell(Value(column.missing), column.missing > 0.0 ? fmt::format("{:.1f} %", 100.0 * column.missing) : "")},
             post::page_only("used as", input::printable(use_text(column))),
             post::data_only("samples", column.samples),
             post::data_only("use", column.use.empty() ? "not used" : column.use),
             post::data_only("used_as", column.used_as),
             post::data_only("suggestion", column.suggestion),
             post::data_only("reason", input::printable(column.reason))});
    }
    return table;
}

DataTable laps(const input::LogSurvey& survey) {
    DataTable table;
    for (const input::Lap& lap : survey.laps.laps) {
        table.add({{"lap", "number", post::count(static_cast<std::size_t>(std::max(lap.number, 0)))},
                   {"", "kind", std::string(input::word_of(lap.kind))},
                   {"time", "time", Cell(Value(lap.end - lap.start), input::lap_time(lap.end - lap.start))},
                   {"from s", "start", post::shown("{:.3f}", lap.start)},
                   {"to s", "end", post::shown("{:.3f}", lap.end)}});
    }
    return table;
}

std::string source_of(const input::Laps& laps) {
    switch (laps.source) {
        case input::LapSource::none:
            break;
        case input::LapSource::markers:
            return "By the logger's marks.";
        case input::LapSource::column:
            return fmt::format("By the channel {}.", input::printable(laps.column));
        case input::LapSource::start_line:
            return "Where the positions cross the start line of the file.";
        case input::LapSource::closed_track:
            return "By the positions: the line is put across the fastest place that the car passes again and again.";
    }
    return "None: the file has no marks between laps, no channel that counts them and no track that closes.";
}

std::string_view word_of(input::LapSource source) {
    constexpr std::string_view words[] = {"none", "markers", "column", "start_line", "closed_track"};
    return words[static_cast<std::size_t>(source)];
}

post::Report report_of(const input::LogSurvey& survey) {
    post::Report report{.title = input::printable(survey.path)};
    report.lead.push_back(fmt::format("{}, {} from {:.6g} s to {:.6g} s, {}", survey.description.format,
                                      post::plural(survey.columns.size(), "channel"), survey.from, survey.to,
                                      post::plural(survey.rows, "row")));
    Value::List details;
    post::TextTable shown({true, true});
    for (const input::LogDetail& detail : survey.description.details) {
        details.push_back({{"name", detail.name}, {"value", detail.value}});
        shown.add({detail.name, detail.value});
    }
    if (!details.empty()) {
        post::ReportSection section("Recording");
        for (const std::string& line : shown.lines(0)) {
            section.line(line);
        }
        report.add(std::move(section));
    }
    report.add(post::ReportSection("Channels", channels(survey)));
    post::ReportSection of_laps("Laps");
    of_laps.say(source_of(survey.laps));
    of_laps.add(laps(survey));
    report.add(std::move(of_laps));
    report.data = {{"file", survey.path},
                   {"format", survey.description.format},
                   {"from", survey.from},
                   {"to", survey.to},
                   {"rows", survey.rows},
                   {"details", details},
                   {"channels", channels(survey).data()},
                   {"laps", {{"source", word_of(survey.laps.source)}, {"laps", laps(survey).data()}}}};
    report.add("Suspicious", "suspicious", survey.doubts);
    return report;
}

}  // namespace

int check_log(const std::filesystem::path& path, const std::vector<std::string>& units, bool json) {
    const std::optional<std::vector<input::GivenUnit>> given = given_units(units, json);
    if (!given) {
        return Exit::input_error;
    }
    calls::now_doing(fmt::format("reading {}", path.generic_string()));
    input::InputErrors errors;
    const std::optional<input::LogSurvey> survey = input::survey_log(path, *given, errors);
    if (!survey) {
        report_errors({.errors = errors.in_order(), .warnings = render(errors.warnings(), 0)}, "the log cannot be used",
                      json);
        return Exit::input_error;
    }
    print_report(report_of(*survey), json);
    return Exit::done;
}

}  // namespace tiretherm::app
