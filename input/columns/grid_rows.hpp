// SPDX-License-Identifier: BSD-3-Clause
// Rows of something measured over inputs and the bulk's temperature, of a file or inline, and the full grid that they make.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "input/tables/column_reader.hpp"
#include "physics/tire_laws/grid_table.hpp"

namespace tiretherm::input {

class DataFile;

/// A column that a table may have: an input, the bulk's temperature, or what was measured.
struct GridColumn {
    std::string_view name;
    QuantitySpec spec;
    bool is_measured = false;
};
/// The column of an input.
[[nodiscard]] GridColumn grid_column_of(std::string_view input);
/// The column `bulk_temperature`.
[[nodiscard]] GridColumn grid_column_of_bulk();

/// The columns that a table has, in the order in which they are known.
struct GridRows {
    std::vector<GridColumn> columns{};
    std::vector<std::vector<double>> values{};        ///< [columns][rows] SI; empty after an error
    std::function<FieldLocation(std::size_t)> row{};  ///< where a row stands
    SourceLocation top{};                             ///< where the table stands

    [[nodiscard]] bool has(std::string_view name) const;
    /// The values of a column. @pre it is there and the values are
    [[nodiscard]] const std::vector<double>& of(std::string_view name) const;
};
/// @param known what was varied first, what was measured last  @param lacks "a table of the loss has no column"
[[nodiscard]] GridRows read_grid_rows(const DataFile& file, std::span<const GridColumn> known, std::string_view lacks,
                                      InputErrors& errors);
/// The same of { columns, rows }.
[[nodiscard]] GridRows read_grid_rows(TomlTable& table, std::span<const GridColumn> known, std::string_view lacks);

/// A measured table with the names of its axes.
struct GridFile {
    physics::GridTable table;
    std::vector<std::string> names;  ///< [axes]
};
/// Every combination of the values must be there once. @param measured [rows]  @returns nothing after an error
[[nodiscard]] std::optional<GridFile> full_grid(const GridRows& rows, const std::vector<double>& measured,
                                                InputErrors& errors);

}  // namespace tiretherm::input
