// SPDX-License-Identifier: BSD-3-Clause
// Detects the format of the workbook, gives every cell its place, and names cells like SEL!B4 in messages.

#include "input/spreadsheet/sheet_book.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <system_error>

#include <fmt/format.h>

#include "input/spreadsheet/sheet_formats.hpp"
#include "input/text/nearby_file.hpp"
#include "input/text/regular_file.hpp"
#include "input/text/suggestions.hpp"

namespace tiretherm::input {

namespace {

namespace fs = std::filesystem;

const SheetCell no_cell{};
constexpr std::string_view remedy = "give an .xls or .xlsx workbook, or a folder with INFO.csv, PARA.csv and so on";

bool same_name(std::string_view a, std::string_view b) { return a.size() == b.size() && distance(a, b) == 0; }

/// "A", "Z", "AA": the letters of a column that counts from 1.
std::string letters(int column) {
    std::string text;
    for (; column > 0; column = (column - 1) / 26) {
        text.insert(text.begin(), static_cast<char>('A' + (column - 1) % 26));
    }
    return text;
}

/// Gives the cells of a workbook their places: a file for each sheet, so that errors stay in its order.
Sheet placed(RawSheet raw, const std::string& shown, InputErrors& errors) {
    const int file = errors.add_file(fmt::format("{}, {}", shown, raw.name), "");
    Sheet sheet{.name = std::move(raw.name), .place = {.file = file}, .rows = {}};
    for (std::size_t r = 0; r < raw.rows.size(); ++r) {
        std::vector<SheetCell>& row = sheet.rows.emplace_back();
        for (std::size_t c = 0; c < raw.rows[r].size(); ++c) {
            row.push_back(
                {.text = std::string(trim(raw.rows[r][c])),
                 .place = {
                     .file = file, .line = static_cast<int>(r) + 1, .column = static_cast<int>(c) + 1, .length = 1}});
        }
    }
    return sheet;
}

constexpr std::uintmax_t largest_book = std::uintmax_t{64} << 20U;  // bytes; a sheet of parameters has kilobytes

/// The workbook by what its first bytes say, or why it is none.
RawBook read_workbook(const fs::path& path) {
    if (ErrorText reason = not_readable(path, largest_book); !reason.what.empty()) {
        return {.sheets = {}, .error = ErrorText{"the file " + reason.what, std::move(reason.remedy)}};
    }
    std::array<char, 4> head{};
    std::ifstream file(path, std::ios::binary);
    if (!file) {
        const int reason = errno;
        const std::string near = nearby_file_remedy(path);
        return {.sheets = {},
                .error = ErrorText{fmt::format("the file cannot be read: {}", std::system_category().message(reason)),
                                   reason != ENOENT ? std::string()
                                   : near.empty()   ? std::string(remedy)
                                                    : near}};
    }
    file.read(head.data(), head.size());
    const std::string_view start(head.data(), static_cast<std::size_t>(file.gcount()));
    if (start.empty()) {
        return {.sheets = {}, .error = ErrorText{"the file is empty", std::string(remedy)}};
    }
    if (start.starts_with("PK")) {
        return read_xlsx(path);
    }
    if (start.starts_with("\xD0\xCF\x11\xE0")) {
        return read_xls(path);
    }
    if (path.extension() == ".csv") {
        return {.sheets = {},
                .error = ErrorText{"a single CSV file is not the whole spreadsheet",
                                   "put one CSV file for each sheet into a folder and give the folder"}};
    }
    return {.sheets = {}, .error = ErrorText{"the file is not a spreadsheet", std::string(remedy)}};
}

}  // namespace

const SheetCell& Sheet::at(std::size_t row, std::size_t column) const {
    return row < rows.size() && column < rows[row].size() ? rows[row][column] : no_cell;
}

const Sheet* SheetBook::find(std::string_view name) const {
    const auto found = std::find_if(sheets.begin(), sheets.end(),
                                    [&](const Sheet& sheet) { return same_name(trim(sheet.name), name); });
    return found == sheets.end() ? nullptr : &*found;
}

std::string cell_text(double number) { return fmt::format("{}", number); }

std::optional<SheetBook> read_sheet_book(const fs::path& path, InputErrors& errors) {
    SheetBook book{.shown = path.generic_string(), .is_folder = false, .sheets = {}};
    std::error_code error;
    if (fs::is_directory(path, error)) {
        book.is_folder = true;
        const std::size_t before = errors.count();
        book.sheets = read_csv_sheets(path, errors);
        if (book.sheets.empty() && errors.count() == before) {
            errors.add({.file = errors.add_file(book.shown, "")}, "there is no CSV file in the folder",
                       std::string(remedy));
            return std::nullopt;
        }
        return book;
    }
    RawBook raw = read_workbook(path);
    if (raw.error) {
        errors.add({.file = errors.add_file(book.shown, "")}, *raw.error);
        return std::nullopt;
    }
    for (RawSheet& sheet : raw.sheets) {
        book.sheets.push_back(placed(std::move(sheet), book.shown, errors));
        book.sheets.back().hides_formulas = raw.hides_formulas;
    }
    return book;
}

std::string spell(const SheetBook& book, const Sheet& sheet, const SourceLocation& place, const InputErrors& errors) {
    return book.is_folder ? errors.spell(place) : fmt::format("{}!{}{}", sheet.name, letters(place.column), place.line);
}

std::vector<InputError> with_cells(std::vector<InputError> errors, const SheetBook& book) {
    for (InputError& error : errors) {
        if (!book.is_folder && error.line > 0) {
            error.file += fmt::format("!{}{}", letters(error.column), error.line);
            error.line = error.column = error.length = 0;
        }
    }
    return errors;
}

}  // namespace tiretherm::input
