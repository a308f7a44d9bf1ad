// SPDX-License-Identifier: BSD-3-Clause
// Names columns, files and keys of a fault.

#include "diagnosis/data_faults/fault_sentence.hpp"

#include <algorithm>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "input/text/word_lists.hpp"

namespace tiretherm::diagnosis {

namespace {

/// The name of a file, and where its headings stand.
std::string place_of(const input::Experiment& experiment, const DataFault& fault) {
    std::vector<std::string> files;
    int line = 0;
    for (const std::size_t r : fault.scope.runs) {
        const std::string file = std::filesystem::path(experiment.runs[r].file).filename().string();
        if (std::ranges::find(files, file) == files.end()) {
            files.push_back(file);
        }
        for (const input::ReadColumn* column : columns_in(fault.what, experiment.runs[r])) {
            line = column->line;
        }
    }
    return input::listed(files) + (line > 0 ? fmt::format(" (line {})", line) : "");
}

}  // namespace

Remark sentence_of(const DataFault& fault, const input::Experiment& experiment) {
    std::vector<std::string> names;
    std::vector<std::string> headings;
    std::vector<std::string> keys;
    for (const LabelledColumn& column : fault.what.columns) {
        names.push_back(column.name);
    }
    for (const input::ColumnChange& change : fault.changes) {
        if (std::ranges::find(headings, change.heading) == headings.end()) {
            headings.push_back(change.heading);
            keys.push_back(fmt::format("{} = \"{}\"", change.heading, change.unit + change.name));
        }
    }
    const std::string place = place_of(experiment, fault);
    if (fault.what.kind == Relabelling::Kind::mirror) {
        return remark::inputs_are_mirrored(input::listed(names), place, fault.before, fault.after);
    }
    const std::string table = fault.scope.recordings.empty() ? "[data]" : "[[run]]";
    const std::string key = fmt::to_string(fmt::join(keys, ", "));
    if (fault.what.kind == Relabelling::Kind::exchange) {
        return remark::columns_are_exchanged(input::listed(names), fault.before, fault.after, input::listed(headings),
                                             place, key, table);
    }
    const input::MeasuredRun& run = experiment.runs[fault.scope.runs.front()];
    const std::string unit = columns_in(fault.what, run).front()->unit;
    Remarks pull;
    if (fault.pull_before - fault.pull_after > 1.0) {
        pull.push_back(remark::parameters_come_back(fault.pull_before, fault.pull_after));
    }
    return remark::unit_is_other(input::listed(names), fault.what.unit, unit, fault.before, fault.after,
                                 std::move(pull), input::listed(headings), place, key, table);
}

}  // namespace tiretherm::diagnosis
