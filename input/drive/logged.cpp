// SPDX-License-Identifier: BSD-3-Clause
// Reads [[drive.file]]: the log of a data logger, with the same keys for its columns as [[run]], as input signals.

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "input/drive/drive_reader.hpp"
#include "input/drive/run_columns.hpp"
#include "input/drive/run_inputs.hpp"
#include "input/measurements/dead_stretches.hpp"
#include "input/measurements/logged_signal.hpp"
#include "input/tables/data_file.hpp"
#include "input/text/quantity_specs.hpp"
#include "input/vehicle/dead_channels.hpp"

namespace tiretherm::input {

namespace fs = std::filesystem;

std::vector<ColumnRequest> DriveReader::requests(const TomlTable& table, const DataFile& file,
                                                 const RunColumns& columns, bool& outranked) {
    InputErrors& errors = table.errors();
    std::vector<ColumnRequest> found{file.request(columns.time, "time", quantity_specs::moment, Purpose::clock)};
    const auto place_of = [&](int column) { return file.heads()[static_cast<std::size_t>(column)].place; };
    for (const auto& [column, name, input, is_sensor] : columns.used) {
        const std::size_t before = errors.count();
        if (!overridden("file", name) && register_signal(name, place_of(column), table.place("path"), errors)) {
            found.push_back(file.request(column, name, quantity_specs::of(*input)));
        } else {
            outranked = outranked || errors.count() == before;
        }
    }
    read_.signals.columns.reserve(read_.signals.columns.size() + columns.followed.size());  // requests look into it
    for (const auto& [column, name] : columns.followed) {
        if (std::ranges::find(read_.signals.columns, name, &UserColumn::name) != read_.signals.columns.end()) {
            errors.add(place_of(column), fmt::format("a second column is called {}", name), "ignore one of them");
            continue;
        }
        // Its own unit says what its numbers are.
        const Heading& heading = file.heads()[static_cast<std::size_t>(column)].heading;
        read_.signals.columns.push_back({.name = name, .unit = base_unit(heading.unit), .signal = {}});
        found.push_back(file.request(column, name, {.unit = read_.signals.columns.back().unit}));
    }
    return found;
}

void DriveReader::read_log(TomlTable& table) {
    InputErrors& errors = table.errors();
    const std::optional<std::string> path = table.text("path");
    ColumnKeys keys;
    keys.read(table);
    if (!path) {
        return;
    }
    const SourceLocation mentioned = table.place("path");
    std::optional<DataFile> file = DataFile::open(errors.beside(mentioned, *path), mentioned, errors);
    if (!file) {
        return;
    }
    const std::size_t before = errors.count();
    const RunColumns columns = classify_columns(*file, keys, {}, followed_, errors);
    for (const UsedColumn& column : columns.used) {
        static_cast<void>(keys.holds(column.name));  // which is known then
    }
    for (const FollowedColumn& column : columns.followed) {
        static_cast<void>(keys.holds(column.name));
    }
    keys.report_unknown_columns(errors);
    if (columns.time < 0) {
        errors.add(file->heads().front().place, "the file has no column time [s]",
                   "rename one: columns = { t = \"time\" }");
        return;
    }
    bool outranked = false;
    const std::vector<ColumnRequest> requested = requests(table, *file, columns, outranked);
    if (requested.size() == 1 && !outranked && errors.count() == before) {
        table.add_error("path", "no column of the file is an input",
                        "rename columns to inputs: columns = { V = \"speed\" }");
        return;
    }
    std::vector<int> rows;
    std::ranges::transform(requested, std::back_inserter(rows), &ColumnRequest::column);
    file->choose_rows(rows);
    std::vector<std::vector<double>> values = file->read(requested, errors);
    if (values.empty()) {
        return;
    }
    const solver::SharedSamples time = std::move(values.front());
    if (std::ranges::any_of(followed_, is_vehicle_signal)) {
        read_.signals.course = course_over_ground(*file, time, errors);
    }
    DrivenSpan& span = read_.span;
    span.logged_from = std::min(span.logged_from.value_or(time.front()), time.front());
    span.logged_to = std::max(span.logged_to.value_or(time.back()), time.back());
    if (values.size() > 1) {
        take_driven(time);
    }
    for (std::size_t i = 1; i < values.size(); ++i) {
        take_column(*file, requested[i], keys, time, values[i], errors);
    }
}

void DriveReader::take_column(const DataFile& file, const ColumnRequest& column, ColumnKeys& keys,
                              const solver::SharedSamples& time, std::vector<double>& value, InputErrors& errors) {
    const std::string& name = column.name;
    const SourceLocation& place = file.heads()[static_cast<std::size_t>(column.column)].place;
    leave_out_dead(column, place, keys, time, value, errors);
    const auto found = driving_samples(
        {.name = name, .time = time, .value = std::move(value), .holds = keys.holds(name), .before = {}},
        {.place = place, .elsewhere = fmt::format("ignore the column and give {} in [drive]", name)}, errors);
    if (!found) {
        return;
    }
    if (const physics::Signal* signal = physics::find_signal(name)) {
        read_.signals.inputs.add(
            solver::Series{.signal = signal, .time = found->time, .value = found->value, .logged = true});
    } else {
        UserColumn& own = *std::ranges::find(read_.signals.columns, name, &UserColumn::name);
        own.signal = {.time = found->time, .value = found->value};
        own.beside = live_column_beside(file, column.column, own, time, errors);
    }
}

}  // namespace tiretherm::input
