// SPDX-License-Identifier: BSD-3-Clause
// The name of a run that has none of its own.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace tiretherm::input {

/// The name of a file without its ending and without dots at its beginning: a folder of results is called so, and ".." (of
/// "...csv") would be another one. Never empty.
[[nodiscard]] std::string plain_stem(const std::filesystem::path& file);

/// What a run is called that has no `name`: "session", and to be told from other laps of its file "session_lap_4", "session_laps_3-9",
/// "session_laps_2_4-6".
/// @param laps empty: the whole file
[[nodiscard]] std::string run_name(const std::filesystem::path& file, std::string_view laps);

}  // namespace tiretherm::input
