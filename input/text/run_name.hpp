// SPDX-License-Identifier: BSD-3-Clause
// The name of a run that has none of its own.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace tiretherm::input {

/// What a run is called that has no `name`: "session", and to be told from other laps of its file "session_lap_4", "session_laps_3-9",
/// "session_laps_2_4-6".
/// @param laps empty: the whole file
[[nodiscard]] std::string run_name(const std::filesystem::path& file, std::string_view laps);

}  // namespace tiretherm::input
