// SPDX-License-Identifier: BSD-3-Clause
// Runs another program without a shell, within a time limit.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace tiretherm::post {

/// What a program left behind.
struct ChildResult {
    enum class End { exited, killed_by_signal, timed_out, stopped, not_started };
    End end = End::not_started;
    int code = 0;  ///< exit code, signal, or the system's error number where it could not be started
    std::string out;
    std::string err;
};

/// Runs a program without input and collects what it writes. It is the head of a process group of its own, all of which is
/// ended with it, at the limit, or when `stopped` says so.
/// @param command program, with its path, and arguments
[[nodiscard]] ChildResult run_child(const std::vector<std::string>& command, std::chrono::milliseconds limit,
                                    const std::function<bool()>& stopped);

/// Where a program stands on the search path of the shell. @param names in the order of preference
[[nodiscard]] std::optional<std::filesystem::path> find_program(const std::vector<std::string>& names);

}  // namespace tiretherm::post
