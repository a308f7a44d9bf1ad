// SPDX-License-Identifier: BSD-3-Clause
// Binary files of loggers: those that are read, and those of which only the program is known that exports them.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "input/tables/log_table.hpp"

namespace tiretherm::input {

#define BINARY_LOG(name)                                                                                           \
    [[nodiscard]] bool is_##name(std::string_view first_bytes);                                                    \
    [[nodiscard]] std::optional<LogTable> read_##name(const std::string& bytes, const std::filesystem::path& path, \
                                                      InputErrors& errors);
#include "input/loggers/loggers.list"

/// A binary format, known by its first bytes.
struct BinaryLog {
    bool (*recognises)(std::string_view first_bytes);
    /// @param path for what stands beside the file  @param errors of this file alone  @returns nothing after an error
    std::optional<LogTable> (*read)(const std::string& bytes, const std::filesystem::path& path, InputErrors& errors);
};
constexpr std::size_t first_bytes_of_log = 64;  ///< that `recognises` looks at

/// The format of a file; null: none of those that are read.
[[nodiscard]] const BinaryLog* find_binary_log(std::string_view first_bytes);

/// A table of channels, each with its own clock.
[[nodiscard]] LogTable table_of_channels(std::vector<TableColumn> channels, LogDescription description);

/// What a file is that has no columns to be read, and which program exports them; empty for another file.
[[nodiscard]] ErrorText unread_log(const std::filesystem::path& path, std::string_view first_bytes);

/// Endings of logs' names, in small letters, those of formats that are not read among them.
[[nodiscard]] bool is_ending_of_log(std::string_view ending);

}  // namespace tiretherm::input
