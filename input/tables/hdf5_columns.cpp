// SPDX-License-Identifier: BSD-3-Clause
// Checks that all datasets have one length.

#include "input/tables/hdf5_columns.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "input/tables/hdf5_datasets.hpp"
#include "input/text/suggestions.hpp"

namespace tiretherm::input {

std::optional<LogTable> read_hdf5_columns(const std::filesystem::path& path, InputErrors& errors) {
    const SourceLocation place{.file = 0};
    auto [found, groups, defects] = read_datasets(path);
    if (!defects.empty()) {
        for (ErrorText& defect : defects) {
            errors.add(place, std::move(defect));
        }
        return std::nullopt;
    }
    if (groups.size() > 1) {
        errors.add(place, fmt::format("several groups of the file hold datasets: {}", listed(groups)),
                   "keep the run's datasets in the root or in one group");
        return std::nullopt;
    }
    if (found.empty()) {
        errors.add(place, "the file holds no datasets of numbers in one dimension",
                   "write one for the time and one for each signal, in the root or in one group");
        return std::nullopt;
    }
    // The time says how long the others must be; without one, the first does.
    const auto clock =
        std::find_if(found.begin(), found.end(), [](const Dataset& d) { return d.heading.name == "time"; });
    const Dataset& first = clock == found.end() ? found.front() : *clock;
    bool equal = true;
    for (const Dataset& dataset : found) {
        if (dataset.values.size() != first.values.size()) {
            errors.add(place,
                       fmt::format("the dataset {} has {} values, {} has {}", dataset.heading.name,
                                   dataset.values.size(), first.heading.name, first.values.size()),
                       "let all datasets of the run have one length");
            equal = false;
        }
    }
    if (!equal) {
        return std::nullopt;
    }
    LogTable table{.description = {.format = "HDF5"}, .units = LogTable::Units::in_attributes};
    if (first.values.empty()) {
        table.defects.add(place, "the datasets are empty");
    }
    for (Dataset& dataset : found) {
        table.columns.push_back(
            {.head = {.heading = std::move(dataset.heading), .place = place}, .number = std::move(dataset.values)});
    }
    table.where = [place](std::size_t row, int /*column*/) {
        return FieldLocation{place, fmt::format(" (value {})", row + 1)};
    };
    return table;
}

}  // namespace tiretherm::input
