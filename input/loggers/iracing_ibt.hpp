// SPDX-License-Identifier: BSD-3-Clause
// Files .ibt of the simulator iRacing: a head, descriptions of the channels, rows of all channels at one rate.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "input/tables/log_table.hpp"

namespace tiretherm::input {

/// Whether the first bytes of a file are those of an iRacing .ibt file.
[[nodiscard]] bool is_iracing_ibt(std::string_view first_bytes);

/// Reads head, descriptions and rows. Layout by the simulator's published interface
/// (irsdk_header, irsdk_diskSubHeader, irsdk_varHeader): version at byte 0, rows per second at 8, length and address of the
/// session's description (YAML) at 16 and 20, number and address of the channels' descriptions at 24 and 28, length of a row at 36,
/// address of the rows at 52; a description of 144 bytes has type, place in the row and count at 0, 4 and 8, name, text and
/// unit at 16, 48 and 112. Numbers in % are shares of 1 in the file. Bits, letters and lists (of all cars, or of times within a
/// row) are no channels.
/// @param errors of this file alone
/// @returns nothing after an error: what the head announces lies beyond the end of the file
[[nodiscard]] std::optional<LogTable> read_iracing_ibt(const std::string& bytes, const std::filesystem::path& path,
                                                       InputErrors& errors);

}  // namespace tiretherm::input
