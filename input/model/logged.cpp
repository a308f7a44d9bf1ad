// SPDX-License-Identifier: BSD-3-Clause
// Reads [[drive.file]]: the log of a data logger, with the keys `columns`, `units` and `ignore`, as input signals.

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

#include <fmt/format.h>

#include "input/loggers/logger_units.hpp"
#include "input/measurements/dead_stretches.hpp"
#include "input/measurements/run_inputs.hpp"
#include "input/model/problem_builder.hpp"
#include "input/tables/data_file.hpp"
#include "input/text/quantity_specs.hpp"
#include "input/text/suggestions.hpp"
#include "input/vehicle/dead_channels.hpp"

namespace tiretherm::input {

namespace {

namespace fs = std::filesystem;
using physics::Signal;

/// The column that a key names, -1 after an error.
int find_column(const Entry& key, const DataFile& file, InputErrors& errors) {
    const int column = file.find(key.key);
    if (column < 0) {
        std::vector<std::string> known;
        for (const ColumnHead& head : file.heads()) {
            known.push_back(head.heading.name);
        }
        errors.add(key.place, fmt::format("the file has no column \"{}\"", key.key),
                   suggest(key.key, known, "columns"));
    }
    return column;
}

/// Puts the units that the case gives into the headings: `units = { V = "km/h" }`.
void take_units(TomlTable& table, DataFile& file) {
    TomlTable units = table.subtable("units");
    for (const Entry& entry : units.content().entries) {
        const std::optional<std::string> unit = units.text(entry.key);
        if (const int column = find_column(entry, file, table.errors()); column >= 0 && unit) {
            ColumnHead& head = file.heads()[static_cast<std::size_t>(column)];
            head.heading.unit = *unit;
            head.unit_place = entry.value.place;
        }
    }
}

/// Which heading of the file stands for which name: `columns = { V = "speed" }`; without it a heading is its own name.
std::map<std::string, LocatedString> read_names(TomlTable& table, const DataFile& file,
                                                const std::vector<std::string>& followed) {
    std::map<std::string, LocatedString> names;
    TomlTable renamed = table.subtable("columns");
    for (const Entry& entry : renamed.content().entries) {
        const std::optional<std::string> name = renamed.text(entry.key);
        if (find_column(entry, file, table.errors()) < 0) {
            continue;
        }
        if (name && *name != "time" && physics::find_signal(*name) == nullptr &&
            std::ranges::find(followed, *name) == followed.end()) {
            std::vector<std::string> inputs = names_of(physics::signals());
            inputs.emplace_back("time");
            renamed.add_error(entry.key, fmt::format("\"{}\" is not an input", *name),
                              suggest(*name, inputs, "inputs"));
        } else if (name) {
            names[entry.key] = {*name, entry.value.place};
        }
    }
    return names;
}

/// The columns of the file that are inputs, the time first.
/// @param outranked out, how many inputs a measured run's file gives instead
std::vector<ColumnRequest> requests(TomlTable& table, const DataFile& file, ProblemBuilder& builder, int& overridden) {
    InputErrors& errors = table.errors();
    const std::map<std::string, LocatedString> renamed = read_names(table, file, builder.followed);
    const std::vector<LocatedString> ignored = table.texts("ignore");
    std::vector<ColumnRequest> found{
        {.column = -1, .name = "time", .spec = quantity_specs::moment, .purpose = Purpose::clock}};
    const bool has_time = std::ranges::any_of(renamed, [](const auto& entry) { return entry.second.text == "time"; });
    builder.columns.reserve(builder.columns.size() + file.heads().size());  // requests look into it
    for (std::size_t i = 0; i < file.heads().size(); ++i) {
        const ColumnHead& head = file.heads()[i];
        const auto entry = renamed.find(head.heading.name);
        const std::string own = head.is_clock && !has_time ? "time" : head.heading.name;
        const std::string name = entry == renamed.end() ? own : entry->second.text;
        const bool skipped = std::any_of(ignored.begin(), ignored.end(),
                                         [&](const LocatedString& word) { return word.text == head.heading.name; });
        const Signal* signal = physics::find_signal(name);
        const bool followed =
            signal == nullptr && std::ranges::find(builder.followed, name) != builder.followed.end() && name != "time";
        if (skipped || (signal == nullptr && name != "time" && !followed)) {
            continue;
        }
        if (followed) {
            const auto duplicate = std::ranges::find(builder.columns, name, &UserColumn::name);
            if (duplicate != builder.columns.end()) {
                errors.add(head.place, fmt::format("a second column is called {}", name), "ignore one of them");
                continue;
            }
            // Its own unit says what its numbers are.
            MeantUnit unit = meant_unit_by_name(head.heading.name, head.heading.unit.value_or(""));
            if (unit.error) {
                errors.add(head.unit_place.file >= 0 ? head.unit_place : head.place, std::move(*unit.error));
                continue;
            }
            const auto base = base_unit(head.heading.unit ? std::optional(unit.unit) : std::nullopt);
            builder.columns.push_back({.name = name, .unit = base, .signal = {}});
            found.push_back({.column = static_cast<int>(i),
                             .name = name,
                             .spec = {.unit = builder.columns.back().unit},
                             .purpose = Purpose::measured});
            continue;
        }
        if (name == "time") {
            if (found.front().column >= 0) {
                errors.add(head.place, "a second column time", "rename or ignore one");
            }
            found.front().column = static_cast<int>(i);
        } else if (builder.overridden("file", name)) {
            ++overridden;
        } else {
            const std::size_t before = errors.count();
            if (register_signal(name, head.place, table.place("path"), builder, errors)) {
                found.push_back({.column = static_cast<int>(i),
                                 .name = name,
                                 .spec = quantity_specs::of(*signal),
                                 .purpose = Purpose::measured});
            } else if (errors.count() == before) {
                ++overridden;  // by a constant of the case itself
            }
        }
    }
    for (const LocatedString& word : ignored) {
        if (file.find(word.text) < 0) {
            std::vector<std::string> known;
            std::ranges::transform(file.heads(), std::back_inserter(known),
                                   [](const ColumnHead& head) { return head.heading.name; });
            errors.add(word.place, fmt::format("the file has no column \"{}\"", word.text),
                       suggest(word.text, known, "columns"));
        }
    }
    return found;
}

}  // namespace

void read_logged(TomlTable& table, ProblemBuilder& builder) {
    InputErrors& errors = table.errors();
    const std::optional<std::string> path = table.text("path");
    table.declare_keys({"columns", "units", "ignore", "hold"});
    if (!path) {
        return;
    }
    const SourceLocation mentioned = table.place("path");
    const fs::path beside = fs::path(errors.file(mentioned.file)).parent_path();
    std::optional<DataFile> file = DataFile::open((beside / *path).lexically_normal(), mentioned, errors);
    if (!file) {
        return;
    }
    const std::size_t before = errors.count();
    int overridden = 0;
    take_units(table, *file);
    const std::vector<ColumnRequest> requested_columns = requests(table, *file, builder, overridden);
    if (requested_columns.front().column < 0) {
        errors.add(file->heads().front().place, "the file has no column time [s]",
                   "rename one: columns = { t = \"time\" }");
        return;
    }
    if (requested_columns.size() == 1 && overridden == 0 && errors.count() == before) {
        table.add_error("path", "no column of the file is an input",
                        "rename columns to inputs: columns = { V = \"speed\" }");
        return;
    }
    std::vector<int> columns;
    std::ranges::transform(requested_columns, std::back_inserter(columns), &ColumnRequest::column);
    file->choose_rows(columns);
    std::vector<std::vector<double>> values = file->read(requested_columns, errors);
    if (values.empty()) {
        return;
    }
    const std::vector<LocatedString> hold = table.texts("hold");
    for (const LocatedString& word : hold) {
        if (std::ranges::find(requested_columns, word.text, &ColumnRequest::name) == requested_columns.end()) {
            errors.add(word.place, fmt::format("hold: no column of the file is the input \"{}\"", word.text),
                       "name an input as the model calls it");
        }
    }
    const std::vector<double> time = std::move(values.front());
    if (std::ranges::any_of(builder.followed, is_vehicle_signal)) {
        builder.course = course_over_ground(*file, time, errors);
    }
    builder.logged_from = std::min(builder.logged_from.value_or(time.front()), time.front());
    builder.logged_to = std::max(builder.logged_to.value_or(time.back()), time.back());
    if (values.size() > 1) {
        builder.take_driven(time);
    }
    for (std::size_t i = 1; i < values.size(); ++i) {
        const std::string& name = requested_columns[i].name;
        const SourceLocation& place = file->heads()[static_cast<std::size_t>(requested_columns[i].column)].place;
        if (const std::string dead = remove_dead(time, values[i], requested_columns[i].spec.unit); !dead.empty()) {
            errors.warn(place, fmt::format("{} {}: left out", name, dead));
        }
        if (!judge_gaps(name, time, values[i],
                        {.place = place, .elsewhere = fmt::format("ignore the column and give {} in [drive]", name)},
                        errors)) {
            continue;
        }
        solver::SignalHistory known = known_samples(time, values[i]);
        if (std::ranges::find(hold, name, &LocatedString::text) != hold.end()) {
            known = held(known);
        }
        if (physics::find_signal(name) == nullptr) {
            UserColumn& column = *std::ranges::find(builder.columns, name, &UserColumn::name);
            column.signal = std::move(known);
            column.beside = live_column_beside(*file, requested_columns[i].column, column, time, errors);
            continue;
        }
        builder.problem.input_signals.add(solver::Series{.signal = physics::find_signal(name),
                                                         .time = std::move(known.time),
                                                         .value = std::move(known.value),
                                                         .logged = true});
    }
}

}  // namespace tiretherm::input
