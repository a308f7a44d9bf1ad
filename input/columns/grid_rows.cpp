// SPDX-License-Identifier: BSD-3-Clause
// Finds known columns by their names and arranges rows as a full grid, whatever their order.

#include "input/columns/grid_rows.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "input/tables/data_file.hpp"
#include "input/text/quantity_specs.hpp"
#include "input/text/word_lists.hpp"

namespace tiretherm::input {

namespace {

constexpr std::string_view bulk = "bulk_temperature";

/// A column of another name is an error. @returns the index of each known column among the headings, -1 where it is missing
std::vector<int> places_of(const std::vector<LocatedString>& headings, std::span<const GridColumn> known,
                           std::string_view lacks, InputErrors& errors) {
    const std::vector<std::string> names = names_of(known);
    std::vector<int> places(known.size(), -1);
    for (std::size_t i = 0; i < headings.size(); ++i) {
        if (const auto found = find_name(headings[i], names, lacks, "columns", errors)) {
            places[*found] = static_cast<int>(i);
        }
    }
    return places;
}

/// A point of the grid in SI.
std::string spelt(const GridRows& rows, const physics::GridTable& table, std::size_t index) {
    std::vector<std::string> parts;
    for (std::size_t a = table.axes.size(); a-- > 0;) {
        const std::vector<double>& at = table.axes[a].at;
        parts.push_back(
            fmt::format("{} = {:.6g} {}", rows.columns[a].name, at[index % at.size()], rows.columns[a].spec.unit));
        index /= at.size();
    }
    std::ranges::reverse(parts);
    return listed(parts);
}

}  // namespace

GridColumn grid_column_of(std::string_view input) {
    return {.name = input, .spec = quantity_specs::of(*physics::find_signal(input))};
}

GridColumn grid_column_of_bulk() { return {.name = bulk, .spec = quantity_specs::temperature}; }

bool GridRows::has(std::string_view name) const {
    return std::ranges::find(columns, name, &GridColumn::name) != columns.end();
}

const std::vector<double>& GridRows::of(std::string_view name) const {
    const auto place = std::ranges::find(columns, name, &GridColumn::name) - columns.begin();
    return values[static_cast<std::size_t>(place)];
}

GridRows read_grid_rows(const DataFile& file, std::span<const GridColumn> known, std::string_view lacks,
                        InputErrors& errors) {
    const std::size_t before = errors.count();
    GridRows rows{.top = {.file = file.number()}};
    std::vector<LocatedString> headings;
    for (const ColumnHead& head : file.heads()) {
        headings.push_back({head.heading.name, head.place});
    }
    const std::vector<int> places = places_of(headings, known, lacks, errors);
    std::vector<ColumnRequest> requests;
    for (std::size_t k = 0; k < known.size(); ++k) {
        if (places[k] >= 0) {
            rows.columns.push_back(known[k]);
            requests.push_back({.column = places[k],
                                .name = std::string(known[k].name),
                                .spec = known[k].spec,
                                .purpose = Purpose::point});
        }
    }
    rows.values = file.read(requests, errors);
    if (errors.count() > before) {
        rows.values.clear();
    }
    rows.row = [file](std::size_t row) { return file.spot(row); };
    return rows;
}

GridRows read_grid_rows(TomlTable& table, std::span<const GridColumn> known, std::string_view lacks) {
    InputErrors& errors = table.errors();
    const std::size_t before = errors.count();
    GridRows rows{.top = table.place()};
    const std::vector<Column> columns = read_columns(table);
    std::vector<LocatedString> headings;
    for (const Column& column : columns) {
        headings.push_back({column.heading.name, column.place});
    }
    const std::vector<int> places = places_of(headings, known, lacks, errors);
    std::vector<SourceLocation> lines;
    for (std::size_t k = 0; k < known.size(); ++k) {
        if (places[k] >= 0) {
            const Column& column = columns[static_cast<std::size_t>(places[k])];
            rows.columns.push_back(known[k]);
            rows.values.push_back(read_numbers(column, known[k].spec, errors));
            lines.clear();
            std::ranges::transform(column.cells, std::back_inserter(lines), &TomlValue::place);
        }
    }
    if (errors.count() > before) {
        rows.values.clear();
    }
    rows.row = [lines](std::size_t row) { return FieldLocation{.place = lines[row]}; };
    return rows;
}

std::optional<GridFile> full_grid(const GridRows& rows, const std::vector<double>& measured, InputErrors& errors) {
    // Rows that were measured at scattered values have a full grid of all their combinations: a few hundred make millions.
    constexpr std::size_t most = 100000;
    GridFile found;
    std::size_t size = 1;
    for (std::size_t a = 0; a < rows.columns.size() && !rows.columns[a].is_measured; ++a) {
        const physics::Signal* signal = physics::find_signal(rows.columns[a].name);
        physics::GridTable::Axis axis{.input = signal != nullptr ? signal->member : nullptr, .at = rows.values[a]};
        std::ranges::sort(axis.at);
        axis.at.erase(std::unique(axis.at.begin(), axis.at.end()), axis.at.end());
        size *= axis.at.size();
        found.table.axes.push_back(std::move(axis));
        found.names.emplace_back(rows.columns[a].name);
    }
    if (size > most) {
        return errors.add(rows.top, fmt::format("the full grid of the table would have {} points", size),
                          "give every variable the same few values in all rows");
    }
    // NaN marks what no row has given yet.
    std::vector<double>& values = found.table.values;
    values.assign(size, std::nan(""));
    for (std::size_t row = 0; row < measured.size(); ++row) {
        std::size_t index = 0;
        for (std::size_t a = 0; a < found.table.axes.size(); ++a) {
            const std::vector<double>& at = found.table.axes[a].at;
            const auto place = std::ranges::lower_bound(at, rows.values[a][row]) - at.begin();
            index = index * at.size() + static_cast<std::size_t>(place);
        }
        if (!std::isnan(values[index])) {
            const FieldLocation spot = rows.row(row);
            return errors.add(spot.place, fmt::format("a second row for the same point{}", spot.aside),
                              "keep one of them, or their mean");
        }
        values[index] = measured[row];
    }
    if (const auto gap = std::ranges::find_if(values, [](double v) { return std::isnan(v); }); gap != values.end()) {
        return errors.add(
            rows.top,
            "the table has no row for " + spelt(rows, found.table, static_cast<std::size_t>(gap - values.begin())),
            "every combination of the values must be there");
    }
    return found;
}

}  // namespace tiretherm::input
