// SPDX-License-Identifier: BSD-3-Clause
// The file .ldx that MoTeC i2 writes beside a .ld file: XML with the beacons between laps.
#pragma once

#include <filesystem>
#include <vector>

namespace tiretherm::input {

/// Where the beacons of a .ld file stand: beside it.
[[nodiscard]] std::filesystem::path ldx_file(const std::filesystem::path& ld_file);

/// Times of the beacons, the elements Marker of class BCN, in microseconds. Empty where there is no such file or none
/// can be read: the laps may stand in a channel.
/// @param ld_file path of the .ld file  @returns s, ascending
[[nodiscard]] std::vector<double> read_ldx_markers(const std::filesystem::path& ld_file);

}  // namespace tiretherm::input
