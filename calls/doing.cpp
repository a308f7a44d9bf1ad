// SPDX-License-Identifier: BSD-3-Clause
// Turns exceptions that no call explains into sentences.

#include "calls/doing.hpp"

#include <filesystem>
#include <new>
#include <stdexcept>
#include <system_error>

#include <fmt/format.h>

namespace tiretherm::calls {

namespace {

std::string& doing() {
    static thread_local std::string what = "reading the call";
    return what;
}

}  // namespace

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

}  // namespace tiretherm::calls
