// SPDX-License-Identifier: BSD-3-Clause
// The log in a new case: [[run]] or [[drive.file]] with its columns, and what a fit may move.
#include <utility>

#include <fmt/format.h>

#include "input/new_case/case_tables.hpp"
#include "input/text/word_lists.hpp"
#include "input/toml/toml_text.hpp"

namespace tiretherm::input {

namespace {

/// "drive.csv" from the folder in which the case will be.
std::string log_path(const CaseDraft& draft) {
    const std::filesystem::path folder = draft.request.target.parent_path();
    return toml_text::path_value(*draft.request.log, folder.empty() ? "." : folder).text;
}

/// A line of a table of the log's columns.
struct ColumnLine {
    std::string_view column;
    std::string_view value;
    std::string comment;
    bool holds = true;  ///< else it is a suggestion
};

void write_lines(CaseWriter& writer, const std::string& path, std::string_view comment,
                 const std::vector<ColumnLine>& lines) {
    if (!lines.empty()) {
        writer.table(path, comment);
    }
    for (const ColumnLine& line : lines) {
        line.holds ? writer.entry(line.column, line.value, line.comment)
                   : writer.suggestion(line.column, line.value, line.comment);
    }
}

/// Columns that are left alone, in a sentence.
void write_unused(CaseWriter& writer, const Log& log) {
    for (const LogColumn& column : log.columns) {
        if (!column.is_used() && column.must_ignore) {
            writer.remark(fmt::format("{}: {}", column.title(), column.reason));
        }
    }
    std::vector<std::string> unknown;
    for (const LogColumn& column : log.columns) {
        if (!column.is_used() && !column.must_ignore && column.other_use.empty() && column.suggestion.empty() &&
            !column.heading.name.empty()) {
            unknown.push_back(column.heading.name);
        }
    }
    if (!unknown.empty()) {
        writer.remark(fmt::format("No input and no sensor of this case: {}.", listed(unknown)));
    }
}

void write_ignored(CaseWriter& writer, const Log& log) {
    std::vector<std::string> names;
    for (const LogColumn& column : log.columns) {
        if (!column.is_used() && column.must_ignore) {
            names.push_back(toml_text::in_quotes(column.heading.name));
        }
    }
    if (!names.empty()) {
        writer.entry("ignore", fmt::format("[{}]", fmt::join(names, ", ")), "columns that are not used");
    }
}

/// What `tiretherm identify` may move: start, cooling and heating, with how well they are known.
/// @param road_is_assumed to have the air's temperature
void write_parameters(const CaseDraft& draft, CaseWriter& writer, bool is_car, bool road_is_assumed) {
    writer.blank();
    writer.remark(fmt::format(
        "What `tiretherm identify` fits and `tiretherm diagnose` fits anew beside each cause: cooling by the air, "
        "heating by {} and the start, each with the standard deviation of what is known beforehand. "
        "`tiretherm run` and `compare` take the values as they stand.",
        draft.is_specimen() ? "the laser" : "deformation"));
    if (draft.is_specimen()) {
        write_parameter(writer, "still_air", "h", "3 W/m2K", "a film in still air");
        write_parameter(writer, "laser", "absorptivity", "0.05", "black rubber absorbs 0.9 to 1");
    } else {
        write_parameter(writer, "air_convection", "lambda_h", "0.1", "films are known to 10 %");
        write_parameter(writer, "strain_energy_loss", "tan_delta_a", "0.2e15", "about 10 %",
                        "scales the loss tangent (49), and so the loss, everywhere alike");
    }
    if (is_car) {
        for (const auto& [key, meaning] : {std::pair{"lambda_y", "in turns"}, std::pair{"lambda_x", "along"}}) {
            write_parameter(writer, "sliding_friction", key, "0.3", "the slips follow from what is assumed of the car",
                            fmt::format("scales the heat of sliding {}", meaning));
        }
    }
    if (is_car && road_is_assumed) {
        writer.table("effects.road_temperature_drift", "does nothing but for its offset, which a fit may move");
        write_parameter(writer, "road_temperature_drift", "offset", "10 K", "a road in the sun",
                        "how much hotter the road is than [drive] says");
    }
    writer.table("parameter");
    writer.entry(
        "initial", "temperature",
        draft.is_specimen() ? "a shift of the whole specimen at the start" : "a shift of the whole tire at the start");
    writer.entry("standard_deviation", "3 K", "assumed");
}

void write_run(CaseDraft& draft, const Log& log) {
    CaseWriter& writer = draft.writer;
    if (log.is_car) {
        writer.caption("What the log's columns are: of the car, then of each tire.");
        write_car_columns(draft, log);
    }
    writer.caption("The log as a measured run: its inputs win over [drive], what its sensors read is compared.");
    write_unused(writer, log);
    writer.table("run");
    writer.entry("file", log_path(draft), "from this file's folder");
    if (const std::string laps = shown_laps(log); !laps.empty()) {
        writer.suggestion("laps", laps, "the whole laps of the log, or some of them");
    }
    writer.suggestion("from", shown_seconds(log.time.front()));
    writer.suggestion("to", shown_seconds(log.time.back()));
    write_ignored(writer, log);
    if (!log.is_car) {
        write_columns(writer, log, "run");
    }
    write_parameters(draft, writer, log.is_car && log.has_motion(), draft.column("road_temperature") == nullptr);
}

void write_drive_file(CaseDraft& draft, const Log& log) {
    CaseWriter& writer = draft.writer;
    writer.caption(fmt::format("The log drives the {}.", draft.is_specimen() ? "specimen" : "tire"));
    writer.table("drive.file");
    writer.entry("path", log_path(draft), "from this file's folder");
    write_ignored(writer, log);
    write_columns(writer, log, "drive.file");
}

/// How to compare once a column is known to be a sensor's.
void suggest_run(CaseDraft& draft, const Log& log) {
    CaseWriter& writer = draft.writer;
    if (log.is_car) {
        suggest_corners(draft, log);
        return;
    }
    writer.caption(
        "No column of the log is known to be a sensor of this case, so there is nothing to compare with. Say below "
        "which one is, and take the # away from here on.");
    write_unused(writer, log);
    writer.comment_out(true);
    writer.table("run");
    writer.entry("file", log_path(draft), "from this file's folder");
    write_columns(writer, log, "run");
    writer.comment_out(false);
}

}  // namespace

void write_columns(CaseWriter& writer, const Log& log, const std::string& table,
                   const std::optional<std::string>& corner) {
    const bool is_first = !corner || corner->empty();
    const bool may_suggest = table != "drive.file";  // a column that may be a sensor's is no input
    std::vector<ColumnLine> names;
    std::vector<ColumnLine> units;
    for (const LogColumn& column : log.columns) {
        const std::string& heading = column.heading.name;
        if (corner && column.corner != *corner) {
            continue;
        }
        if (column.is_used() && heading != column.name) {
            names.push_back({heading, column.name, column.title()});
        }
        if (column.is_used() && !column.unit.empty()) {
            units.push_back({heading, column.unit, column.unit_remark()});
        }
        if (column.is_used() || !may_suggest) {
            continue;
        }
        if (!column.suggestion.empty() && (corner || column.suggestion != heading)) {
            const std::string question = corner ? column.reason : "is it? Then take the # away";
            names.push_back({heading, column.suggestion, fmt::format("{}: {}", column.title(), question), false});
        }
        if (!column.suggested_unit.empty()) {
            units.push_back({heading, column.suggested_unit, "or what its unit is", false});
        }
    }
    write_lines(writer, table + ".columns",
                !is_first     ? ""
                : may_suggest ? "the log's column = what it is: time, an input or a sensor"
                              : "the log's column = what it is: time or an input",
                names);
    write_lines(writer, table + ".units",
                is_first ? "of columns whose heading has no unit, or one that cannot be read" : "", units);
}

void write_parameter(CaseWriter& writer, std::string_view effect, std::string_view key, std::string_view deviation,
                     std::string_view ground, std::string_view meaning) {
    writer.table("parameter");
    writer.entry("effect", effect);
    writer.entry("key", key, meaning);
    writer.entry("standard_deviation", deviation, fmt::format("assumed: {}", ground));
}

void write_log(CaseDraft& draft) {
    if (draft.log() == nullptr) {
        return;
    }
    const Log& log = *draft.log();
    if (log.use == LogUse::run) {
        write_run(draft, log);
        return;
    }
    if (log.use == LogUse::drive) {
        write_drive_file(draft, log);
    }
    suggest_run(draft, log);
}

}  // namespace tiretherm::input
