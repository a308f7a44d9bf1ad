// SPDX-License-Identifier: BSD-3-Clause
// A table of numbers as its file has it, whatever the file's format is.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "input/loggers/log_description.hpp"
#include "input/tables/column_reader.hpp"

namespace tiretherm::input {

/// The first field of a column with a decimal comma, or with a point.
struct DecimalMark {
    SourceLocation place{};  ///< line 0: there is none
    std::string field{};
};

/// A column as it is written.
struct TableColumn {
    ColumnHead head{};
    std::vector<double> number{};  ///< [rows] in the heading's unit, NaN where no number stands alone; of clocks none
    std::vector<Stamp> stamp{};    ///< [rows] of clocks
    std::vector<std::uint32_t> text{};  ///< rows in which something else stands, ascending
    double rate = 0.0;                  ///< Hz of a channel with its own clock, the k-th number at k / rate; 0: none
    DecimalMark comma{};                ///< none where commas separate the columns
    DecimalMark point{};
};

/// What the columns of a table hold, and what is to be said of its file. Places in it have the file's number 0; each who opens the
/// file has a number of his own for it. It is never changed: all who open the file share it.
struct LogTable {
    /// Where the units of the columns are written.
    enum class Units : std::uint8_t { in_headings, in_attributes, by_name_alone };
    /// What the first column of a table of probes has.
    enum class Moments : std::uint8_t {
        times,   ///< s
        speeds,  ///< m/s, of the steps of a test; a reading was taken at the end of its step
        steps    ///< numbers of the steps, the first is 1; likewise
    };

    LogDescription description{};
    Units units = Units::in_headings;
    Moments moments = Moments::times;
    std::vector<TableColumn> columns{};        ///< of channels with own clocks, the first is `time`, without numbers
    std::shared_ptr<const SourceText> text{};  ///< of a text file
    InputErrors remarks{};                     ///< of whoever opens the file
    InputErrors defects{};                     ///< of whoever reads a column
    /// Where a field stands; of column -1 the row. Not called for channels with own clocks.
    std::function<FieldLocation(std::size_t row, int column)> where{};

    [[nodiscard]] bool has_own_clocks() const { return !columns.empty() && columns.back().rate > 0.0; }
};

}  // namespace tiretherm::input
