// SPDX-License-Identifier: BSD-3-Clause
// Reads the spreadsheet from a folder with one CSV file for each sheet.

#include <algorithm>
#include <array>
#include <system_error>

#include "input/spreadsheet/sheet_formats.hpp"
#include "input/tables/csv.hpp"
#include "input/text/suggestions.hpp"

namespace tiretherm::input {

namespace {

namespace fs = std::filesystem;

/// The separator that stands in most lines: a note may hold any of them.
char separator_in(std::string_view text) {
    constexpr std::array<char, 3> candidates{'\t', ';', ','};
    std::array<int, 3> lines{};
    while (const auto line = next_line(text)) {
        for (std::size_t i = 0; i < candidates.size(); ++i) {
            lines[i] += line->find(candidates[i]) == std::string_view::npos ? 0 : 1;
        }
    }
    return candidates[static_cast<std::size_t>(std::max_element(lines.begin(), lines.end()) - lines.begin())];
}

Sheet sheet_of(const TextFile& file, std::string name) {
    Sheet sheet{.name = std::move(name), .place = {.file = file.number}, .rows = {}};
    std::string_view rest = file.text;
    if (rest.starts_with("\xEF\xBB\xBF")) {
        rest.remove_prefix(3);
    }
    const char separator = separator_in(rest);
    std::vector<std::string_view> fields;
    for (int number = 1; const auto line = next_line(rest); ++number) {
        std::vector<SheetCell>& row = sheet.rows.emplace_back();
        split_fields(*line, separator, fields);
        int column = 1;
        const char* from = line->data();
        for (const std::string_view field : fields) {
            column += count_characters({from, static_cast<std::size_t>(field.data() - from)});
            from = field.data();
            row.push_back({.text = std::string(field),
                           .place = {.file = file.number,
                                     .line = number,
                                     .column = column,
                                     .length = std::max(1, count_characters(field))}});
        }
    }
    return sheet;
}

}  // namespace

std::vector<Sheet> read_csv_sheets(const fs::path& folder, InputErrors& errors) {
    std::vector<fs::path> files;
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
        std::string extension = entry.path().extension().string();
        if (distance(extension, ".csv") == 0 && entry.is_regular_file(error)) {
            files.push_back(entry.path());
        }
    }
    if (error) {
        errors.add({.file = errors.add_file(folder.generic_string(), "")},
                   "the folder cannot be read: " + error.message());
    }
    std::sort(files.begin(), files.end());
    std::vector<Sheet> sheets;
    for (const fs::path& path : files) {
        if (const std::optional<TextFile> file = read_text(path, {}, errors)) {
            sheets.push_back(sheet_of(*file, path.stem().string()));
        } else {
            // What is wrong with the file has been said; it is not missing as well.
            sheets.push_back({.name = path.stem().string(), .place = {}, .rows = {}});
        }
    }
    return sheets;
}

}  // namespace tiretherm::input
