// SPDX-License-Identifier: BSD-3-Clause
// The formats by loggers.list.

#include "input/loggers/binary_logs.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "input/text/characters.hpp"

namespace tiretherm::input {

namespace {

constexpr std::array binary_logs{
#define BINARY_LOG(name) BinaryLog{is_##name, read_##name},
#include "input/loggers/loggers.list"
};

/// A file that its maker's program alone reads.
struct UnreadLog {
    std::string_view ending;
    std::string_view mark;  ///< its first bytes, whatever the name; empty: the name tells
    std::string_view what;
    std::string_view remedy;
};
constexpr std::array unread_logs{
#define UNREAD_LOG(ending, mark, what, remedy) UnreadLog{ending, mark, what, remedy},
#include "input/loggers/loggers.list"
};

constexpr std::array endings_of_logs{
#define LOG_ENDING(ending) std::string_view(ending),
#include "input/loggers/loggers.list"
};

}  // namespace

const BinaryLog* find_binary_log(std::string_view first_bytes) {
    const auto found =
        std::ranges::find_if(binary_logs, [&](const BinaryLog& log) { return log.recognises(first_bytes); });
    return found == binary_logs.end() ? nullptr : &*found;
}

LogTable table_of_channels(std::vector<TableColumn> channels, LogDescription description) {
    LogTable table{.description = std::move(description), .units = LogTable::Units::by_name_alone};
    table.columns.push_back({.head = {.heading = {"time", "s"}, .place = {.file = 0}}});
    for (TableColumn& channel : channels) {
        channel.head.place = {.file = 0};
        table.columns.push_back(std::move(channel));
    }
    return table;
}

ErrorText unread_log(const std::filesystem::path& path, std::string_view first_bytes) {
    const std::string ending = in_small_letters(path.extension().string());
    const auto found = std::ranges::find_if(unread_logs, [&](const UnreadLog& log) {
        return log.ending == ending || (!log.mark.empty() && first_bytes.starts_with(log.mark));
    });
    return found == unread_logs.end()
               ? ErrorText{}
               : ErrorText{fmt::format("is {}, which is not read", found->what), std::string(found->remedy)};
}

bool is_ending_of_log(std::string_view ending) {
    return std::ranges::find(endings_of_logs, ending) != endings_of_logs.end() ||
           std::ranges::find(unread_logs, ending, &UnreadLog::ending) != unread_logs.end();
}

}  // namespace tiretherm::input
