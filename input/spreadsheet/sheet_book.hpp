// SPDX-License-Identifier: BSD-3-Clause
// The thesis's spreadsheet as cells with places, whichever format it was read from: .xls, .xlsx or a folder of CSV
// files.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "input/text/input_error.hpp"

/// The thesis's spreadsheet of ten sheets, and how it becomes a case.
namespace tiretherm::input {

/// What a cell shows: a text, or a number with all its digits. An empty cell has no text.
struct SheetCell {
    std::string text;
    SourceLocation place;  ///< in a workbook line and column are those of the cell
};

/// One sheet, row by row; trailing empty cells may be missing.
struct Sheet {
    std::string name;
    SourceLocation place;  ///< the sheet as a whole
    std::vector<std::vector<SheetCell>> rows;
    bool hides_formulas = false;  ///< an empty cell may hold a formula, whose value the format's library does not give

    /// The cell, an empty one beyond the ends. Rows and columns count from 0.
    [[nodiscard]] const SheetCell& at(std::size_t row, std::size_t column) const;
};

/// A workbook, or a folder with a CSV file for each sheet.
struct SheetBook {
    std::string shown;  ///< its path, as the user would type it
    bool is_folder = false;
    std::vector<Sheet> sheets;

    /// A sheet by its name, whatever its capitals; null when absent.
    [[nodiscard]] const Sheet* find(std::string_view name) const;
};

/// Reads a folder of CSV files, an .xls (Excel 97 to 2003) or an .xlsx workbook; which of them it is, its content says.
/// @returns nothing after an error
[[nodiscard]] std::optional<SheetBook> read_sheet_book(const std::filesystem::path& path, InputErrors& errors);

/// "SEL!B4" of a workbook, "SEL.csv:4" of a folder: a place for a sentence.
[[nodiscard]] std::string spell(const SheetBook& book, const Sheet& sheet, const SourceLocation& place,
                                const InputErrors& errors);

/// Errors in a workbook with the cell in the place of line and column: `tire.xls, SEL!B4`.
[[nodiscard]] std::vector<InputError> with_cells(std::vector<InputError> errors, const SheetBook& book);

}  // namespace tiretherm::input
