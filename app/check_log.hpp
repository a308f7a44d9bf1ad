// SPDX-License-Identifier: BSD-3-Clause
// `tiretherm check LOG`: says what is in a data logger's file.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "input/new_case/log_columns.hpp"

namespace tiretherm::app {

/// Prints format, channels, laps and doubts of a file, or what keeps it from being read. @returns the exit code
/// @param units COLUMN=UNIT, as the user types them
[[nodiscard]] int check_log(const std::filesystem::path& path, const std::vector<std::string>& units, bool json);

/// COLUMN=UNIT, at the last sign. @returns nothing after an error, which has been reported
[[nodiscard]] std::optional<std::vector<input::GivenUnit>> given_units(const std::vector<std::string>& words,
                                                                       bool json);

}  // namespace tiretherm::app
