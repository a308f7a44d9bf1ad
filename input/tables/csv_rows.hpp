// SPDX-License-Identifier: BSD-3-Clause
// The rows of a text of numbers: which lines they are, and the numbers in them.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "input/tables/csv.hpp"

namespace tiretherm::input {

/// Goes on to the next line that is neither blank nor a comment, and has not the headings again, as where a logger was started anew.
/// @param names the line of the headings  @param line the last one; out: the next  @returns false at the end
[[nodiscard]] bool next_row(std::string_view& rest, std::string_view names, CsvLine& line);

/// The lines below the headings that have a field for each column.
class CsvRows {
public:
    /// @param text of the file, in which the other texts stand  @param body the lines after the headings
    /// @param first_line number of the first of them  @param names the line of the headings
    CsvRows(std::shared_ptr<const std::string> text, std::string_view body, int first_line, char separator,
            std::string_view names)
        : text_(std::move(text)), body_(body), names_(names), first_line_(first_line), separator_(separator) {}

    /// Parses the columns in one pass over the text.
    /// @param columns with their heads  @param errors for lines with another number of fields, which are no rows
    void parse(std::vector<TableColumn>& columns, InputErrors& errors);

    /// Where a field of a row stands, and its text; of column -1 the row.
    [[nodiscard]] FieldLocation where(std::size_t row, int column) const;

private:
    /// A line with more or fewer fields, which is no row.
    struct Ragged {
        CsvLine line;
        std::size_t fields = 0;
    };
    [[nodiscard]] bool is_row(const std::vector<std::string_view>& fields) const;
    void report(const std::vector<Ragged>& ragged, bool is_log, InputErrors& errors) const;
    [[nodiscard]] CsvLine line_of(std::size_t row) const;

    std::shared_ptr<const std::string> text_;
    std::string_view body_;
    std::string_view names_;
    int first_line_ = 0;
    char separator_ = ',';
    std::size_t n_columns_ = 0;
    std::size_t n_rows_ = 0;
    std::vector<CsvLine> marked_;  ///< every so many rows
};

}  // namespace tiretherm::input
