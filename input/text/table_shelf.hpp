// SPDX-License-Identifier: BSD-3-Clause
// The tables that one command has read.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <string>

namespace tiretherm::input {

struct LogTable;

/// Tables by the absolute paths of their files: a file is read once for all corners, runs and variants of a case, for the laps
/// and for the survey of a log. It is read again by those alone who share no shelf, see InputErrors.
struct TableShelf {
    std::mutex reading{};  ///< variants of a case are read in several threads
    std::map<std::string, std::shared_ptr<const LogTable>> tables{};
    std::size_t files_read = 0;
};

}  // namespace tiretherm::input
