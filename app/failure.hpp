// SPDX-License-Identifier: BSD-3-Clause
// What nobody else explains: exceptions of libraries as sentences, and a standard output that takes nothing.
#pragma once

#include <exception>
#include <string>

#include "solver/stop_signal.hpp"

namespace tiretherm::app {

/// Notes what the program is about to do, for the sentence about an exception: "reading case.toml and the files it names".
/// For the main thread.
void now_doing(std::string what);
/// What is being done.
[[nodiscard]] const std::string& now_done();

/// Reads files, which Ctrl-C and a time limit end meanwhile. @param file that names the others
/// @errors solver::Interrupted
template <typename Read>
auto while_reading(const std::string& file, const Read& read) {
    now_doing("reading " + file + " and the files that it names");
    const solver::InterruptibleReading until_read;
    return read();
}

/// An exception that came up to `main` as a sentence with what was being done, and its remedy.
struct Failure {
    std::string sentence;
    std::string remedy;
};
[[nodiscard]] Failure failure_of(const std::exception& error);

/// Descriptors 0 to 2 that the caller has closed lead to nowhere, so that no file of results gets their number.
void keep_standard_streams();

/// Remembers why standard output took nothing, where that is what an exception is about. @returns whether it is
[[nodiscard]] bool is_lost_output(const std::exception& error);

/// Writes what is left for standard output. @returns whether all of it has been taken; otherwise it has been reported
[[nodiscard]] bool flush_standard_output();

}  // namespace tiretherm::app
