// SPDX-License-Identifier: BSD-3-Clause
// Reads [[drive.file]]: the log of a data logger, with the same keys for its columns as [[run]], as input signals.

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "input/drive/drive_reader.hpp"
#include "input/drive/run_columns.hpp"
#include "input/drive/run_inputs.hpp"
#include "input/measurements/logged_signal.hpp"
#include "input/vehicle/vehicle_log.hpp"

namespace tiretherm::input {

bool DriveReader::leave_out_outranked(const TomlTable& table, const DataFile& file, RunColumns& columns) {
    InputErrors& errors = table.errors();
    const std::size_t before = errors.count();
    const auto place_of = [&](int column) { return file.heads()[static_cast<std::size_t>(column)].place; };
    const std::size_t not_taken = std::erase_if(columns.used, [&](const UsedColumn& column) {
        return overridden("file", column.name) ||
               !register_signal(column.name, place_of(column.column), table.place("path"), errors);
    });
    const std::size_t given_twice = errors.count() - before;
    std::erase_if(columns.followed, [&](const FollowedColumn& column) {
        const bool is_second = find_column(read_.signals.columns, column.name) != nullptr;
        if (is_second) {
            errors.add(place_of(column.column), fmt::format("a second column is called {}", column.name),
                       "ignore one of them");
        }
        return is_second;
    });
    return not_taken > given_twice;
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
    std::optional<DataFile> opened = DataFile::open(errors.beside(mentioned, *path), mentioned, errors);
    if (!opened) {
        return;
    }
    const std::size_t before = errors.count();
    RunColumns columns = classify_columns(*opened, keys, {}, followed_, errors);
    RunFile file{.file = std::move(*opened), .columns = std::move(columns)};
    for (const UsedColumn& column : file.columns.used) {
        static_cast<void>(keys.holds(column.name));  // which is known then
    }
    for (const FollowedColumn& column : file.columns.followed) {
        static_cast<void>(keys.holds(column.name));
    }
    keys.report_unknown_columns(errors);
    const bool outranked = leave_out_outranked(table, file.file, file.columns);
    const bool has_times = read_times(file, errors);
    file.last = file.time.size();
    if (has_times && file.columns.chosen().empty() && !outranked && errors.count() == before) {
        table.add_error("path", "no column of the file is an input",
                        "rename columns to inputs: columns = { V = \"speed\" }");
        return;
    }
    DrivingColumns driving = read_driving(file, keys, false, errors);
    if (!has_times) {
        return;
    }
    const std::vector<double>& time = file.time;
    if (std::ranges::any_of(followed_, is_vehicle_signal)) {
        read_.signals.course = course_over_ground(file.file, time, errors);
    }
    DrivenSpan& span = read_.span;
    span.logged_from = std::min(span.logged_from.value_or(time.front()), time.front());
    span.logged_to = std::max(span.logged_to.value_or(time.back()), time.back());
    if (!file.columns.chosen().empty()) {
        take_driven(time);
    }
    for (const MeasuredInput& input : driving.inputs) {
        add(input);
    }
    std::ranges::move(driving.followed, std::back_inserter(read_.signals.columns));
}

}  // namespace tiretherm::input
