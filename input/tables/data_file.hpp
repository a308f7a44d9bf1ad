// SPDX-License-Identifier: BSD-3-Clause
// A file of measured columns, CSV or HDF5, behind one interface.
#pragma once

#include <filesystem>
#include <memory>
#include <variant>

#include "input/tables/csv.hpp"
#include "input/tables/hdf5_columns.hpp"

namespace tiretherm::input {

/// A file of measured columns: HDF5 where its name ends in .h5 or .hdf5, otherwise CSV.
class DataFile {
public:
    /// @param mentioned where the case names it; file -1 when it was given beside the case
    /// @returns nothing after an error
    [[nodiscard]] static std::optional<DataFile> open(const std::filesystem::path& path,
                                                      const SourceLocation& mentioned, InputErrors& errors);

    [[nodiscard]] const std::vector<ColumnHead>& heads() const;
    [[nodiscard]] std::vector<ColumnHead>& heads();
    [[nodiscard]] int number() const { return number_; }  ///< of the file in the errors
    /// What to do about a column whose unit is missing or wrong.
    [[nodiscard]] std::string unit_remedy(const ColumnHead& head, const QuantitySpec& spec) const;
    /// Where a row of values stands; the first is 0.
    [[nodiscard]] ColumnReader::FieldLocation spot(std::size_t row) const;
    [[nodiscard]] bool is_text() const { return std::holds_alternative<Csv>(columns_); }
    /// @returns the values of each request, all of one length; none after an error
    [[nodiscard]] std::vector<std::vector<double>> read(const std::vector<ColumnRequest>& requests,
                                                        InputErrors& errors) const;

private:
    static std::optional<DataFile> open_any(const std::filesystem::path& path, const SourceLocation& mentioned,
                                            InputErrors& errors);

    int number_ = -1;
    std::unique_ptr<TextFile> text_;  ///< of a CSV, which keeps no text of its own
    std::variant<Csv, Hdf5Columns> columns_;
};

}  // namespace tiretherm::input
