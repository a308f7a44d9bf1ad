// SPDX-License-Identifier: BSD-3-Clause
// Reader of the text files of data loggers (headings with units; comma, semicolon or tab as separator), and their lines and fields.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "input/tables/log_table.hpp"

namespace tiretherm::input {

/// A line of a file, without its end.
struct CsvLine {
    std::string_view text;
    int number = 0;
};
/// Where a field of a line stands, in a file with the number 0.
[[nodiscard]] SourceLocation place_in(const CsvLine& line, std::string_view field);

/// Reads a logger's text: headings `name [unit]` in one line, or names in one line and units in the next, then numbers,
/// separated by commas, semicolons or tabs. Lines about the recording may stand above the headings. A byte order mark,
/// carriage returns, quotes round a field, blank lines and lines of comment (# or //) are accepted. Where semicolons or tabs
/// separate, numbers may have decimal commas; a file has these or points. Files of AiM, MoTeC, RaceChrono and VBOX are known
/// by their first lines. A long text is let go.
/// @param errors of this file alone  @returns nothing after an error
[[nodiscard]] std::optional<LogTable> read_csv(const std::shared_ptr<const SourceText>& source, InputErrors& errors);

/// A number with a decimal comma, as the same with a point: "-1,5e3"; every other text as it is. @param room of the result
[[nodiscard]] std::string_view with_point(std::string_view field, std::string& room);

/// Characters of a UTF-8 text; a stray byte counts as a character.
[[nodiscard]] int count_characters(std::string_view text);

/// Takes the next line off a text; nothing at its end.
/// @errors solver::Interrupted where reading may be interrupted
[[nodiscard]] std::optional<std::string_view> next_line(std::string_view& text);
/// Whether a line has nothing but blanks, separators and quotes: spreadsheets write the empty lines of a table so.
[[nodiscard]] bool is_blank(std::string_view line);
/// The next line that is not blank, which is counted on from `last`; without number at the end of the text.
[[nodiscard]] CsvLine next_filled_line(std::string_view& text, int last);
/// The next line that is not empty; one of separators alone has empty fields, and counts.
[[nodiscard]] CsvLine next_written_line(std::string_view& text, int last);
/// Splits a line at the separators; quotes and blanks round a field are taken off. Within quotes nothing separates.
void split_fields(std::string_view line, char separator, std::vector<std::string_view>& fields);
/// Whether a field is empty, or says in words or dashes that nothing was measured: n/a, null, -, --.
[[nodiscard]] bool is_no_reading(std::string_view field);
/// Which separator a line of headings uses; a comma when there is only one heading.
[[nodiscard]] char separator_of(std::string_view headings);

/// The line that names the columns, and the line of their units where there is one.
struct HeadLines {
    CsvLine names;
    CsvLine units;          ///< without number: none
    std::string_view body;  ///< what follows
};
/// Headings with a unit in brackets stand in the first line. Otherwise it is the first line of names that a line of as
/// many numbers follows, or one of as many units and then one of numbers. Where there is none: the first line.
[[nodiscard]] HeadLines find_head_lines(std::string_view text);

}  // namespace tiretherm::input
