// SPDX-License-Identifier: BSD-3-Clause
// Checks that all datasets have one length and reads the requested ones into SI values.

#include "input/tables/hdf5_columns.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "input/tables/hdf5_datasets.hpp"
#include "input/text/suggestions.hpp"

namespace tiretherm::input {

std::optional<Hdf5Columns> Hdf5Columns::open(const std::filesystem::path& path, const SourceLocation& mentioned,
                                             InputErrors& errors) {
    const std::string shown = path.generic_string();
    if (const ErrorText error = hdf5_defect(path); !error.what.empty()) {
        if (mentioned.file < 0) {
            errors.add({.file = errors.add_file(shown, "")}, "the file " + error.what, error.remedy);
        } else {
            errors.add(mentioned, fmt::format("the file {} {}", shown, error.what), error.remedy);
        }
        return std::nullopt;
    }
    Hdf5Columns columns;
    columns.number_ = errors.add_file(shown, "");
    const SourceLocation place{.file = columns.number_};
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
    for (Dataset& dataset : found) {
        columns.heads_.push_back({.heading = std::move(dataset.heading), .place = place});
        columns.written_.push_back(std::move(dataset.values));
    }
    return columns;
}

std::vector<std::vector<double>> Hdf5Columns::read(const std::vector<ColumnRequest>& requests,
                                                   InputErrors& errors) const {
    const std::size_t before = errors.count();
    std::vector<std::vector<double>> values;
    for (const ColumnRequest& request : requests) {
        const auto column = static_cast<std::size_t>(request.column);
        ColumnReader reader(heads_[column], request, errors);
        const std::vector<double>& written = written_[column];
        for (std::size_t i = 0; i < written.size(); ++i) {
            const auto where = [&] {
                return ColumnReader::FieldLocation{heads_[column].place, fmt::format(" (value {})", i + 1)};
            };
            reader.take(written[i], true, where);
        }
        reader.close();
        values.push_back(std::move(reader.values));
    }
    if (!written_.empty() && written_.front().empty()) {
        errors.add({.file = number_}, "the datasets are empty");
    }
    return errors.count() == before ? values : std::vector<std::vector<double>>{};
}

}  // namespace tiretherm::input
