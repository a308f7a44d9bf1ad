// SPDX-License-Identifier: BSD-3-Clause
// Column headings `name [unit]`, and tables that a case gives inline as { columns, rows }.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "input/toml/toml_table.hpp"

namespace tiretherm::input {

/// The head of a column, `name [unit]`. Without brackets the unit is missing, with empty ones it is 1.
struct Heading {
    std::string name;
    std::optional<std::string> unit;
};
[[nodiscard]] Heading read_heading(std::string_view text);

/// One column of a table in a case: { columns = ["load [N]", "length [mm]"], rows = [[0, 0], [4000, 97]] }.
struct Column {
    Heading heading;
    SourceLocation place;  ///< of the heading
    std::vector<const TomlValue*> cells;
};

/// The columns of a table's keys `columns` and `rows`; none after an error.
[[nodiscard]] std::vector<Column> read_columns(TomlTable& table);

/// How a heading's numbers become values, or what is wrong with its unit.
[[nodiscard]] UnitRead read_heading_unit(const Heading& heading, const QuantitySpec& spec);

/// The numbers of a column; as many as cells, or none after an error.
[[nodiscard]] std::vector<double> read_numbers(const Column& column, const QuantitySpec& spec, InputErrors& errors);

}  // namespace tiretherm::input
