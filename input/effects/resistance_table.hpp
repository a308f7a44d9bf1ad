// SPDX-License-Identifier: BSD-3-Clause
// File of measured rolling resistance: force or power over speed, load, pressure and temperature, one row for each grid
// point.
#pragma once

#include <filesystem>
#include <optional>

#include "input/columns/grid_rows.hpp"

namespace tiretherm::input {

/// @param mentioned where the case names the file  @returns nothing after an error
[[nodiscard]] std::optional<GridFile> read_resistance_table(const std::filesystem::path& path,
                                                            const SourceLocation& mentioned, InputErrors& errors);

}  // namespace tiretherm::input
