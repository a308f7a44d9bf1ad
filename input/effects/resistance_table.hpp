// SPDX-License-Identifier: BSD-3-Clause
// File of measured rolling resistance: force or power over speed, load, pressure and temperature, one row for each grid
// point.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "input/text/input_error.hpp"
#include "physics/tire_laws/measured_loss.hpp"

namespace tiretherm::input {

/// A drum's table as it was read.
struct ResistanceFile {
    physics::ResistanceTable table;
    std::vector<std::string> names;  ///< [axes]
};

/// @param mentioned where the case names the file  @returns nothing after an error
[[nodiscard]] std::optional<ResistanceFile> read_resistance_table(const std::filesystem::path& path,
                                                                  const SourceLocation& mentioned, InputErrors& errors);

}  // namespace tiretherm::input
