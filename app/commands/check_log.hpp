// SPDX-License-Identifier: BSD-3-Clause
// `tiretherm check LOG`: says what is in a data logger's file.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace tiretherm::app {

/// Prints format, channels, laps and doubts of a file, or what keeps it from being read. @returns the exit code
/// @param units COLUMN=UNIT, as the user types them
[[nodiscard]] int check_log(const std::filesystem::path& path, const std::vector<std::string>& units, bool json);

}  // namespace tiretherm::app
