// SPDX-License-Identifier: BSD-3-Clause
// `tiretherm check STUDY`: a study, or a table of measured numbers, where a case is expected.
#pragma once

#include <filesystem>
#include <optional>

namespace tiretherm::app {

/// Checks a study as `tiretherm study` reads it, and refuses a table of measured numbers with the command that reads it.
/// @returns the exit code, nothing where the file is a case or cannot be read
[[nodiscard]] std::optional<int> check_study(const std::filesystem::path& file, bool json);

}  // namespace tiretherm::app
