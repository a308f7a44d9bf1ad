// SPDX-License-Identifier: BSD-3-Clause
// Reads [[drive.file]]: the CSV log of a data logger, with the keys `columns` and `ignore`, as input signals.

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "input/measurements/run_inputs.hpp"
#include "input/model/problem_builder.hpp"
#include "input/tables/csv.hpp"
#include "input/text/quantity_specs.hpp"
#include "input/text/suggestions.hpp"

namespace tiretherm::input {

namespace {

namespace fs = std::filesystem;
using physics::Signal;

/// Which heading of the file stands for which name: `columns = { V = "speed" }`; without it a heading is its own name.
std::map<std::string, LocatedString> read_names(TomlTable& table, const Csv& csv,
                                                const std::vector<std::string>& followed) {
    std::map<std::string, LocatedString> names;
    TomlTable renamed = table.subtable("columns");
    std::vector<std::string> known;
    for (const ColumnHead& head : csv.heads()) {
        known.push_back(head.heading.name);
    }
    for (const Entry& entry : renamed.content().entries) {
        const std::optional<std::string> name = renamed.text(entry.key);
        if (csv.find(entry.key) < 0) {
            table.errors().add(entry.place, fmt::format("the file has no column \"{}\"", entry.key),
                               suggest(entry.key, known, "columns"));
        } else if (name && *name != "time" && physics::find_signal(*name) == nullptr &&
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
std::vector<ColumnRequest> requests(TomlTable& table, const Csv& csv, ProblemBuilder& builder, int& overridden) {
    InputErrors& errors = table.errors();
    const std::map<std::string, LocatedString> renamed = read_names(table, csv, builder.followed);
    const std::vector<LocatedString> ignored = table.texts("ignore");
    std::vector<ColumnRequest> found{
        {.column = -1, .name = "time", .spec = quantity_specs::moment, .purpose = Purpose::clock}};
    builder.columns.reserve(builder.columns.size() + csv.heads().size());  // requests look into it
    for (std::size_t i = 0; i < csv.heads().size(); ++i) {
        const ColumnHead& head = csv.heads()[i];
        const auto entry = renamed.find(head.heading.name);
        const std::string name = entry == renamed.end() ? head.heading.name : entry->second.text;
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
            builder.columns.push_back({.name = name, .unit = base_unit(head.heading.unit), .signal = {}});
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
                found.push_back({.column = static_cast<int>(i), .name = name, .spec = quantity_specs::of(*signal)});
            } else if (errors.count() == before) {
                ++overridden;  // by a constant of the case itself
            }
        }
    }
    for (const LocatedString& word : ignored) {
        if (csv.find(word.text) < 0) {
            errors.add(word.place, fmt::format("the file has no column \"{}\"", word.text));
        }
    }
    return found;
}

}  // namespace

void read_logged(TomlTable& table, ProblemBuilder& builder) {
    InputErrors& errors = table.errors();
    const std::optional<std::string> path = table.text("path", Need::required);
    table.declare_keys({"columns", "ignore", "hold"});
    if (!path) {
        return;
    }
    const SourceLocation mentioned = table.place("path");
    const fs::path beside = fs::path(errors.file(mentioned.file)).parent_path();
    const std::optional<TextFile> file = read_text((beside / *path).lexically_normal(), mentioned, errors);
    const std::optional<Csv> csv = file ? Csv::open(*file, errors) : std::nullopt;
    if (!csv) {
        return;
    }
    const std::size_t before = errors.count();
    int overridden = 0;
    const std::vector<ColumnRequest> requested_columns = requests(table, *csv, builder, overridden);
    if (requested_columns.front().column < 0) {
        errors.add(csv->heads().front().place, "the file has no column time [s]",
                   "rename one: columns = { t = \"time\" }");
        return;
    }
    if (requested_columns.size() == 1 && overridden == 0 && errors.count() == before) {
        table.add_error("path", "no column of the file is an input",
                        "rename columns to inputs: columns = { V = \"speed\" }");
        return;
    }
    std::vector<std::vector<double>> values = csv->read(requested_columns, errors);
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
    builder.logged_from = std::min(builder.logged_from.value_or(time.front()), time.front());
    builder.logged_to = std::max(builder.logged_to.value_or(time.back()), time.back());
    for (std::size_t i = 1; i < values.size(); ++i) {
        const std::string& name = requested_columns[i].name;
        solver::SignalHistory known = known_samples(time, values[i]);
        if (std::ranges::find(hold, name, &LocatedString::text) != hold.end()) {
            known = held(known);
        }
        if (requested_columns[i].purpose == Purpose::measured) {
            std::ranges::find(builder.columns, name, &UserColumn::name)->signal = std::move(known);
            continue;
        }
        builder.problem.input_signals.add(solver::Series{.signal = physics::find_signal(name),
                                                         .time = std::move(known.time),
                                                         .value = std::move(known.value),
                                                         .logged = true});
    }
}

}  // namespace tiretherm::input
