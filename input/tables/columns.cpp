// SPDX-License-Identifier: BSD-3-Clause
// Splits headings like "speed [km/h]" and reads the keys `columns` and `rows` into checked numbers.

#include "input/tables/columns.hpp"

#include <fmt/format.h>

#include "input/loggers/logger_units.hpp"
#include "input/text/characters.hpp"

namespace tiretherm::input {

Heading read_heading(std::string_view text) {
    text = trim(text);
    const std::size_t open = text.find('[');
    const std::size_t close = text.rfind(']');
    if (open == std::string_view::npos || close == std::string_view::npos || close < open) {
        return {std::string(text), std::nullopt};
    }
    return {std::string(trim(text.substr(0, open))), std::string(trim(text.substr(open + 1, close - open - 1)))};
}

UnitRead read_heading_unit(const Heading& heading, const QuantitySpec& spec) {
    if (!heading.unit && !spec.is_pure()) {
        const Dimension what = dimension(spec.unit, spec.scale);
        const std::string_view unit = std::string_view(what.example).substr(what.example.find(' ') + 1);
        return {{},
                ErrorText{fmt::format("the column {} has no unit", heading.name),
                          fmt::format("write \"{} [{}]\"", heading.name, unit)}};
    }
    const std::string unit = heading.unit.value_or("");
    const auto meant = conversion(meant_unit(unit, spec.unit), spec.unit, spec.scale);
    if (const auto* found = std::get_if<Conversion>(&meant)) {
        return {*found, std::nullopt};
    }
    UnitRead read = read_unit(unit, spec, fmt::format("the column {} is in [{}]", heading.name, unit));
    if (read.error) {
        const Dimension what = dimension(spec.unit, spec.scale);
        const std::size_t blank = what.example.find(' ');
        const std::string guess = guess_unit(unit, spec.unit, spec.scale);
        const std::string example = !guess.empty()                                 ? guess
                                    : spec.is_pure() || blank == std::string::npos ? "-"
                                                                                   : what.example.substr(blank + 1);
        read.error->remedy = fmt::format("write a unit such as \"{} [{}]\"", heading.name, example);
    }
    return read;
}

std::vector<Column> read_columns(TomlTable& table) {
    const std::vector<LocatedString> headings = table.texts("columns", Need::required);
    const TomlValue* rows = table.value("rows", Need::required, "rows = [[0, 1], [10, 2]]");
    if (headings.empty() || rows == nullptr) {
        return {};
    }
    if (rows->kind != TomlValue::Kind::array || rows->items.empty()) {
        table.add_error(
            "rows",
            fmt::format("rows is {}; a list of rows is wanted",
                        rows->items.empty() && rows->kind == TomlValue::Kind::array ? "empty" : shown(*rows)),
            "write rows = [[0, 1], [10, 2]]");
        return {};
    }
    std::vector<Column> columns;
    columns.reserve(headings.size());
    for (const LocatedString& heading : headings) {
        columns.push_back({read_heading(heading.text), heading.place, {}});
    }
    const std::size_t errors_before = table.errors().count();
    for (const TomlValue& row : rows->items) {
        if (row.kind != TomlValue::Kind::array || row.items.size() != columns.size()) {
            const std::string is = row.kind == TomlValue::Kind::array
                                       ? fmt::format("{} value{}", row.items.size(), row.items.size() == 1 ? "" : "s")
                                       : shown(row);
            table.errors().add(row.place,
                               columns.size() == 1
                                   ? fmt::format("a row has {}; there is 1 column", is)
                                   : fmt::format("a row has {}; there are {} columns", is, columns.size()),
                               "give each row one number a column");
            continue;
        }
        for (std::size_t i = 0; i < columns.size(); ++i) {
            columns[i].cells.push_back(&row.items[i]);
        }
    }
    return table.errors().count() == errors_before ? columns : std::vector<Column>{};
}

std::vector<double> read_numbers(const Column& column, const QuantitySpec& spec, InputErrors& errors) {
    const UnitRead unit = read_heading_unit(column.heading, spec);
    if (unit.error) {
        errors.add(column.place, *unit.error);
        return {};
    }
    const std::string unit_text = column.heading.unit.value_or("");
    std::vector<double> values;
    for (const TomlValue* cell : column.cells) {
        if (!cell->is_number()) {
            errors.add(cell->place, fmt::format("{} is {}; a number is wanted", column.heading.name, shown(*cell)),
                       "write a bare number: the unit stands in the heading");
            continue;
        }
        const std::string shown_value =
            unit_text.empty() || unit_text == "-" ? shown(*cell) : fmt::format("{} {}", shown(*cell), unit_text);
        const ParsedQuantity parsed =
            check_quantity(cell->number, unit.conversion, unit_text, spec, column.heading.name, shown_value);
        if (parsed.error) {
            errors.add(cell->place, *parsed.error);
        } else {
            values.push_back(parsed.value);
        }
    }
    return values.size() == column.cells.size() ? values : std::vector<double>{};
}

}  // namespace tiretherm::input
