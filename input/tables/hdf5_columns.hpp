// SPDX-License-Identifier: BSD-3-Clause
// Columns of an HDF5 file: one-dimensional datasets with the attribute `units`, in the root or in one group.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "input/tables/column_reader.hpp"

namespace tiretherm::input {

/// The columns of an HDF5 file: datasets of numbers in one dimension and of one length, each with its unit in an
/// attribute `units`, all in the root or all in one group. Of a file that tiretherm wrote, its channels.
class Hdf5Columns {
public:
    /// @returns nothing after an error
    [[nodiscard]] static std::optional<Hdf5Columns> open(const std::filesystem::path& path,
                                                         const SourceLocation& mentioned, InputErrors& errors);

    [[nodiscard]] const std::vector<ColumnHead>& heads() const { return heads_; }
    [[nodiscard]] std::vector<ColumnHead>& heads() { return heads_; }
    [[nodiscard]] int number() const { return number_; }
    /// @returns the values of each request, all of one length; none after an error
    [[nodiscard]] std::vector<std::vector<double>> read(const std::vector<ColumnRequest>& requests,
                                                        InputErrors& errors) const;

private:
    int number_ = -1;
    std::vector<ColumnHead> heads_;
    std::vector<std::vector<double>> written_;  ///< [n_heads][n_samples] in the file's units
};

}  // namespace tiretherm::input
