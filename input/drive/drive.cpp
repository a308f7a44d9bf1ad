// SPDX-License-Identifier: BSD-3-Clause
// Reads [drive]: constant inputs, [[drive.schedule]] tables and [[drive.file]] logs; the file of a measured run takes
// precedence.

#include <algorithm>

#include <fmt/format.h>

#include "input/drive/drive_reader.hpp"
#include "input/tables/columns.hpp"
#include "input/text/quantity_specs.hpp"
#include "input/text/suggestions.hpp"
#include "input/text/word_lists.hpp"

namespace tiretherm::input {

namespace {

using physics::Signal;

/// Times of a schedule: ascending, where two equal ones are a jump.
bool are_in_order(const Column& column, const std::vector<double>& time, InputErrors& errors) {
    for (std::size_t i = 1; i < time.size(); ++i) {
        if (time[i] < time[i - 1]) {
            errors.add(column.cells[i]->place, "time goes backwards", "sort the rows by time");
            return false;
        }
        if (i > 1 && time[i] == time[i - 2]) {
            errors.add(column.cells[i]->place, "a third row at the same time", "a jump has two rows: before and after");
            return false;
        }
    }
    return true;
}

}  // namespace

void DriveReader::read_schedule(TomlTable& table) {
    InputErrors& errors = table.errors();
    const std::vector<Column> columns = read_columns(table);
    const auto is_time = [](const Column& column) { return column.heading.name == "time"; };
    const auto clock = std::find_if(columns.begin(), columns.end(), is_time);
    if (columns.empty()) {
        return;
    }
    if (clock == columns.end()) {
        table.add_error("columns", "a schedule needs a column time",
                        "write columns = [\"time [min]\", \"speed [km/h]\"]");
    }
    const std::vector<double> time =
        clock == columns.end() ? std::vector<double>{} : read_numbers(*clock, quantity_specs::moment, errors);
    const bool ordered = !time.empty() && are_in_order(*clock, time, errors);
    for (const Column& column : columns) {
        if (is_time(column)) {
            if (&column != &*clock) {
                errors.add(column.place, "a second column time", "remove one");
            }
            continue;
        }
        const Signal* signal = physics::find_signal(column.heading.name);
        if (signal == nullptr) {
            errors.add(column.place, fmt::format("\"{}\" is not an input", column.heading.name),
                       suggest(column.heading.name, names_of(physics::signals()), "inputs"));
            continue;
        }
        const bool is_overridden = overridden("schedule", signal->name);
        const bool is_new = !is_overridden && register_signal(signal->name, column.place, column.place, errors);
        std::vector<double> values = read_numbers(column, quantity_specs::of(*signal), errors);
        if (is_new && ordered && !values.empty()) {
            take_driven(time);
            read_.signals.inputs.add(
                solver::Series{.signal = signal, .time = time, .value = std::move(values), .logged = false});
        }
    }
}

void DriveReader::add(const MeasuredInput& input) {
    if (!input.value.empty()) {
        read_.signals.inputs.add(
            solver::Series{.signal = input.signal, .time = input.time, .value = input.value, .logged = true});
    }
}

void DriveReader::add_measured(InputErrors& errors) {
    for (const MeasuredInput& input : run_->inputs) {
        if (register_signal(input.signal->name, input.place, run_->place, errors)) {
            add(input);
        }
    }
    // Which inputs the file would have given is unknown: none of them is missing.
    if (run_->unreadable) {
        for (const Signal& signal : physics::signals()) {
            read_.signals.given.try_emplace(std::string(signal.name), run_->place);
        }
    }
}

bool RunInputs::says(std::string_view of_table, std::string_view key) const {
    return table != nullptr && table->find({of_table, key}) != nullptr;
}

bool RunInputs::overrides(std::string_view key, std::string_view signal) const {
    const bool given =
        std::ranges::any_of(inputs, [&](const MeasuredInput& input) { return input.signal->name == signal; });
    return given && !says("drive", key);
}

void DriveReader::take_driven(const std::vector<double>& time) {
    DrivenSpan& span = read_.span;
    span.from = std::min(span.from.value_or(time.front()), time.front());
    span.to = std::max(span.to.value_or(time.back()), time.back());
}

bool DriveReader::register_signal(std::string_view name, const SourceLocation& place, const SourceLocation& mentioned,
                                  InputErrors& errors) {
    const auto [known, is_new] = read_.signals.given.try_emplace(std::string(name), place);
    if (is_new) {
        return true;
    }
    const auto constant = std::ranges::find(constants_, name);
    if (constant != constants_.end() && known->second.file != mentioned.file) {
        if (known->second.file == case_file_) {  // which is laid over what it includes
            return false;
        }
        constants_.erase(constant);
        known->second = place;
        return true;
    }
    errors.add(place, fmt::format("{} is given twice, here and at {}", name, errors.spell(known->second)),
               known->second.file != mentioned.file && known->second.file != place.file
                   ? fmt::format("keep one of them; one that is included goes with unset = [\"drive.{}\"]", name)
                   : "keep one of them");
    return false;
}

DriveTable DriveReader::read(TomlTable& drive) && {
    std::vector<std::pair<const Signal*, double>> constants;
    for (const Signal& signal : physics::signals()) {
        const bool is_overridden = overridden(signal.name, signal.name);
        if (const auto value = drive.quantity(signal.name, quantity_specs::of(signal)); value && !is_overridden) {
            constants.emplace_back(&signal, *value);
        }
        if (drive.has(signal.name) && !is_overridden) {
            register_signal(signal.name, drive.place(signal.name), drive.place(signal.name), drive.errors());
            constants_.emplace_back(signal.name);
        }
    }
    drive.each("schedule", [&](TomlTable& table) { read_schedule(table); });
    drive.each("file", [&](TomlTable& table) { read_log(table); });
    // Behind all series: one of them may have taken the place of a constant.
    for (const auto& [signal, value] : constants) {
        if (std::ranges::find(constants_, signal->name) != constants_.end()) {
            read_.signals.inputs.add(*signal, value);
        }
    }
    if (run_ != nullptr) {
        add_measured(drive.errors());
        std::vector<UserColumn>& columns = read_.signals.columns;
        columns.insert(columns.begin(), run_->columns.begin(), run_->columns.end());
        if (!run_->course.course.time.empty()) {
            read_.signals.course = run_->course;
        }
    }
    return std::move(read_);
}

DriveTable read_drive(TomlTable& root, const RunInputs* run, const std::vector<std::string>& followed) {
    TomlTable drive = root.subtable("drive");
    return DriveReader(root.place().file, run, followed).read(drive);
}

}  // namespace tiretherm::input
