// SPDX-License-Identifier: BSD-3-Clause
// Files .ld of MoTeC loggers: a header, and a linked list of channels with a rate, a type and a scale each.
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

#include "input/tables/log_table.hpp"

namespace tiretherm::input {

/// Whether the first bytes of a file are those of a MoTeC .ld file.
[[nodiscard]] bool is_motec_ld(std::string_view first_bytes);

/// Reads the header, the channels' records and their samples. Layout by public descriptions of
/// the format: header 64 at byte 0, the first record's address at 8, the data's at 12; a record of 124 bytes has the addresses
/// of its neighbours and of its samples, their count, type, size and rate, shift, multiplier, scale and decimals, name, short name
/// and unit. A value is (sample / scale / 10^decimals + shift) multiplier.
/// The marks between laps are read from the file .ldx beside it where there is one.
/// @param bytes of the whole file  @param path for the file beside it  @param errors of this file alone
/// @returns nothing after an error: a record or samples beyond the end of the file, a list that runs in a circle, an unknown type
[[nodiscard]] std::optional<LogTable> read_motec_ld(const std::string& bytes, const std::filesystem::path& path,
                                                    InputErrors& errors);

}  // namespace tiretherm::input
