// SPDX-License-Identifier: BSD-3-Clause
// Reads [drive]: constant inputs, [[drive.schedule]] tables and [[drive.file]] logs; the file of a measured run takes
// precedence.

#include <algorithm>

#include <fmt/format.h>

#include "input/model/problem_builder.hpp"
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

void read_schedule(TomlTable& table, ProblemBuilder& builder) {
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
        const bool overridden = builder.overridden("schedule", signal->name);
        const bool is_new = !overridden && register_signal(signal->name, column.place, column.place, builder, errors);
        std::vector<double> values = read_numbers(column, quantity_specs::of(*signal), errors);
        if (is_new && ordered && !values.empty()) {
            builder.take_driven(time);
            builder.problem.input_signals.add(
                solver::Series{.signal = signal, .time = time, .value = std::move(values), .logged = false});
        }
    }
}

/// The inputs that a measured run's file gives.
void add_measured(const RunInputs& run, ProblemBuilder& builder, InputErrors& errors) {
    for (const MeasuredInput& input : run.inputs) {
        if (register_signal(input.signal->name, input.place, run.place, builder, errors) && !input.value.empty()) {
            builder.problem.input_signals.add(
                solver::Series{.signal = input.signal, .time = input.time, .value = input.value, .logged = true});
        }
    }
    if (run.unreadable) {
        for (const Signal& signal : physics::signals()) {
            builder.given.try_emplace(std::string(signal.name), run.place);
        }
    }
}

}  // namespace

bool RunInputs::says(std::string_view of_table, std::string_view key) const {
    const TomlValue* own = table != nullptr ? table->find(of_table) : nullptr;
    return own != nullptr && own->find(key) != nullptr;
}

bool RunInputs::overrides(std::string_view key, std::string_view signal) const {
    const bool given =
        std::ranges::any_of(inputs, [&](const MeasuredInput& input) { return input.signal->name == signal; });
    return given && !says("drive", key);
}

bool register_signal(std::string_view name, const SourceLocation& place, const SourceLocation& mentioned,
                     ProblemBuilder& builder, InputErrors& errors) {
    const auto [known, is_new] = builder.given.try_emplace(std::string(name), place);
    if (is_new) {
        return true;
    }
    const auto constant = std::ranges::find(builder.constants, name);
    if (constant != builder.constants.end() && known->second.file != mentioned.file) {
        if (known->second.file == builder.case_file) {  // which is laid over what it includes
            return false;
        }
        builder.constants.erase(constant);
        known->second = place;
        return true;
    }
    errors.add(place, fmt::format("{} is given twice, here and at {}", name, errors.spell(known->second)),
               known->second.file != mentioned.file && known->second.file != place.file
                   ? fmt::format("keep one of them; one that is included goes with unset = [\"drive.{}\"]", name)
                   : "keep one of them");
    return false;
}

void read_drive(TomlTable& root, ProblemBuilder& builder) {
    TomlTable drive = root.subtable("drive");
    std::vector<std::pair<const Signal*, double>> constants;
    for (const Signal& signal : physics::signals()) {
        const bool overridden = builder.overridden(signal.name, signal.name);
        if (const auto value = drive.quantity(signal.name, quantity_specs::of(signal)); value && !overridden) {
            constants.emplace_back(&signal, *value);
        }
        if (drive.has(signal.name) && !overridden) {
            register_signal(signal.name, drive.place(signal.name), drive.place(signal.name), builder, drive.errors());
            builder.constants.emplace_back(signal.name);
        }
    }
    drive.each("schedule", [&](TomlTable& table) { read_schedule(table, builder); });
    drive.each("file", [&](TomlTable& table) { read_logged(table, builder); });
    for (const auto& [signal, value] : constants) {
        if (std::ranges::find(builder.constants, signal->name) != builder.constants.end()) {
            builder.problem.input_signals.add(*signal, value);
        }
    }
    if (builder.run) {
        add_measured(*builder.run, builder, drive.errors());
    }
}

}  // namespace tiretherm::input
