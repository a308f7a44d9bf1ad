// SPDX-License-Identifier: BSD-3-Clause
// The rows of a CSV file, of which each number is parsed once, however often its column is read.
#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "input/tables/column_reader.hpp"

namespace tiretherm::input {

/// A line of a file, without its end.
struct CsvLine {
    std::string_view text;
    int number = 0;
};

/// Goes on to the next line that is neither blank nor a comment, and has not the headings again, as where a logger was started anew.
/// @param names the line of the headings  @param line the last one; out: the next  @returns false at the end
[[nodiscard]] bool next_row(std::string_view& rest, std::string_view names, CsvLine& line);

/// The lines below the headings that have a field for each column. All that open the file with the same InputErrors share them:
/// the corners of a car, a case's passes over its log. Keeps no text of its own: the file must outlive it.
class CsvRows {
public:
    /// @param body the lines after the headings  @param first_line number of the first of them
    /// @param names the line of the headings
    CsvRows(std::string_view body, int first_line, char separator, std::string_view names, std::size_t n_columns)
        : body_(body), names_(names), first_line_(first_line), separator_(separator), n_columns_(n_columns) {}

    /// The first field of a column with a decimal comma, or with a point.
    struct Mark {
        std::string_view field;  ///< empty: none
        CsvLine line{{}, std::numeric_limits<int>::max()};
    };
    struct Column {
        FieldForm form = FieldForm::number;
        std::vector<double> number{};       ///< [size()] as written; NaN where no number stands alone; of clocks none
        std::vector<Stamp> stamp{};         ///< [size()] of clocks
        std::vector<std::uint32_t> text{};  ///< rows in which something else stands, ascending
        Mark comma{};                       ///< none where commas separate the columns
        Mark point{};
    };
    /// Parses those of the columns that have not been parsed, all in one pass over the text.
    void parse(const std::vector<int>& columns, const std::vector<ColumnHead>& heads);
    /// Lets go of a column.
    void forget(int column) {
        const std::lock_guard lock(parsing_);
        columns_.erase(column);
    }

    // After that:
    [[nodiscard]] const Column& column(int index) const {
        const std::lock_guard lock(parsing_);
        return columns_.at(index);
    }
    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] CsvLine row(std::size_t index) const;
    [[nodiscard]] std::string_view field(const CsvLine& row, int column) const;

    /// A line with more or fewer fields, which is no row.
    struct Ragged {
        CsvLine line;
        std::size_t fields = 0;
    };
    [[nodiscard]] const std::vector<Ragged>& ragged() const { return ragged_; }

    /// Lines that have been split into fields: what reading has cost so far.
    [[nodiscard]] std::size_t lines_split() const { return lines_split_; }

private:
    [[nodiscard]] bool is_row(const std::vector<std::string_view>& fields) const;

    std::string_view body_;
    std::string_view names_;
    int first_line_ = 0;
    char separator_ = ',';
    std::size_t n_columns_ = 0;
    mutable std::mutex parsing_;  ///< variants of a case are read in several threads
    std::map<int, Column> columns_;
    std::vector<CsvLine> marked_;  ///< every so many rows
    std::size_t size_ = 0;
    std::vector<Ragged> ragged_;
    std::size_t lines_split_ = 0;
};

}  // namespace tiretherm::input
