// SPDX-License-Identifier: BSD-3-Clause
// Readers of the spreadsheet formats (Excel BIFF, Office Open XML, CSV), one source file for each library.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "input/spreadsheet/sheet_book.hpp"

/// The formats of a spreadsheet, a source file for each library that reads one.
namespace tiretherm::input {

/// A grid of texts as a library gives it, before its cells have places.
struct RawSheet {
    std::string name;
    std::vector<std::vector<std::string>> rows;
};

/// What came of reading a workbook: its sheets, or why there are none.
struct RawBook {
    std::vector<RawSheet> sheets;
    std::optional<ErrorText> error;
    bool hides_formulas = false;  ///< their cells read as empty ones
};

/// Excel 97 to 2003 (BIFF), by FreeXL, which passes formulas over.
[[nodiscard]] RawBook read_xls(const std::filesystem::path& path);

/// Office Open XML, by libzip and pugixml: values of cells as they were last computed.
[[nodiscard]] RawBook read_xlsx(const std::filesystem::path& path);

/// The sheets of a folder, one from each *.csv in it, in the order of their names.
[[nodiscard]] std::vector<Sheet> read_csv_sheets(const std::filesystem::path& folder, InputErrors& errors);

/// Gives the parts of a ZIP archive by name; nothing for one that is not there.
using ZipParts = std::function<std::optional<std::string>(const std::string& name)>;

/// Opens an archive for as long as `use` takes. @returns why it could not be read
[[nodiscard]] std::optional<ErrorText> with_zip(const std::filesystem::path& path,
                                                const std::function<std::optional<ErrorText>(const ZipParts&)>& use);

/// The number as a cell's text, with all its digits.
[[nodiscard]] std::string cell_text(double number);

}  // namespace tiretherm::input
