// SPDX-License-Identifier: BSD-3-Clause
// Finds the file that was probably meant by a path that leads nowhere.
#pragma once

#include <filesystem>
#include <string>

namespace tiretherm::input {

/// The path with the nearest names that there are in place of those that are missing, folders included, and with an ending
/// that was left out. @returns empty for a path that exists, and where nothing is near
[[nodiscard]] std::filesystem::path nearby_file(const std::filesystem::path& path);

/// "did you mean `...`?" with the whole path, for one that stands on the command line; or empty.
[[nodiscard]] std::string nearby_file_remedy(const std::filesystem::path& path);

}  // namespace tiretherm::input
