// SPDX-License-Identifier: BSD-3-Clause
// Parameters and measured tables found in the sheets, with their places.
#pragma once

#include <string>
#include <vector>

#include "input/spreadsheet/sheet_parameters.hpp"

namespace tiretherm::input {

/// A parameter as a sheet gives it.
struct SheetValue {
    const SheetParameter* parameter = nullptr;
    std::string text;     ///< of its value; a number in `number` too, where it must be one
    double number = 0.0;  ///< in `unit`
    std::string unit;     ///< as a case writes it; "1" for a pure number
    SourceLocation name_place;
    SourceLocation place;  ///< of the value
    bool sound = true;     ///< false after an error: what the sheet wanted to say is not known
};

/// A measured table as a sheet gives it, without its empty rows.
struct SheetMeasured {
    const SheetTable* table = nullptr;
    std::string variable_unit;
    std::string value_unit;
    std::string temperature_unit;  ///< of a table against two variables
    std::vector<double> variable;
    std::vector<double> temperature;
    std::vector<double> value;
    std::vector<SourceLocation> places;  ///< of the values
};

/// What the sheets say, in their order.
struct SheetContent {
    std::vector<SheetValue> values;
    std::vector<SheetMeasured> measured;

    /// The value of a parameter; null where the sheet is silent.
    [[nodiscard]] const SheetValue* find(const SheetParameter& parameter) const;
};

/// Reads the parameters of a sheet, rows of `name, value, unit, note` or two such groups side by side, and its measured
/// tables, a row of headings `name [unit]` over rows of numbers. Titles, headings and lines that begin with # are passed
/// over.
void scan_sheet(const SheetBook& book, const Sheet& sheet, SheetContent& content, InputErrors& errors);

/// The measured tables under a row of headings. @returns how many rows they take; 0 where the row is no such heading
[[nodiscard]] std::size_t scan_tables(const Sheet& sheet, std::string_view name, std::size_t row, SheetContent& content,
                                      InputErrors& errors);

/// A unit of the sheet as a case writes it: without brackets, with plain digits for raised ones.
[[nodiscard]] std::string plain_unit(std::string_view written);

/// What is wrong with a unit where another is wanted.
[[nodiscard]] std::optional<ErrorText> unit_error(std::string_view unit, std::string_view wanted,
                                                  std::string_view name);

/// What to do about a cell of an .xls workbook that may hold a formula.
inline constexpr const char* formula_remedy = "write the number, save the workbook as .xlsx, or empty the row";

/// What is wrong with a cell where a number belongs.
[[nodiscard]] ErrorText not_a_number(std::string_view name, std::string_view text);

}  // namespace tiretherm::input
