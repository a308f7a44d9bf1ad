// SPDX-License-Identifier: BSD-3-Clause
// Reads the columns of a log that are used, and leaves out those with too little in them.
#include "input/new_case/log_columns.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include <fmt/format.h>

#include "input/laps/file_laps.hpp"
#include "input/measurements/run_inputs.hpp"
#include "input/new_case/car_columns.hpp"
#include "input/new_case/column_classifier.hpp"
#include "physics/vehicle/vehicle.hpp"

namespace tiretherm::input {

namespace {

void drop(LogColumn& column, std::string reason) {
    column.reason = std::move(reason);
    column.must_ignore = column.heading.name == column.name;
    column.suggestion = column.name;
    column.suggested_unit = column.unit;
    column.unit.clear();
    column.name.clear();
    column.is_input = column.is_sensor = false;
}

/// Reads the used columns. @returns false after an error
bool read_values(DataFile& file, const std::vector<ColumnMeaning>& meanings, Log& log, InputErrors& errors) {
    std::vector<ColumnRequest> requests;
    std::vector<LogColumn*> targets;
    for (LogColumn& column : log.columns) {
        if (!column.is_used()) {
            continue;
        }
        if (!column.unit.empty()) {
            file.heads()[static_cast<std::size_t>(column.column)].heading.unit = column.unit;
        }
        const auto meaning = std::ranges::find(meanings, column.name, &ColumnMeaning::name);
        requests.push_back({.column = column.column,
                            .name = column.name,
                            .spec = meaning->spec,
                            .purpose = column.name == "time" ? Purpose::clock
                                       : meaning->any_unit   ? Purpose::unused
                                                             : Purpose::measured});
        targets.push_back(&column);
    }
    std::vector<std::vector<double>> values = file.read(requests, errors);
    for (std::size_t i = 0; i < values.size(); ++i) {
        (targets[i]->name == "time" ? log.time : targets[i]->value) = std::move(values[i]);
    }
    return !values.empty();
}

bool has_gap(const LogColumn& column) {
    return std::ranges::any_of(column.value, [](double v) { return std::isnan(v); });
}

/// Columns with too little in them are not used.
void drop_gaps(Log& log) {
    for (LogColumn& column : log.columns) {
        if (column.is_input) {
            if (const auto error = gap_error(column.name, log.time, column.value, "")) {
                drop(column, error->what);
            }
        } else if (column.is_sensor && !column.first_value()) {
            drop(column, fmt::format("{} has no value in the file", column.name));
        }
    }
}

/// A log without a sensor's column can still drive the case; [[drive.file]] reads CSV, units as the headings have them,
/// without a gap.
void choose_use(Log& log) {
    if (std::ranges::any_of(log.columns, &LogColumn::is_sensor)) {
        log.use = LogUse::run;
        return;
    }
    for (LogColumn& column : log.columns) {
        if (!column.corner.empty() && column.is_used()) {
            drop(column, "nothing is measured on the tires that it could be compared with");
        }
    }
    const LogColumn* time = log.find("time");
    const std::string whole = !log.is_text          ? "inputs without a measured temperature are read from CSV alone"
                              : !time->unit.empty() ? "the time has no unit that can be read: write \"time [s]\""
                                                    : "";
    for (LogColumn& column : log.columns) {
        if (column.is_input && !whole.empty()) {
            drop(column, whole);
        } else if (column.is_input && !column.unit.empty()) {
            drop(column,
                 fmt::format("[{}] is no unit of it: write [{}]", column.heading.unit.value_or(""), column.unit));
        } else if (column.is_input && has_gap(column)) {
            drop(column, fmt::format("{} has missing values", column.name));
        }
    }
    log.use = std::ranges::any_of(log.columns, &LogColumn::is_input) ? LogUse::drive : LogUse::nothing;
}

}  // namespace

std::string LogColumn::full_name() const {
    return name.empty() || corner.empty() ? name : fmt::format("{} of {}", name, corner);
}

std::string LogColumn::full_suggestion() const {
    return suggestion.empty() || corner.empty() ? suggestion : fmt::format("{} of {}", suggestion, corner);
}

std::string LogColumn::title() const {
    return heading.unit ? fmt::format("{} [{}]", heading.name, *heading.unit) : heading.name;
}

std::optional<double> LogColumn::first_value() const {
    const auto found = std::ranges::find_if(value, [](double v) { return !std::isnan(v); });
    return found == value.end() ? std::nullopt : std::optional(*found);
}

const LogColumn* Log::find(std::string_view name) const {
    const auto found = std::ranges::find(columns, name, &LogColumn::name);
    return found == columns.end() ? nullptr : &*found;
}

bool Log::has_motion() const {
    return std::ranges::any_of(columns, [](const LogColumn& column) { return is_motion(column.name); });
}

namespace {

template <typename Belongs>
std::vector<std::string> corners_with(const std::vector<LogColumn>& columns, Belongs belongs) {
    std::vector<std::string> found;
    for (const std::string_view corner : physics::corner_names) {
        if (std::ranges::any_of(columns,
                                [&](const LogColumn& column) { return column.corner == corner && belongs(column); })) {
            found.emplace_back(corner);
        }
    }
    return found;
}

}  // namespace

std::vector<std::string> Log::corners() const { return corners_with(columns, std::mem_fn(&LogColumn::is_used)); }

std::vector<std::string> Log::corners_measured() const {
    return corners_with(columns, std::mem_fn(&LogColumn::is_sensor));
}

std::optional<Log> read_log(const std::filesystem::path& path, const MeshTemplate& mesh, InputErrors& errors) {
    std::optional<DataFile> file = DataFile::open(path, {}, errors);
    if (!file) {
        return std::nullopt;
    }
    Log log{.path = path.generic_string(), .is_text = file->is_text()};
    LogMeaning meaning = meaning_of_columns(*file, mesh, errors);
    log.columns = std::move(meaning.columns);
    log.is_car = meaning.is_car;
    log.infrared_zones = meaning.infrared_zones;
    std::vector<int> used;
    for (const LogColumn& column : log.columns) {
        if (column.is_used()) {
            used.push_back(column.column);
        }
    }
    file->choose_rows(used);
    if (log.find("time") == nullptr) {
        errors.add(file->heads().front().place, "no column of the file is the time",
                   "call one time [s], as in time [s],speed [km/h]");
    }
    if (errors.count() > 0 || !read_values(*file, meaning.meanings, log, errors)) {
        return std::nullopt;
    }
    if (log.time.size() < 2) {
        errors.add({.file = file->number()}, "the file has a single sample: a run goes from one time to another");
        return std::nullopt;
    }
    drop_gaps(log);
    choose_use(log);
    log.laps = find_laps(*file, log.time, std::nullopt, true, errors);
    return log;
}

}  // namespace tiretherm::input
