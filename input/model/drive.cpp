#include <algorithm>

#include <fmt/format.h>

#include "input/tables/columns.hpp"
#include "input/model/draft.hpp"
#include "input/text/wanted.hpp"
#include "input/text/words.hpp"

namespace tiretherm::input {

namespace {

using physics::Signal;

/// Times of a schedule: ascending, where two equal ones are a jump.
bool are_in_order(const Column& column, const std::vector<double>& time, Mistakes& mistakes) {
    for (std::size_t i = 1; i < time.size(); ++i) {
        if (time[i] < time[i - 1]) {
            mistakes.add(column.cells[i]->place, "time goes backwards", "sort the rows by time");
            return false;
        }
        if (i > 1 && time[i] == time[i - 2]) {
            mistakes.add(column.cells[i]->place, "a third row at the same time",
                         "a jump has two rows: before and after");
            return false;
        }
    }
    return true;
}

void read_schedule(Section& section, Draft& draft) {
    Mistakes& mistakes = section.mistakes();
    const std::vector<Column> columns = read_columns(section);
    const auto is_time = [](const Column& column) { return column.heading.name == "time"; };
    const auto clock = std::find_if(columns.begin(), columns.end(), is_time);
    if (columns.empty()) {
        return;
    }
    if (clock == columns.end()) {
        section.mistake("columns", "a schedule needs a column time",
                        "write columns = [\"time [min]\", \"speed [km/h]\"]");
    }
    const std::vector<double> time =
        clock == columns.end() ? std::vector<double>{} : read_numbers(*clock, wanted::moment, mistakes);
    const bool ordered = !time.empty() && are_in_order(*clock, time, mistakes);
    for (const Column& column : columns) {
        if (is_time(column)) {
            if (&column != &*clock) {
                mistakes.add(column.place, "a second column time", "remove one");
            }
            continue;
        }
        const Signal* signal = physics::find_signal(column.heading.name);
        if (signal == nullptr) {
            mistakes.add(column.place, fmt::format("\"{}\" is not an input", column.heading.name),
                         suggest(column.heading.name, names_of(physics::signals()), "inputs"));
            continue;
        }
        const bool outranked = draft.outranked("schedule", signal->name);
        const bool is_new = !outranked && claim_signal(signal->name, column.place, draft, mistakes);
        std::vector<double> values = read_numbers(column, wanted::of(*signal), mistakes);
        if (is_new && ordered && !values.empty()) {
            draft.problem.drive.add(
                solver::Series{.signal = signal, .time = time, .value = std::move(values), .logged = false});
        }
    }
}

/// The inputs that a measured run's file gives.
void add_measured(const RunInputs& run, Draft& draft, Mistakes& mistakes) {
    for (const MeasuredInput& input : run.inputs) {
        if (claim_signal(input.signal->name, input.place, draft, mistakes) && !input.value.empty()) {
            draft.problem.drive.add(
                solver::Series{.signal = input.signal, .time = input.time, .value = input.value, .logged = true});
        }
    }
    if (run.unreadable) {
        for (const Signal& signal : physics::signals()) {
            draft.given.try_emplace(std::string(signal.name), run.place);
        }
    }
}

}  // namespace

bool RunInputs::says(std::string_view of_table, std::string_view key) const {
    const Node* own = table != nullptr ? table->find(of_table) : nullptr;
    return own != nullptr && own->find(key) != nullptr;
}

bool RunInputs::outranks(std::string_view key, std::string_view signal) const {
    const bool given =
        std::ranges::any_of(inputs, [&](const MeasuredInput& input) { return input.signal->name == signal; });
    return given && !says("drive", key);
}

bool claim_signal(std::string_view name, const Place& place, Draft& draft, Mistakes& mistakes) {
    const auto [known, is_new] = draft.given.try_emplace(std::string(name), place);
    if (!is_new) {
        mistakes.add(place, fmt::format("{} is given twice, here and at {}", name, mistakes.spell(known->second)),
                     "keep one of them");
    }
    return is_new;
}

void read_drive(Section& root, Draft& draft) {
    Section drive = root.section("drive");
    for (const Signal& signal : physics::signals()) {
        const bool outranked = draft.outranked(signal.name, signal.name);
        if (const auto value = drive.quantity(signal.name, wanted::of(signal)); value && !outranked) {
            draft.problem.drive.add(signal, *value);
        }
        if (drive.has(signal.name) && !outranked) {
            claim_signal(signal.name, drive.place(signal.name), draft, drive.mistakes());
        }
    }
    drive.each("schedule", [&](Section& section) { read_schedule(section, draft); });
    drive.each("file", [&](Section& section) { read_logged(section, draft); });
    if (draft.run) {
        add_measured(*draft.run, draft, drive.mistakes());
    }
}

}  // namespace tiretherm::input
