// SPDX-License-Identifier: BSD-3-Clause
// Checks the columns and units of the rolling-resistance file and arranges its rows as a full grid.

#include "input/effects/resistance_table.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "input/tables/data_file.hpp"
#include "input/text/quantity_specs.hpp"
#include "input/text/word_lists.hpp"

namespace tiretherm::input {

namespace {

/// A column of the table; without input it is the bulk's temperature, or what was measured.
struct Known {
    std::string_view name;
    QuantitySpec spec;
    bool measured = false;
};

const std::vector<Known>& known_columns() {
    static const std::vector<Known> known = [] {
        std::vector<Known> made;
        for (const std::string_view name : {"speed", "vertical_load", "inflation_pressure", "air_temperature"}) {
            made.push_back({name, quantity_specs::of(*physics::find_signal(name))});
        }
        made.push_back({"bulk_temperature", quantity_specs::temperature});
        made.push_back({"force", {.unit = "N", .low = 0.0, .high = 1e5, .above = true}, true});
        made.push_back({"power", {.unit = "W", .low = 0.0, .high = 1e6, .above = true}, true});
        return made;
    }();
    return known;
}

class TableReader {
public:
    TableReader(const DataFile& file, InputErrors& errors) : file_(file), errors_(errors) {}

    std::optional<ResistanceFile> read() {
        const std::size_t before = errors_.count();
        check_names();
        for (const Known& known : known_columns()) {
            if (const int column = file_.find(known.name); column >= 0) {
                requests_.push_back(
                    {.column = column, .name = std::string(known.name), .spec = known.spec, .purpose = Purpose::point});
            }
        }
        check_columns();
        values_ = file_.read(requests_, errors_);
        if (errors_.count() != before || values_.empty()) {
            return std::nullopt;
        }
        return grid();
    }

private:
    [[nodiscard]] SourceLocation top() const { return {.file = file_.number()}; }
    [[nodiscard]] bool has(std::string_view name) const {
        return std::ranges::find(requests_, name, &ColumnRequest::name) != requests_.end();
    }

    void check_names() {
        const std::vector<std::string> known = names_of(known_columns());
        for (const ColumnHead& head : file_.heads()) {
            static_cast<void>(find_name({head.heading.name, head.place}, known, "a table of the loss has no column",
                                        "columns", errors_));
        }
    }

    void check_columns() {
        if (has("force") == has("power")) {
            errors_.add(top(),
                        has("force") ? "the table gives force and power" : "the table gives neither force nor power",
                        "keep one column: force [N] or power [W]");
        }
        if (!has("speed") || !has("vertical_load")) {
            errors_.add(top(), fmt::format("the table has no {}", has("speed") ? "vertical_load" : "speed"),
                        "add the column, with one value where it was not varied");
        }
        if (has("air_temperature") && has("bulk_temperature")) {
            errors_.add(top(), "the table gives two temperatures", "keep that which was varied");
        }
    }

    std::optional<ResistanceFile> grid() {
        ResistanceFile found;
        const std::vector<double>& measured = values_.back();
        const std::size_t n_axes = requests_.size() - 1;
        std::size_t size = 1;
        for (std::size_t a = 0; a < n_axes; ++a) {
            const physics::Signal* signal = physics::find_signal(requests_[a].name);
            physics::ResistanceTable::Axis axis{.input = signal != nullptr ? signal->member : nullptr,
                                                .at = values_[a]};
            std::ranges::sort(axis.at);
            axis.at.erase(std::unique(axis.at.begin(), axis.at.end()), axis.at.end());
            size *= axis.at.size();
            found.table.axes.push_back(std::move(axis));
            found.names.push_back(requests_[a].name);
        }
        if (size > most_) {
            return errors_.add(top(), fmt::format("the full grid of the table would have {} points", size),
                               "give every variable the same few values in all rows");
        }
        std::vector<double>& force = found.table.force;
        force.assign(size, std::nan(""));
        for (std::size_t row = 0; row < measured.size(); ++row) {
            std::size_t index = 0;
            for (std::size_t a = 0; a < n_axes; ++a) {
                const std::vector<double>& at = found.table.axes[a].at;
                const auto place = std::ranges::lower_bound(at, values_[a][row]) - at.begin();
                index = index * at.size() + static_cast<std::size_t>(place);
            }
            if (!std::isnan(force[index])) {
                const FieldLocation spot = file_.spot(row);
                return errors_.add(spot.place, fmt::format("a second row for the same point{}", spot.aside),
                                   "keep one of them, or their mean");
            }
            force[index] = measured[row];
            if (has("power")) {
                const double speed = values_.front()[row];
                if (!(speed > 0.0)) {
                    const FieldLocation spot = file_.spot(row);
                    return errors_.add(spot.place, fmt::format("a power at a standstill{}", spot.aside),
                                       "leave the row out");
                }
                force[index] /= speed;
            }
        }
        if (const auto gap = std::ranges::find_if(force, [](double f) { return std::isnan(f); }); gap != force.end()) {
            return errors_.add(
                top(), "the table has no row for " + spelt(found, static_cast<std::size_t>(gap - force.begin())),
                "every combination of the values must be there");
        }
        return found;
    }

    /// A point of the grid in SI.
    [[nodiscard]] static std::string spelt(const ResistanceFile& found, std::size_t index) {
        std::vector<std::string> parts;
        for (std::size_t a = found.names.size(); a-- > 0;) {
            const std::vector<double>& at = found.table.axes[a].at;
            const auto known = std::ranges::find(known_columns(), found.names[a], &Known::name);
            parts.push_back(fmt::format("{} = {:.6g} {}", found.names[a], at[index % at.size()], known->spec.unit));
            index /= at.size();
        }
        std::ranges::reverse(parts);
        return listed(parts);
    }

    // Rows that were measured at scattered values have a full grid of all their combinations: a few hundred make millions.
    static constexpr std::size_t most_ = 100000;
    const DataFile& file_;
    InputErrors& errors_;
    std::vector<ColumnRequest> requests_;
    std::vector<std::vector<double>> values_;
};

}  // namespace

std::optional<ResistanceFile> read_resistance_table(const std::filesystem::path& path, const SourceLocation& mentioned,
                                                    InputErrors& errors) {
    const std::optional<DataFile> file = DataFile::open(path, mentioned, errors);
    return file ? TableReader(*file, errors).read() : std::nullopt;
}

}  // namespace tiretherm::input
