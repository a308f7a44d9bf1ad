// SPDX-License-Identifier: BSD-3-Clause
// HDF5 datasets of one or several dimensions; packed values follow the CF conventions (scale_factor, add_offset,
// _FillValue).
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "input/tables/columns.hpp"
#include "input/text/input_error.hpp"

namespace tiretherm::input {

/// A dataset of numbers in one dimension, with its attribute `units`.
struct Dataset {
    Heading heading;
    std::vector<double> values;
};

/// The datasets of a file's root; where it has none, those of its last group that has any.
struct Datasets {
    std::vector<Dataset> found;
    std::vector<std::string> groups;  ///< that have any; empty when the root has
    std::vector<ErrorText> defects;   ///< of datasets whose values cannot be had
};

/// Why a file cannot be opened as HDF5; empty for one that can.
[[nodiscard]] ErrorText hdf5_defect(const std::filesystem::path& path);

/// @pre hdf5_defect says nothing. Of a file that tiretherm wrote only the channels are looked at.
[[nodiscard]] Datasets read_datasets(const std::filesystem::path& path);

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
