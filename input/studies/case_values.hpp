// SPDX-License-Identifier: BSD-3-Clause
// All values of a case by their paths, to be laid beside those of another case.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace tiretherm::input {

/// The values of a case file and of what it includes, as they are written: "drive.speed", "80 km/h". In lists the name of a
/// table is its key, otherwise its number from 1. Nothing of a file that cannot be read.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> case_values(const std::filesystem::path& file);

}  // namespace tiretherm::input
