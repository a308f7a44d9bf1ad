// SPDX-License-Identifier: BSD-3-Clause
// Binary files of loggers: those that are read, and those of which only the program is known that exports them.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "input/loggers/channel_table.hpp"

namespace tiretherm::input {

/// A binary format, known by its first bytes.
struct BinaryLog {
    bool (*recognises)(std::string_view first_bytes);
    std::optional<ChannelTable> (*read)(std::string bytes, const std::filesystem::path& path, int file,
                                        InputErrors& errors);
};
constexpr std::size_t first_bytes_of_log = 64;  ///< that `recognises` looks at

/// The format of a file; null: none of those that are read.
[[nodiscard]] const BinaryLog* find_binary_log(std::string_view first_bytes);

/// What a file is that has no columns to be read, and which program exports them; empty for another file.
[[nodiscard]] ErrorText unread_log(const std::filesystem::path& path, std::string_view first_bytes);

/// Endings of logs' names, in small letters, those of formats that are not read among them.
[[nodiscard]] bool is_ending_of_log(std::string_view ending);

}  // namespace tiretherm::input
