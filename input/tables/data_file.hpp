// SPDX-License-Identifier: BSD-3-Clause
// A file of measured columns, of whatever format, as one reader sees it.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "input/tables/log_table.hpp"

namespace tiretherm::input {

/// A file of measured columns: HDF5 where its name ends in .h5 or .hdf5, MoTeC .ld and iRacing .ibt by their first bytes,
/// otherwise text: a table of probes, or columns of any of the loggers that `read_csv` knows. The table is shared by all that
/// open the file with the same errors, their copies or those that share their tables; headings and rows are this reader's own.
class DataFile {
public:
    /// @param mentioned where the case names it; file -1 when it was given beside the case
    /// @returns nothing after an error
    [[nodiscard]] static std::optional<DataFile> open(const std::filesystem::path& path,
                                                      const SourceLocation& mentioned, InputErrors& errors);

    [[nodiscard]] const std::vector<ColumnHead>& heads() const { return heads_; }
    [[nodiscard]] std::vector<ColumnHead>& heads() { return heads_; }
    [[nodiscard]] int number() const { return number_; }  ///< of the file in the errors
    [[nodiscard]] int find(std::string_view name) const;  ///< index of a heading, -1 when absent
    [[nodiscard]] const LogTable& table() const { return *table_; }
    [[nodiscard]] const LogDescription& description() const { return table_->description; }
    [[nodiscard]] bool is_text() const { return table_->text != nullptr; }
    /// Of channels with clocks of their own, those whose times the rows are to have, all at first; of other files all rows stay.
    void choose_rows(const std::vector<int>& columns);
    /// Puts times in the place of the speeds or numbers of steps in a table of probes. @param times s, one for each row
    void take_times(std::vector<double> times);
    /// A request of a column whose unit the case can give, with what to do about one that is missing or wrong.
    [[nodiscard]] ColumnRequest request(int column, std::string name, const QuantitySpec& spec,
                                        Purpose purpose = Purpose::measured) const;
    /// Where a row of values stands; the first is 0.
    [[nodiscard]] FieldLocation spot(std::size_t row) const { return spot(row, -1, 0.0); }
    /// @returns the values of each request, all of one length; none after an error
    [[nodiscard]] std::vector<std::vector<double>> read(const std::vector<ColumnRequest>& requests,
                                                        InputErrors& errors) const;

    /// A column as it is written, with what is missing.
    struct Samples {
        std::vector<double> time;   ///< [n] s
        std::vector<double> value;  ///< [n], NaN where there is none
    };
    /// The samples of a column at their own times. @param time of the rows, s  @returns none where the file has other rows
    [[nodiscard]] Samples samples(int column, const std::vector<double>& time, const InputErrors& errors) const;

private:
    [[nodiscard]] std::string unit_remedy(const ColumnHead& head, const QuantitySpec& spec) const;
    [[nodiscard]] FieldLocation spot(std::size_t row, int column, double written) const;
    /// The numbers of a column as it is asked for, in the rows of this reader.
    /// @param room of the result, where they are not those that are written
    [[nodiscard]] const std::vector<double>& numbers_of(const ColumnRequest& request, std::vector<double>& room,
                                                        InputErrors& errors) const;
    [[nodiscard]] std::vector<double> read_column(const ColumnRequest& request, InputErrors& errors) const;
    [[nodiscard]] std::vector<std::vector<double>> read_columns(const std::vector<ColumnRequest>& requests,
                                                                InputErrors& errors) const;

    int number_ = -1;
    std::shared_ptr<const LogTable> table_;
    std::vector<ColumnHead> heads_;
    std::vector<double>
        times_{};  ///< s, of the rows where the table has none: channels with own clocks, steps of a test
};

}  // namespace tiretherm::input
