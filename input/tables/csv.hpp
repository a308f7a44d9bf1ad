// SPDX-License-Identifier: BSD-3-Clause
// Reader of CSV files from data loggers: headings with units, comma, semicolon or tab as separator.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "input/loggers/log_description.hpp"
#include "input/tables/csv_rows.hpp"
#include "input/toml/document.hpp"

namespace tiretherm::input {

/// A logger's file: headings `name [unit]` in one line, or names in one line and units in the next, then numbers,
/// separated by commas, semicolons or tabs. Lines about the recording may stand above the headings. A byte order mark,
/// carriage returns, quotes round a field, blank lines and lines of comment (# or //) are accepted. Where semicolons or tabs
/// separate, numbers may have decimal commas; a file has these or points. Files of AiM, MoTeC, RaceChrono and VBOX are known
/// by their first lines.
/// Keeps no text of its own: the file must outlive it.
class Csv {
public:
    /// Reads the headings; nothing after an error.
    [[nodiscard]] static std::optional<Csv> open(const TextFile& file, InputErrors& errors);

    [[nodiscard]] const std::vector<ColumnHead>& heads() const { return heads_; }
    [[nodiscard]] std::vector<ColumnHead>& heads() { return heads_; }
    [[nodiscard]] int find(std::string_view name) const;  ///< index of a heading, -1 when absent
    [[nodiscard]] const LogDescription& description() const { return description_; }

    /// @param last lets go of what was parsed of a column when it has been read
    /// @returns the values of each request, all of one length; none after an error
    [[nodiscard]] std::vector<std::vector<double>> read(const std::vector<ColumnRequest>& requests, InputErrors& errors,
                                                        bool last) const;

    /// Parses all columns in one pass.
    void parse_all() const;

    /// Where a row of values stands; the first is 0.
    [[nodiscard]] SourceLocation row(std::size_t index) const;

    using Line = CsvLine;
    [[nodiscard]] SourceLocation place(const Line& line, std::string_view field) const;
    [[nodiscard]] bool separates_by_commas() const { return separator_ == ','; }

private:
    void read_heads(const struct CsvLayout& layout);
    void read_units(const struct CsvLayout& layout);
    /// The fields of a column down the file, until `take` returns false or a line has no such field.
    void visit_column(std::size_t column, const std::function<bool(std::string_view)>& take) const;
    /// Which columns hold clocks, and which is the file's time.
    void find_clocks();
    /// The numbers of a column as it is asked for, where they are not those that are written: times of clocks, and times in
    /// numbers that are too coarse for all the lines.
    [[nodiscard]] std::optional<std::vector<double>> times_of(const ColumnRequest& request, InputErrors& errors) const;
    /// What is wrong with the lines of the file.
    void report_lines(InputErrors& errors) const;
    /// Of all fields of a line in one pass: a line may have a hundred thousand of them.
    [[nodiscard]] std::vector<SourceLocation> places(const Line& line,
                                                     const std::vector<std::string_view>& fields) const;

    std::string_view names_;  ///< the line of the headings
    std::string_view body_;   ///< the lines after them
    std::shared_ptr<CsvRows> rows_;
    int file_ = -1;
    char separator_ = ',';
    LogDescription description_;
    std::vector<ColumnHead> heads_;
};

/// A number with a decimal comma, as the same with a point: "-1,5e3"; every other text as it is. @param room of the result
[[nodiscard]] std::string_view with_point(std::string_view field, std::string& room);

/// Characters of a UTF-8 text; a stray byte counts as a character.
[[nodiscard]] int count_characters(std::string_view text);

/// Takes the next line off a text; nothing at its end.
[[nodiscard]] std::optional<std::string_view> next_line(std::string_view& text);
/// Whether a line has nothing but blanks, separators and quotes: spreadsheets write the empty lines of a table so.
[[nodiscard]] bool is_blank(std::string_view line);
/// The next line that is not blank, which is counted on from `last`; without number at the end of the text.
[[nodiscard]] Csv::Line next_filled_line(std::string_view& text, int last);
/// The next line that is not empty; one of separators alone has empty fields, and counts.
[[nodiscard]] Csv::Line next_written_line(std::string_view& text, int last);
/// Splits a line at the separators; quotes and blanks round a field are taken off. Within quotes nothing separates.
void split_fields(std::string_view line, char separator, std::vector<std::string_view>& fields);
/// Which separator a line of headings uses; a comma when there is only one heading.
[[nodiscard]] char separator_of(std::string_view headings);

/// The line that names the columns, and the line of their units where there is one.
struct HeadLines {
    Csv::Line names;
    Csv::Line units;        ///< without number: none
    std::string_view body;  ///< what follows
};
/// Headings with a unit in brackets stand in the first line. Otherwise it is the first line of names that a line of as
/// many numbers follows, or one of as many units and then one of numbers. Where there is none: the first line.
[[nodiscard]] HeadLines find_head_lines(std::string_view text);

}  // namespace tiretherm::input
