#include "input/tables/columns.hpp"

#include <fmt/format.h>

#include "input/text/words.hpp"

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

UnitRead read_heading_unit(const Heading& heading, const Wanted& wanted) {
    if (!heading.unit && !wanted.is_pure()) {
        const Dimension what = dimension(wanted.unit, wanted.scale);
        const std::string_view unit = std::string_view(what.example).substr(what.example.find(' ') + 1);
        return {{},
                Fault{fmt::format("the column {} has no unit", heading.name),
                      fmt::format("write \"{} [{}]\"", heading.name, unit)}};
    }
    const std::string unit = heading.unit.value_or("");
    UnitRead read = read_unit(unit, wanted, fmt::format("the column {} is in [{}]", heading.name, unit));
    if (read.fault) {
        const Dimension what = dimension(wanted.unit, wanted.scale);
        const std::size_t blank = what.example.find(' ');
        const std::string example =
            wanted.is_pure() || blank == std::string::npos ? "-" : what.example.substr(blank + 1);
        read.fault->remedy = fmt::format("write a unit such as \"{} [{}]\"", heading.name, example);
    }
    return read;
}

std::vector<Column> read_columns(Section& section) {
    const std::vector<Word> headings = section.texts("columns", Need::required);
    const Node* rows = section.value("rows", Need::required, "rows = [[0, 1], [10, 2]]");
    if (headings.empty() || rows == nullptr) {
        return {};
    }
    if (rows->kind != Node::Kind::array || rows->items.empty()) {
        section.mistake("rows",
                        fmt::format("rows is {}; a list of rows is wanted",
                                    rows->items.empty() && rows->kind == Node::Kind::array ? "empty" : shown(*rows)),
                        "write rows = [[0, 1], [10, 2]]");
        return {};
    }
    std::vector<Column> columns;
    columns.reserve(headings.size());
    for (const Word& heading : headings) {
        columns.push_back({read_heading(heading.text), heading.place, {}});
    }
    const std::size_t mistakes_before = section.mistakes().count();
    for (const Node& row : rows->items) {
        if (row.kind != Node::Kind::array || row.items.size() != columns.size()) {
            const std::string is =
                row.kind == Node::Kind::array ? fmt::format("{} values", row.items.size()) : shown(row);
            section.mistakes().add(row.place, fmt::format("a row has {}; there are {} columns", is, columns.size()),
                                   "give each row one number a column");
            continue;
        }
        for (std::size_t i = 0; i < columns.size(); ++i) {
            columns[i].cells.push_back(&row.items[i]);
        }
    }
    return section.mistakes().count() == mistakes_before ? columns : std::vector<Column>{};
}

std::vector<double> read_numbers(const Column& column, const Wanted& wanted, Mistakes& mistakes) {
    const UnitRead unit = read_heading_unit(column.heading, wanted);
    if (unit.fault) {
        mistakes.add(column.place, *unit.fault);
        return {};
    }
    const std::string unit_text = column.heading.unit.value_or("");
    std::vector<double> values;
    for (const Node* cell : column.cells) {
        if (!cell->is_number()) {
            mistakes.add(cell->place, fmt::format("{} is {}; a number is wanted", column.heading.name, shown(*cell)),
                         "write a bare number: the unit stands in the heading");
            continue;
        }
        const std::string shown_value =
            unit_text.empty() || unit_text == "-" ? shown(*cell) : fmt::format("{} {}", shown(*cell), unit_text);
        const Judged judged = judge(cell->number, unit.conversion, unit_text, wanted, column.heading.name, shown_value);
        if (judged.fault) {
            mistakes.add(cell->place, *judged.fault);
        } else {
            values.push_back(judged.value);
        }
    }
    return values.size() == column.cells.size() ? values : std::vector<double>{};
}

}  // namespace tiretherm::input
