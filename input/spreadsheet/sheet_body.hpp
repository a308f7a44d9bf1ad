// SPDX-License-Identifier: BSD-3-Clause
// The TOML tables of a converted case, line by line, each with the cell that it came from.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "input/spreadsheet/sheet_case.hpp"
#include "input/spreadsheet/sheet_rows.hpp"

namespace tiretherm::input {

/// The tables of a case made of sheets, line by line, each with the place that it came from.
class SheetBody {
public:
    /// A key of a table. @param lines its value, over several lines where it has several places
    struct Entry {
        std::string table;
        std::string key;
        std::vector<std::string> lines;
        std::vector<SourceLocation> places;  ///< one of each line; file -1: of nothing in the sheets
        std::string remark;                  ///< behind the first line
        std::string called;                  ///< what messages call it
    };
    void add(Entry entry) { entries_.push_back(std::move(entry)); }

    /// The text of the tables, in the order in which a case is read.
    [[nodiscard]] std::string text() const;
    /// What stands in a line of the text, from 1; null for a heading.
    [[nodiscard]] const Entry* entry_at(int line) const;
    [[nodiscard]] SourceLocation place_at(int line) const;

private:
    struct Line {
        std::string text;
        const Entry* entry = nullptr;
        SourceLocation place;
    };
    [[nodiscard]] std::vector<Line> lines() const;

    std::vector<Entry> entries_;
};

/// Fills the tables with what the sheets say and, where they are silent, with the defaults, and lists both.
[[nodiscard]] SheetBody make_sheet_body(const SheetContent& content, SheetCase& result, InputErrors& errors);

/// A law k or c = A T^2 + B T + C, of its three coefficients.
void add_sheet_law(const SheetContent& content, std::string_view law, SheetBody& body, SheetCase& result,
                   InputErrors& errors);

/// The parameters of a law and whether the sheets give any of them.
[[nodiscard]] bool gives_law(const SheetContent& content, std::string_view law);
/// The measured table that takes the place of a law; null where the law is given, or no table.
[[nodiscard]] const SheetMeasured* table_instead(const SheetContent& content, std::string_view law);

}  // namespace tiretherm::input
