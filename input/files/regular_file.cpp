// SPDX-License-Identifier: BSD-3-Clause
// Names what is no regular file, and says how large a file is and may be.

#include "input/files/regular_file.hpp"

#include <system_error>

#include <fmt/format.h>

namespace tiretherm::input {

namespace {

namespace fs = std::filesystem;

std::string spell_size(std::uintmax_t bytes) {
    constexpr double kilo = 1024.0;
    const auto size = static_cast<double>(bytes);
    return size >= kilo * kilo * kilo ? fmt::format("{:.3g} GB", size / (kilo * kilo * kilo))
                                      : fmt::format("{:.3g} MB", size / (kilo * kilo));
}

}  // namespace

ErrorText too_large(std::uintmax_t bytes, std::uintmax_t largest) {
    return {fmt::format("is too large: it has {}, and at most {} are read", spell_size(bytes), spell_size(largest)),
            "split it, or leave out what the case does not need"};
}

ErrorText not_readable(const fs::path& path, std::uintmax_t largest) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    switch (status.type()) {
        case fs::file_type::directory:
            return {"is a directory", "give a file"};
        case fs::file_type::fifo:
            return {"is a pipe, not a regular file", "write what comes out of it into a file and give that"};
        case fs::file_type::character:
        case fs::file_type::block:
            return {"is a device, not a regular file", "give a regular file"};
        case fs::file_type::socket:
            return {"is a socket, not a regular file", "give a regular file"};
        case fs::file_type::regular:
            break;
        default:
            return {};  // opening it says why
    }
    const std::uintmax_t bytes = fs::file_size(path, error);
    return !error && bytes > largest ? too_large(bytes, largest) : ErrorText{};
}

void refuse_file(const fs::path& path, const SourceLocation& mentioned, ErrorText why, InputErrors& errors) {
    const std::string shown = path.generic_string();
    if (mentioned.file < 0) {
        errors.add({.file = errors.add_file(shown, "")}, "the file " + why.what, std::move(why.remedy));
    } else {
        errors.add(mentioned, fmt::format("the file {} {}", shown, why.what), std::move(why.remedy));
    }
}

}  // namespace tiretherm::input
