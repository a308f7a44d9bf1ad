// SPDX-License-Identifier: BSD-3-Clause
// Runs a reader of somebody else's in a process of its own, so that a damaged file cannot end the program.
#pragma once

#include <functional>
#include <optional>
#include <string>

namespace tiretherm::input {

/// Calls `work` in a child process and gives what it returned. For libraries that are known to fail on damaged files.
/// Nothing of what `work` changes is seen outside; what it and its library write to standard error is dropped. A child that
/// gets nowhere without computing, for it may wait for a lock that a thread of the parent held, is ended after four times
/// `cpu_seconds`. @returns nothing where the child was ended by a signal, threw, or took too long
/// @errors solver::Interrupted where reading may be interrupted
[[nodiscard]] std::optional<std::string> in_own_process(const std::function<std::string()>& work,
                                                        unsigned cpu_seconds = 60);

}  // namespace tiretherm::input
