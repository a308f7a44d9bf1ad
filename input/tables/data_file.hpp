// SPDX-License-Identifier: BSD-3-Clause
// A file of measured columns, CSV, a table of probes, HDF5 or a logger's binary file, behind one interface.
#pragma once

#include <filesystem>
#include <memory>
#include <variant>

#include "input/loggers/channel_table.hpp"
#include "input/tables/csv.hpp"
#include "input/tables/hdf5_columns.hpp"
#include "input/tables/probe_table.hpp"

namespace tiretherm::input {

/// A file of measured columns: HDF5 where its name ends in .h5 or .hdf5, MoTeC .ld and iRacing .ibt by their first bytes,
/// otherwise text: a table of probes (ProbeTable), or columns of any of the loggers that Csv knows.
class DataFile {
public:
    /// @param mentioned where the case names it; file -1 when it was given beside the case
    /// @returns nothing after an error
    [[nodiscard]] static std::optional<DataFile> open(const std::filesystem::path& path,
                                                      const SourceLocation& mentioned, InputErrors& errors);

    [[nodiscard]] const std::vector<ColumnHead>& heads() const;
    [[nodiscard]] std::vector<ColumnHead>& heads();
    [[nodiscard]] int number() const { return number_; }  ///< of the file in the errors
    [[nodiscard]] int find(std::string_view name) const;  ///< index of a heading, -1 when absent
    [[nodiscard]] const LogDescription& description() const;
    /// Of channels with rates of their own, those whose times the rows are to have; of other files all rows stay.
    void choose_rows(const std::vector<int>& columns);
    /// The channels with rates of their own; null where all columns have the same times.
    [[nodiscard]] const ChannelTable* channel_table() const { return std::get_if<ChannelTable>(&columns_); }
    /// The table whose lines are probes; null for columns.
    [[nodiscard]] ProbeTable* probe_table() { return std::get_if<ProbeTable>(&columns_); }
    /// What to do about a column whose unit is missing or wrong.
    [[nodiscard]] std::string unit_remedy(const ColumnHead& head, const QuantitySpec& spec) const;
    /// Where a row of values stands; the first is 0.
    [[nodiscard]] ColumnReader::FieldLocation spot(std::size_t row) const;
    [[nodiscard]] bool is_text() const { return text_ != nullptr; }
    /// Of a text, parses all columns in one pass: for those who will read most of them, one after the other.
    void parse_all() const;
    /// @param last whether they are read for the last time, so that what was parsed of a text is let go column by column
    /// @returns the values of each request, all of one length; none after an error
    [[nodiscard]] std::vector<std::vector<double>> read(const std::vector<ColumnRequest>& requests, InputErrors& errors,
                                                        bool last = false) const;

private:
    static std::optional<DataFile> open_any(const std::filesystem::path& path, const SourceLocation& mentioned,
                                            InputErrors& errors);

    int number_ = -1;
    std::shared_ptr<const std::string> text_;  ///< of a CSV or a table of probes, which keep no text of their own
    std::variant<Csv, Hdf5Columns, ChannelTable, ProbeTable> columns_;
};

}  // namespace tiretherm::input
