#include "input/tables/hdf5_columns.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "input/tables/hdf5_datasets.hpp"
#include "input/text/words.hpp"

namespace tiretherm::input {

std::optional<Hdf5Columns> Hdf5Columns::open(const std::filesystem::path& path, const Place& mentioned,
                                             Mistakes& mistakes) {
    const std::string shown = path.generic_string();
    if (const Fault fault = hdf5_defect(path); !fault.what.empty()) {
        if (mentioned.file < 0) {
            mistakes.add({.file = mistakes.add_file(shown, "")}, "the file " + fault.what, fault.remedy);
        } else {
            mistakes.add(mentioned, fmt::format("the file {} {}", shown, fault.what), fault.remedy);
        }
        return std::nullopt;
    }
    Hdf5Columns columns;
    columns.number_ = mistakes.add_file(shown, "");
    const Place place{.file = columns.number_};
    auto [found, groups] = read_datasets(path);
    if (groups.size() > 1) {
        mistakes.add(place, fmt::format("several groups of the file hold datasets: {}", listed(groups)),
                     "keep the run's datasets in the root or in one group");
        return std::nullopt;
    }
    if (found.empty()) {
        mistakes.add(place, "the file holds no datasets of numbers in one dimension",
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
            mistakes.add(place,
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
                                                   Mistakes& mistakes) const {
    const std::size_t before = mistakes.count();
    std::vector<std::vector<double>> values;
    for (const ColumnRequest& request : requests) {
        const auto column = static_cast<std::size_t>(request.column);
        ColumnReader reader(heads_[column], request, mistakes);
        const std::vector<double>& written = written_[column];
        for (std::size_t i = 0; i < written.size(); ++i) {
            const auto where = [&] {
                return ColumnReader::Spot{heads_[column].place, fmt::format(" (value {})", i + 1)};
            };
            reader.take(fmt::format("{}", written[i]), where);
        }
        reader.close();
        values.push_back(std::move(reader.values));
    }
    if (!written_.empty() && written_.front().empty()) {
        mistakes.add({.file = number_}, "the datasets are empty");
    }
    return mistakes.count() == before ? values : std::vector<std::vector<double>>{};
}

}  // namespace tiretherm::input
