// SPDX-License-Identifier: BSD-3-Clause
// Reads manoeuvres by the reader of [drive].

#include "input/runs/possible_manoeuvres.hpp"

#include <algorithm>
#include <cassert>

#include <fmt/format.h>

#include "input/case_text/shipped_cases.hpp"
#include "input/drive/drive.hpp"

namespace tiretherm::input {

namespace {

constexpr const char* shipped = "manoeuvres.toml";

void read_manoeuvre(TomlTable& table, std::vector<Manoeuvre>& into) {
    const std::optional<std::string> name = table.text("name");
    const std::vector<LocatedString> of_largest = table.texts("of_largest");
    const std::size_t before = table.errors().count();
    DriveTable drive = read_drive(table, nullptr, {});
    if (table.errors().count() > before || !name) {
        return;
    }
    if (!drive.span.from || *drive.span.to <= *drive.span.from) {
        table.add_error("drive", fmt::format("how long \"{}\" takes is not known", *name),
                        "give it a schedule or a file: drive = { schedule = [{ columns = [\"time [min]\", \"speed "
                        "[km/h]\"], rows = [[0, 150], [20, 150]] }] }");
        return;
    }
    if (std::ranges::find(into, *name, &Manoeuvre::name) != into.end()) {
        table.add_error("name", fmt::format("a second manoeuvre is called \"{}\"", *name), "give each its own name");
        return;
    }
    Manoeuvre manoeuvre{
        .name = *name, .inputs = std::move(drive.signals.inputs), .start = *drive.span.from, .end = *drive.span.to};
    for (const LocatedString& word : of_largest) {
        if (drive.signals.given.contains(word.text)) {
            manoeuvre.of_largest.push_back(word.text);
        } else {
            table.errors().add(word.place, fmt::format("\"{}\" is no input of this manoeuvre", word.text),
                               "give it in drive, or leave it out here");
        }
    }
    into.push_back(std::move(manoeuvre));
}

std::vector<Manoeuvre> read_list(const TomlValue& document, InputErrors& errors) {
    TomlTable root(document, "the case", errors);
    root.allow_unknown_keys();  // they have been reported
    TomlTable table = root.subtable("diagnose");
    table.allow_unknown_keys();
    std::vector<Manoeuvre> possible;
    table.each("possible", [&](TomlTable& one) { read_manoeuvre(one, possible); });
    return possible;
}

std::vector<Manoeuvre> shipped_manoeuvres() {
    InputErrors errors;
    const std::string text(shipped_case(shipped));
    const std::optional<TomlValue> document = read_document(shipped, errors, &text);
    assert(document && errors.count() == 0);
    return read_list(*document, errors);
}

/// The first input of a manoeuvre that is not zero throughout and that the first run does not have; null: none.
const physics::Signal* foreign_input(const Manoeuvre& manoeuvre, const std::vector<MeasuredRun>& runs) {
    for (const physics::Signal& signal : physics::signals()) {
        const auto series = std::ranges::find(manoeuvre.inputs.series(), &signal, &solver::Series::signal);
        const bool is_there =
            series != manoeuvre.inputs.series().end()
                ? std::ranges::any_of(series->value, [](double value) { return value != 0.0; })
                : manoeuvre.inputs.gives(signal) && manoeuvre.inputs.constants().*signal.member != 0.0;
        if (is_there && !runs.front().problem.input_signals.gives(signal)) {
            return &signal;
        }
    }
    return nullptr;
}

}  // namespace

std::vector<Manoeuvre> read_possible(const TomlValue& document, const std::vector<MeasuredRun>& runs,
                                     InputErrors& errors) {
    const TomlValue* own = document.find({"diagnose", "possible"});
    if (own == nullptr) {
        std::vector<Manoeuvre> possible = shipped_manoeuvres();
        std::erase_if(possible, [&](const Manoeuvre& one) { return foreign_input(one, runs) != nullptr; });
        return possible;
    }
    const std::size_t before = errors.count();
    std::vector<Manoeuvre> possible = read_list(document, errors);
    if (errors.count() > before) {
        return {};
    }
    std::erase_if(possible, [&](const Manoeuvre& one) {
        const physics::Signal* foreign = foreign_input(one, runs);
        if (foreign != nullptr) {
            errors.warn(own->place, fmt::format("\"{}\" of possible is left out: {} is no input of the runs", one.name,
                                                foreign->name));
        }
        return foreign != nullptr;
    });
    if (possible.empty()) {
        errors.add(own->place, "possible has no manoeuvre that can be run",
                   "list one, or leave the key out: then those of cases/manoeuvres.toml are possible");
    }
    return possible;
}

}  // namespace tiretherm::input
