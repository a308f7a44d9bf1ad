// SPDX-License-Identifier: BSD-3-Clause
// Runs a reader of somebody else's in a process of its own, so that a damaged file cannot end the program.
#pragma once

#include <functional>
#include <optional>
#include <string>

namespace tiretherm::input {

/// A thread's turn at the libraries whose files are tried in a child, until its end; one within another is none of its own.
/// Whoever calls such a library takes one. A child is made between the turns of others: made while another thread is inside
/// the library, it would wait for that thread's lock for ever.
class LibraryTurn {
public:
    LibraryTurn();
    ~LibraryTurn();
    LibraryTurn(const LibraryTurn&) = delete;
    LibraryTurn& operator=(const LibraryTurn&) = delete;
};

/// Calls `work` in a child process and gives what it returned. For libraries that are known to fail on damaged files.
/// Nothing of what `work` changes is seen outside; what it and its library write to standard error is dropped. A child that
/// gets nowhere without computing is ended after four times `cpu_seconds`. @returns nothing where the child was ended by a signal, threw, or took too long
/// @errors solver::Interrupted where reading may be interrupted
[[nodiscard]] std::optional<std::string> in_own_process(const std::function<std::string()>& work,
                                                        unsigned cpu_seconds = 60);

}  // namespace tiretherm::input
