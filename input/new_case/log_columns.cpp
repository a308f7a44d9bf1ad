// SPDX-License-Identifier: BSD-3-Clause
// Classifies the columns of a log by their names and units, and reads those that are used.
#include "input/new_case/log_columns.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <fmt/format.h>

#include "input/measurements/run_inputs.hpp"
#include "input/new_case/case_writer.hpp"
#include "input/text/quantity_specs.hpp"
#include "input/text/suggestions.hpp"

namespace tiretherm::input {

namespace {

std::vector<ColumnMeaning> meanings_of(const MeshTemplate& mesh) {
    std::vector<ColumnMeaning> all{{.name = "time", .spec = quantity_specs::moment}};
    for (const physics::Signal& signal : physics::signals()) {
        all.push_back({.name = std::string(signal.name), .spec = quantity_specs::of(signal), .is_input = true});
    }
    for (const TemplateSensor& sensor : mesh.sensors) {
        all.push_back({.name = sensor.name, .spec = sensor.spec, .is_sensor = true});
    }
    return all;
}

/// Classifies the headings of one file.
class Classifier {
public:
    Classifier(DataFile& file, const MeshTemplate& mesh, InputErrors& errors)
        : file_(file), mesh_(mesh), meanings_(meanings_of(mesh)), errors_(errors) {}

    std::vector<LogColumn> columns() {
        const std::vector<ColumnHead>& heads = file_.heads();
        for (std::size_t i = 0; i < heads.size(); ++i) {
            columns_.push_back({.column = static_cast<int>(i), .heading = heads[i].heading, .name = {}});
        }
        refuse_duplicates();
        for (LogColumn& column : columns_) {
            if (heads[static_cast<std::size_t>(column.column)].is_clock) {
                take(column, meanings_.front());
            }
        }
        for (const bool exact : {true, false}) {
            for (LogColumn& column : columns_) {
                take_by_name(column, exact);
            }
        }
        take_time_by_unit();
        for (LogColumn& column : columns_) {
            suggest_for(column);
        }
        return std::move(columns_);
    }

private:
    /// Two columns of one name of the program would be one thing.
    void refuse_duplicates() {
        std::set<std::string> seen;
        for (const LogColumn& column : columns_) {
            const bool known =
                std::ranges::find(meanings_, column.heading.name, &ColumnMeaning::name) != meanings_.end();
            if (known && !seen.insert(column.heading.name).second) {
                errors_.add(file_.heads()[static_cast<std::size_t>(column.column)].place,
                            fmt::format("two columns are called {}", column.heading.name), "rename one in the file");
            }
        }
    }

    void take_by_name(LogColumn& column, bool exact) {
        const std::string& written = column.heading.name;
        if (column.is_used() || !column.reason.empty() || written.empty()) {
            return;
        }
        const auto meaning = std::ranges::find_if(meanings_, [&](const ColumnMeaning& m) {
            return exact ? m.name == written : bare_name(m.name) == bare_name(written);
        });
        if (meaning == meanings_.end() || taken_.contains(meaning->name)) {
            return;
        }
        if (!is_printable(written)) {
            column.reason = "its name is not UTF-8: save the file as UTF-8";
            return;
        }
        take(column, *meaning);
    }

    /// Uses a column, unless nobody can tell its unit.
    void take(LogColumn& column, const ColumnMeaning& meaning) {
        const UnitRead read = read_heading_unit(column.heading, meaning.spec);
        if (read.error) {
            // A time without unit counts seconds in nearly every log.
            const bool bare_time = meaning.name == "time" && trim(column.heading.unit.value_or("")).empty();
            column.unit = bare_time ? "s" : guess_unit(column.heading.unit.value_or(""), meaning.spec);
        }
        if (read.error && column.unit.empty()) {
            column.reason = read.error->what;
            column.suggestion = meaning.name;
            column.suggested_unit = usual_unit(meaning.spec);
            column.must_ignore = column.heading.name == meaning.name;
            return;
        }
        column.name = meaning.name;
        column.is_input = meaning.is_input;
        column.is_sensor = meaning.is_sensor;
        taken_.insert(meaning.name);
    }

    /// Where no column is called time, the only one in a unit of time.
    void take_time_by_unit() {
        const auto in_time = [](const LogColumn& column) {
            return !column.is_used() && column.heading.unit && !trim(*column.heading.unit).empty() &&
                   is_printable(column.heading.name) && !column.heading.name.empty() &&
                   !read_heading_unit(column.heading, quantity_specs::moment).error;
        };
        if (!taken_.contains("time") && std::ranges::count_if(columns_, in_time) == 1) {
            take(*std::ranges::find_if(columns_, in_time), meanings_.front());
        }
    }

    void suggest_for(LogColumn& column) {
        if (column.is_used() || !column.reason.empty() || column.heading.name.empty()) {
            return;
        }
        if (const std::string elsewhere = mesh_with(column.heading.name); !elsewhere.empty()) {
            column.reason = fmt::format("the mesh {} has no place for it, --mesh {} has", mesh_.name, elsewhere);
            return;
        }
        std::vector<ColumnMeaning> free;
        std::ranges::copy_if(meanings_, std::back_inserter(free),
                             [&](const ColumnMeaning& m) { return !taken_.contains(m.name); });
        const ColumnMeaning* guess = is_printable(column.heading.name) ? guess_meaning(column.heading, free) : nullptr;
        column.reason = "not a standard name";
        if (guess != nullptr) {
            column.suggestion = guess->name;
            if (read_heading_unit(column.heading, guess->spec).error) {
                const std::string unit = guess_unit(column.heading.unit.value_or(""), guess->spec);
                column.suggested_unit = unit.empty() ? usual_unit(guess->spec) : unit;
            }
        }
    }

    /// Another mesh that has a sensor of this name; empty: none.
    [[nodiscard]] std::string mesh_with(const std::string& heading) const {
        for (const std::string_view name : mesh_template_names()) {
            const MeshTemplate other = mesh_template(name, 0.0);
            if (name != mesh_.name && std::ranges::any_of(other.sensors, [&](const TemplateSensor& sensor) {
                    return bare_name(sensor.name) == bare_name(heading);
                })) {
                return other.name;
            }
        }
        return {};
    }

    DataFile& file_;
    const MeshTemplate& mesh_;
    std::vector<ColumnMeaning> meanings_;
    InputErrors& errors_;
    std::vector<LogColumn> columns_;
    std::set<std::string> taken_;
};

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
                            .purpose = column.name == "time" ? Purpose::clock : Purpose::measured});
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

std::optional<Log> read_log(const std::filesystem::path& path, const MeshTemplate& mesh, InputErrors& errors) {
    std::optional<DataFile> file = DataFile::open(path, {}, errors);
    if (!file) {
        return std::nullopt;
    }
    Log log{.path = path.generic_string(), .is_text = file->is_text()};
    log.columns = Classifier(*file, mesh, errors).columns();
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
    if (errors.count() > 0 || !read_values(*file, meanings_of(mesh), log, errors)) {
        return std::nullopt;
    }
    if (log.time.size() < 2) {
        errors.add({.file = file->number()}, "the file has a single sample: a run goes from one time to another");
        return std::nullopt;
    }
    drop_gaps(log);
    choose_use(log);
    return log;
}

}  // namespace tiretherm::input
