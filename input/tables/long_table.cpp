// SPDX-License-Identifier: BSD-3-Clause
// Finds the columns of times, names and readings, and sorts the readings by name.

#include "input/tables/long_table.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "input/text/column_names.hpp"

namespace tiretherm::input {

namespace {

constexpr std::size_t most_names = 200;
constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

/// Which column of a table with a line for each reading is which; `none`: there is none.
struct LongColumns {
    std::size_t time = none;
    std::size_t name = none;
    std::size_t unit = none;
    std::size_t value = none;
};

/// @returns nothing where there is more than one of any kind
std::optional<LongColumns> long_columns(const LogTable& table) {
    LongColumns found;
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        const TableColumn& column = table.columns[i];
        const std::string name = bare_name(column.head.heading.name);
        const bool is_text = !column.number.empty() && column.text.size() == column.number.size();
        const bool is_time = column.head.is_clock || column.head.heading.name == "time";
        std::size_t& place = is_time                                                      ? found.time
                             : is_text && has_word(column_words::names_of_units, name)    ? found.unit
                             : is_text || has_word(column_words::names_of_readings, name) ? found.name
                                                                                          : found.value;
        if (place != none) {
            return std::nullopt;
        }
        place = i;
    }
    const bool is_named = found.name != none && has_word(column_words::names_of_readings,
                                                         bare_name(table.columns[found.name].head.heading.name));
    return is_named && found.time != none && found.value != none ? std::optional(found) : std::nullopt;
}

/// Readings by name.
class LongTable {
public:
    LongTable(const LogTable& table, const LongColumns& columns) : table_(table), of_(columns) {}

    void take(std::size_t row, const std::vector<std::string_view>& fields, const SourceLocation& place) {
        const auto known = std::ranges::find(names_, fields[of_.name]);
        const auto at = static_cast<std::size_t>(known - names_.begin());
        if (known == names_.end()) {
            names_.emplace_back(fields[of_.name]);
            Heading heading = table_.columns[of_.value].head.heading;
            heading.name = names_.back();
            heading.unit = of_.unit != none ? std::optional(std::string(fields[of_.unit])) : heading.unit;
            heads_.push_back({.heading = heading, .place = place});
            source_.emplace_back(first_.size(), none);
        }
        const bool is_new = first_.empty() || !is_same_time(first_.back(), row) || source_[at].back() != none;
        if (is_new) {
            first_.push_back(row);
            for (std::vector<std::size_t>& of_name : source_) {
                of_name.push_back(none);
            }
        }
        source_[at].back() = row;
    }

    /// Whether several names share times.
    [[nodiscard]] bool is_one() const {
        return names_.size() > 1 && names_.size() <= most_names &&
               first_.size() < table_.columns[of_.value].number.size();
    }
    [[nodiscard]] std::vector<TableColumn> columns() const {
        const TableColumn& times = table_.columns[of_.time];
        std::vector<TableColumn> folded{{.head = times.head}};
        for (const std::size_t row : first_) {
            times.stamp.empty() ? folded.front().number.push_back(times.number[row])
                                : folded.front().stamp.push_back(times.stamp[row]);
        }
        const TableColumn& readings = table_.columns[of_.value];
        for (std::size_t i = 0; i < names_.size(); ++i) {
            TableColumn& column = folded.emplace_back(TableColumn{.head = heads_[i]});
            for (const std::size_t row : source_[i]) {
                const bool is_text = row != none && std::ranges::binary_search(readings.text, row);
                if (is_text) {
                    column.text.push_back(static_cast<std::uint32_t>(column.number.size()));
                }
                column.number.push_back(row == none ? std::numeric_limits<double>::quiet_NaN() : readings.number[row]);
            }
        }
        return folded;
    }
    /// The row and the column of the file in which a field stands.
    [[nodiscard]] auto source() const {
        return [first = first_, source = source_, of = of_](std::size_t row, int column) {
            const std::size_t own = column > 0 ? source[static_cast<std::size_t>(column - 1)][row] : none;
            return own != none ? std::pair(own, static_cast<int>(of.value))
                               : std::pair(first[row], column < 0 ? -1 : static_cast<int>(of.time));
        };
    }

private:
    [[nodiscard]] bool is_same_time(std::size_t a, std::size_t b) const {
        const TableColumn& times = table_.columns[of_.time];
        return times.stamp.empty()
                   ? times.number[a] == times.number[b]
                   : times.stamp[a].seconds == times.stamp[b].seconds && times.stamp[a].date == times.stamp[b].date;
    }

    const LogTable& table_;
    LongColumns of_;
    std::vector<std::string> names_;
    std::vector<ColumnHead> heads_;
    std::vector<std::size_t> first_;                ///< [rows] of the file
    std::vector<std::vector<std::size_t>> source_;  ///< [names][rows] of the file; `none`: no reading
};

}  // namespace

void fold_long_table(LogTable& table, const std::shared_ptr<const CsvRows>& rows) {
    const std::optional<LongColumns> columns = long_columns(table);
    if (!columns) {
        return;
    }
    LongTable folded(table, *columns);
    std::size_t row = 0;
    rows->each([&](const CsvLine& line, const std::vector<std::string_view>& fields) {
        folded.take(row++, fields, place_in(line, fields[columns->name]));
    });
    if (folded.is_one()) {
        std::vector<TableColumn> made = folded.columns();
        table.where = [rows, source = folded.source()](std::size_t at, int column) {
            const auto [of_file, in_file] = source(at, column);
            return rows->where(of_file, in_file);
        };
        table.columns = std::move(made);
    }
}

}  // namespace tiretherm::input
