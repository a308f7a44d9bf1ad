// SPDX-License-Identifier: BSD-3-Clause
// HDF5 datasets of one dimension, the columns of a file, or of several; packed values follow the CF conventions (scale_factor, add_offset,
// _FillValue).
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "input/tables/log_table.hpp"

namespace tiretherm::input {

/// Why a file cannot be opened as HDF5; empty for one that can.
[[nodiscard]] ErrorText hdf5_defect(const std::filesystem::path& path);

/// The columns of an HDF5 file: datasets of numbers in one dimension and of one length, each with its unit in an
/// attribute `units`, all in the root or all in one group. Of a file that tiretherm wrote, its channels.
/// @pre hdf5_defect says nothing  @param errors of this file alone  @returns nothing after an error
[[nodiscard]] std::optional<LogTable> read_hdf5_columns(const std::filesystem::path& path, InputErrors& errors);

/// A dataset of numbers in several dimensions, read one index of the first of them at a time. Packed numbers are unpacked
/// by the attributes scale_factor and add_offset, and those that equal _FillValue are NaN (CF conventions).
class Hdf5Stack {
public:
    /// @pre hdf5_defect says nothing  @returns nothing where the root has no such dataset of numbers
    /// @param defect out: of a dataset that is there, why its values cannot be had
    [[nodiscard]] static std::optional<Hdf5Stack> open(const std::filesystem::path& path, const std::string& name,
                                                       ErrorText& defect);

    [[nodiscard]] const std::vector<std::size_t>& shape() const { return shape_; }
    /// A text attribute, empty where there is none; one or several numbers, empty likewise.
    [[nodiscard]] std::string text(const std::string& attribute) const;
    [[nodiscard]] std::vector<double> numbers(const std::string& attribute) const;
    /// @param values out, [product of the other dimensions]  @returns false where the file is damaged
    [[nodiscard]] bool read(std::size_t index, std::vector<double>& values) const;

private:
    std::shared_ptr<void> dataset_;  ///< HDF5's handle
    std::vector<std::size_t> shape_;
    double factor_ = 1.0;
    double offset_ = 0.0;
    std::optional<double> fill_;
};

}  // namespace tiretherm::input
