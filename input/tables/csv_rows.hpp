// SPDX-License-Identifier: BSD-3-Clause
// The rows of a text of numbers: which lines they are, and the numbers in them.
#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "input/tables/csv.hpp"
#include "input/text/source_text.hpp"

namespace tiretherm::input {

/// Goes on to the next line that is neither blank nor a comment, and has not the headings again, as where a logger was started anew.
/// @param names the line of the headings  @param line the last one; out: the next  @returns false at the end
[[nodiscard]] bool next_row(std::string_view& rest, std::string_view names, CsvLine& line);

/// The lines below the headings that have a field for each column.
class CsvRows {
public:
    /// @param source the file's text  @param body of it the lines after the headings
    /// @param first_line number of the first of them  @param names the line of the headings
    CsvRows(std::shared_ptr<const SourceText> source, std::string_view body, int first_line, char separator,
            std::string names)
        : source_(std::move(source)),
          body_(static_cast<std::size_t>(body.data() - source_->get()->data())),
          names_(std::move(names)),
          first_line_(first_line),
          separator_(separator) {}

    /// Parses the columns in one pass over the text.
    /// @param columns with their heads  @param errors for lines with another number of fields, which are no rows
    void parse(std::vector<TableColumn>& columns, InputErrors& errors);

    /// Calls `take` with the line and the fields of each row.
    template <typename Take>
    void each(const Take& take) const {
        each(take, [](const CsvLine& /*line*/, const std::vector<std::string_view>& /*fields*/) {});
    }

    /// Where a field of a row stands, and its text; of column -1 the row. Nowhere in a file that has been changed meanwhile.
    [[nodiscard]] FieldLocation where(std::size_t row, int column) const;

private:
    /// A line with more or fewer fields, which is no row.
    struct Ragged {
        CsvLine line;
        std::size_t fields = 0;
    };
    [[nodiscard]] bool is_row(const std::vector<std::string_view>& fields) const;
    /// @param leave is called in the place of `take` for lines that are no rows
    template <typename Take, typename Leave>
    void each(const Take& take, const Leave& leave) const {
        const std::shared_ptr<const std::string> text = source_->get();
        std::string_view rest = std::string_view(*text).substr(std::min(body_, text->size()));
        std::vector<std::string_view> fields;
        for (CsvLine line{{}, first_line_ - 1}; next_row(rest, names_, line);) {
            split_fields(line.text, separator_, fields);
            is_row(fields) ? take(line, fields) : leave(line, fields);
        }
    }
    /// @param end of the text
    void report(const std::vector<Ragged>& ragged, const char* end, bool is_log, InputErrors& errors) const;
    /// Where a line that was marked begins, from the start of the text on.
    struct Mark {
        std::size_t begin = 0;
        int number = 0;
    };
    /// @param text of the file
    [[nodiscard]] CsvLine line_of(std::size_t row, std::string_view text) const;

    std::shared_ptr<const SourceText> source_;
    std::size_t body_;  ///< where it begins in the text
    std::string names_;
    int first_line_ = 0;
    char separator_ = ',';
    bool has_commas_ = false;  ///< numbers may have decimal commas
    std::size_t n_columns_ = 0;
    std::size_t n_rows_ = 0;
    std::vector<Mark> marked_;  ///< every so many rows
};

}  // namespace tiretherm::input
