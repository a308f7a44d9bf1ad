// SPDX-License-Identifier: BSD-3-Clause
// The name of a run that has none of its own.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace tiretherm::input {

/// The part of a run's name that tells it from other laps of its file: "_lap_4", "_laps_3-9", "_laps_2_4-6".
/// @param laps as the case writes it  @returns empty without a choice of laps
[[nodiscard]] std::string name_of_laps(std::string_view laps);

/// What a run is called that has no `name`: "session", "session_laps_3-9".
/// @param laps empty: the whole file
[[nodiscard]] std::string run_name(const std::filesystem::path& file, std::string_view laps);

}  // namespace tiretherm::input
