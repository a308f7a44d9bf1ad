// SPDX-License-Identifier: BSD-3-Clause
// What a call is doing, for the sentence about an exception that comes out of it.
#pragma once

#include <exception>
#include <string>

#include "solver/stop_signal.hpp"

namespace tiretherm::calls {

/// Notes what this thread is about to do: "reading case.toml and the files it names".
void now_doing(std::string what);
/// What this thread is doing.
[[nodiscard]] const std::string& now_done();

/// Reads files, which Ctrl-C and a time limit end meanwhile. @param file that names the others
/// @errors solver::Interrupted
template <typename Read>
auto while_reading(const std::string& file, const Read& read) {
    now_doing("reading " + file + " and the files that it names");
    const solver::InterruptibleReading until_read;
    return read();
}

/// An exception that no call explains, as a sentence with what was being done, and its remedy.
struct Failure {
    std::string sentence;
    std::string remedy;
};
[[nodiscard]] Failure failure_of(const std::exception& error);

}  // namespace tiretherm::calls
