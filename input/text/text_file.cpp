// SPDX-License-Identifier: BSD-3-Clause
// Reads a text file whole; refuses pipes, devices, UTF-16, binary, empty and huge files, and suggests a similar name for
// a missing one.

#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>

#include <fmt/format.h>

#include "input/text/document.hpp"
#include "input/text/regular_file.hpp"
#include "input/text/suggestions.hpp"

namespace tiretherm::input {

namespace {

namespace fs = std::filesystem;

std::string spell_size(std::uintmax_t bytes) {
    constexpr double kilo = 1024.0;
    const auto size = static_cast<double>(bytes);
    return size >= kilo * kilo * kilo ? fmt::format("{:.3g} GB", size / (kilo * kilo * kilo))
                                      : fmt::format("{:.3g} MB", size / (kilo * kilo));
}

/// What keeps bytes from being a text, with the remedy; empty for a text.
ErrorText defect(const std::string& bytes) {
    if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF")) {
        return {"is written in UTF-16", "save it as UTF-8"};
    }
    if (bytes.find('\0') != std::string::npos) {
        return {"is not a text file", "give a text file"};
    }
    if (bytes.find_first_not_of(" \t\r\n") == std::string::npos || bytes == "\xEF\xBB\xBF") {
        return {"is empty", ""};
    }
    return {};
}

/// A file of a similar name beside one that does not exist.
std::string neighbour(const std::filesystem::path& path) {
    std::vector<std::string> names;
    std::error_code error;
    const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
    for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
        if (entry.is_regular_file(error)) {
            names.push_back(entry.path().filename().string());
        }
    }
    const std::string near = nearest(path.filename().string(), names);
    return near.empty() ? "" : fmt::format("did you mean `{}`?", near);
}

std::optional<TextFile> read_whole(const std::filesystem::path& path, const SourceLocation& mentioned,
                                   InputErrors& errors) {
    const std::string shown = path.generic_string();
    if (const int number = errors.find_file(shown); number >= 0) {
        return TextFile{number, errors.text(number)};
    }
    const auto refuse = [&](std::string_view what, std::string remedy) {
        // The user's own argument has no place in a file but itself.
        SourceLocation place = mentioned;
        if (place.file < 0) {
            place = {.file = errors.add_file(shown, "")};
            errors.add(place, fmt::format("the file {}", what), std::move(remedy));
        } else {
            errors.add(place, fmt::format("the file {} {}", shown, what), std::move(remedy));
        }
        return std::nullopt;
    };
    if (const ErrorText reason = not_readable(path, largest_text); !reason.what.empty()) {
        return refuse(reason.what, reason.remedy);
    }
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
    if (!file) {
        const int reason = errno;
        return refuse(fmt::format("cannot be read: {}", std::system_category().message(reason)),
                      reason == ENOENT ? neighbour(path) : "");
    }
    std::string bytes;
    std::string block(std::size_t{1} << 16U, '\0');
    for (std::size_t n = 0; (n = std::fread(block.data(), 1, block.size(), file.get())) > 0;) {
        bytes.append(block, 0, n);
        if (bytes.size() > largest_text) {  // it grows, or the system knows no size of it
            const ErrorText reason = too_large(bytes.size(), largest_text);
            return refuse(reason.what, reason.remedy);
        }
    }
    if (std::ferror(file.get()) != 0) {
        return refuse(fmt::format("cannot be read: {}", std::system_category().message(errno)), "");
    }
    if (const ErrorText reason = defect(bytes); !reason.what.empty()) {
        return refuse(reason.what, reason.remedy);
    }
    const int number = errors.add_file(shown, bytes);
    return TextFile{number, std::move(bytes)};
}

}  // namespace

ErrorText too_large(std::uintmax_t bytes, std::uintmax_t largest) {
    return {fmt::format("is too large: it has {}, and at most {} are read", spell_size(bytes), spell_size(largest)),
            "split it, or leave out what the case does not need"};
}

ErrorText not_readable(const std::filesystem::path& path, std::uintmax_t largest) {
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

std::optional<TextFile> read_text(const std::filesystem::path& path, const SourceLocation& mentioned,
                                  InputErrors& errors) {
    return with_memory(path.generic_string(), mentioned, errors, [&] { return read_whole(path, mentioned, errors); });
}

}  // namespace tiretherm::input
