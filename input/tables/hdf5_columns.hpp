// SPDX-License-Identifier: BSD-3-Clause
// Columns of an HDF5 file: one-dimensional datasets with the attribute `units`, in the root or in one group.
#pragma once

#include <filesystem>
#include <optional>

#include "input/tables/log_table.hpp"

namespace tiretherm::input {

/// The columns of an HDF5 file: datasets of numbers in one dimension and of one length, each with its unit in an
/// attribute `units`, all in the root or all in one group. Of a file that tiretherm wrote, its channels.
/// @pre hdf5_defect says nothing  @param errors of this file alone  @returns nothing after an error
[[nodiscard]] std::optional<LogTable> read_hdf5_columns(const std::filesystem::path& path, InputErrors& errors);

}  // namespace tiretherm::input
