// SPDX-License-Identifier: BSD-3-Clause
// Reads measured tables in the sheets: a row of headings with units over rows of numbers.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "input/spreadsheet/sheet_rows.hpp"
#include "input/tables/columns.hpp"
#include "input/text/error_limiter.hpp"
#include "input/text/quantity.hpp"
#include "input/text/suggestions.hpp"

namespace tiretherm::input {

namespace {

/// A heading and the column it stands over.
struct Over {
    std::size_t column;
    Heading heading;
    SourceLocation place;
};

const Over* column_called(const std::vector<Over>& heads, std::string_view name, std::string_view aliases) {
    const auto found =
        std::ranges::find_if(heads, [&](const Over& head) { return is_called(head.heading.name, name, aliases); });
    return found == heads.end() ? nullptr : &*found;
}

/// The number of a cell; nothing for an empty one or after an error.
std::optional<double> number_in(const SheetCell& cell, std::string_view name, ErrorLimiter& limiter) {
    if (cell.text.empty()) {
        return std::nullopt;
    }
    const std::optional<Number> number = leading_number(cell.text);
    if (!number || !number->rest.empty() || !std::isfinite(number->value)) {
        limiter.add(cell.place, not_a_number(name, cell.text));
        return std::nullopt;
    }
    return number->value;
}

std::string sound_unit(const Over& head, std::string_view wanted, InputErrors& errors) {
    const std::string unit = plain_unit(head.heading.unit.value_or(""));
    if (std::optional<ErrorText> error = unit_error(unit, wanted, head.heading.name)) {
        error->remedy = fmt::format("write {} [{}]", head.heading.name, wanted);
        errors.add(head.place, std::move(*error));
        return {};
    }
    return unit;
}

constexpr std::string_view temperature_aliases = "T|Temperature Vector for lateral stiffness|Bulk Temperature";

}  // namespace

std::size_t scan_tables(const Sheet& sheet, std::string_view name, std::size_t row, SheetContent& content,
                        InputErrors& errors) {
    std::vector<Over> heads;
    for (std::size_t c = 0; c < sheet.rows[row].size(); ++c) {
        const SheetCell& cell = sheet.at(row, c);
        if (!cell.text.empty()) {
            heads.push_back({c, read_heading(cell.text), cell.place});
        }
    }
    std::vector<const SheetTable*> tables;
    const Over* variable = nullptr;
    for (const SheetTable& table : sheet_tables()) {
        const Over* over = column_called(heads, table.variable, table.variable_aliases);
        if (table.sheet == name && over == &heads.front() && over->heading.unit && heads.size() > 1) {
            variable = over;
            tables.push_back(&table);
        }
    }
    if (tables.empty()) {
        return 0;
    }
    // A heading that belongs to no table would leave its numbers unread.
    std::vector<std::string> known;
    for (const SheetTable* table : tables) {
        known.emplace_back(table->value);
    }
    for (const Over& head : heads) {
        const bool read = &head == variable || std::ranges::any_of(tables, [&](const SheetTable* table) {
            return is_called(head.heading.name, table->value, table->value_aliases) ||
                   (table->also_temperature && is_called(head.heading.name, "Temperature", temperature_aliases));
        });
        if (!read) {
            errors.add(head.place, fmt::format("{} has no column \"{}\"", name, head.heading.name),
                       suggest(head.heading.name, known, "columns"));
        }
    }
    std::size_t end = row + 1;
    const auto filled = [&](std::size_t r) {
        return std::ranges::any_of(heads, [&](const Over& head) { return !sheet.at(r, head.column).text.empty(); });
    };
    while (end < sheet.rows.size() && filled(end)) {
        ++end;
    }
    if (end == row + 1) {
        return 1;  // headings over nothing: as good as not there
    }
    for (const SheetTable* table : tables) {
        const Over* value = column_called(heads, table->value, table->value_aliases);
        if (value == nullptr) {
            continue;
        }
        if (std::ranges::any_of(content.measured, [&](const SheetMeasured& m) { return m.table == table; })) {
            errors.add(value->place, fmt::format("a second column {}", table->value), "keep one of them");
            continue;
        }
        SheetMeasured measured{.table = table,
                               .variable_unit = sound_unit(*variable, table->variable_unit, errors),
                               .value_unit = sound_unit(*value, table->value_unit, errors),
                               .temperature_unit = {},
                               .variable = {},
                               .temperature = {},
                               .value = {},
                               .places = {}};
        const Over* temperature =
            table->also_temperature ? column_called(heads, "Temperature", temperature_aliases) : nullptr;
        if (table->also_temperature && temperature == nullptr) {
            errors.add(value->place, fmt::format("{} needs a column Temperature", table->value),
                       "write Temperature [degC]");
            continue;
        }
        if (temperature != nullptr) {
            measured.temperature_unit = sound_unit(*temperature, "degC", errors);
        }
        ErrorLimiter limiter(errors);
        for (std::size_t r = row + 1; r < end; ++r) {
            const SheetCell& cell = sheet.at(r, value->column);
            const auto x = number_in(sheet.at(r, variable->column), table->variable, limiter);
            const auto y = number_in(cell, table->value, limiter);
            const auto T = temperature != nullptr ? number_in(sheet.at(r, temperature->column), "Temperature", limiter)
                                                  : std::optional(0.0);
            if (x && !y && cell.text.empty() && sheet.hides_formulas) {
                limiter.add(sheet.at(r, variable->column).place,
                            {fmt::format("the {} of this row is empty or a formula, which an .xls does not give away",
                                         table->value),
                             formula_remedy});
            }
            if (y && !x && sheet.at(r, variable->column).text.empty()) {
                limiter.add(cell.place, {fmt::format("{} is given without {}", table->value, table->variable), ""});
            }
            if (x && y && T) {
                measured.variable.push_back(*x);
                measured.value.push_back(*y);
                measured.temperature.push_back(*T);
                measured.places.push_back(cell.place);
            }
        }
        limiter.close(std::string(table->value));
        if (!measured.value.empty() && !measured.variable_unit.empty() && !measured.value_unit.empty()) {
            content.measured.push_back(std::move(measured));
        }
    }
    return end - row;
}

}  // namespace tiretherm::input
