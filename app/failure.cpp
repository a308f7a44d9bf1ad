// SPDX-License-Identifier: BSD-3-Clause
// Watches over standard output.

#include "app/failure.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <iostream>
#include <string>
#include <system_error>

#include <fmt/format.h>

namespace tiretherm::app {

namespace {

/// Why standard output took nothing; 0: not known.
int& lost_by() {
    static int reason = 0;
    return reason;
}

}  // namespace

bool is_lost_output(const std::exception& error) {
    if (std::ferror(stdout) == 0) {
        return false;
    }
    if (const auto* system = dynamic_cast<const std::system_error*>(&error)) {
        lost_by() = system->code().value();
    }
    return true;
}

void keep_standard_streams() {
    for (int stream = STDIN_FILENO; stream <= STDERR_FILENO; ++stream) {
        if (fcntl(stream, F_GETFD) == -1 && errno == EBADF) {
            static_cast<void>(open("/dev/null", O_RDWR));  // takes the lowest number that is free: this one
        }
    }
}

bool flush_standard_output() {
    errno = 0;
    static_cast<void>(std::cout.flush());
    const bool flushed = std::fflush(stdout) == 0;
    const int reason = lost_by() != 0 ? lost_by() : errno;
    if (flushed && std::ferror(stdout) == 0 && std::cout.good()) {
        return true;
    }
    fmt::print(stderr, "tiretherm: standard output cannot be written{}\n",
               reason != 0 ? ": " + std::generic_category().message(reason) : "");
    return false;
}

}  // namespace tiretherm::app
