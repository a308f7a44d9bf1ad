// SPDX-License-Identifier: BSD-3-Clause
// Turns exceptions that no command explains into sentences, and watches over standard output.

#include "app/failure.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <new>
#include <stdexcept>
#include <system_error>

#include <fmt/format.h>

namespace tiretherm::app {

namespace {

std::string& doing() {
    static std::string what = "reading the call";
    return what;
}

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

const std::string& now_done() { return doing(); }

void now_doing(std::string what) { doing() = std::move(what); }

Failure failure_of(const std::exception& error) {
    constexpr const char* smaller = "take fewer cells, rows or samples; tiretherm check says how large a case is";
    if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) {
        return {fmt::format("{} failed: there is not enough memory", doing()), smaller};
    }
    if (dynamic_cast<const std::length_error*>(&error) != nullptr) {
        return {fmt::format("{} failed: a size is beyond any memory", doing()), smaller};
    }
    if (const auto* files = dynamic_cast<const std::filesystem::filesystem_error*>(&error)) {
        const std::string path = files->path1().empty() ? "" : files->path1().string() + ": ";
        return {fmt::format("{} failed: {}{}", doing(), path, files->code().message()), ""};
    }
    if (const auto* system = dynamic_cast<const std::system_error*>(&error)) {
        return {fmt::format("{} failed: {}", doing(), system->code().message()), ""};
    }
    return {fmt::format("{} failed: {}", doing(), error.what()), ""};
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
