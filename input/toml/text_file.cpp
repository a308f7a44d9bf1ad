// SPDX-License-Identifier: BSD-3-Clause
// Reads a text file whole; refuses pipes, devices, binary, empty and huge files, of cases UTF-16 as well, and suggests a
// similar name for a missing one.

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>

#include <fmt/format.h>

#include "input/files/enough_memory.hpp"
#include "input/files/nearby_file.hpp"
#include "input/files/regular_file.hpp"
#include "input/text/encoding.hpp"
#include "input/text/source_text.hpp"
#include "input/toml/document.hpp"

namespace tiretherm::input {

namespace {

/// What keeps bytes from being a text, with the remedy; empty for a text.
ErrorText defect(const std::string& bytes) {
    if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF")) {
        return {"is written in UTF-16", "save it as UTF-8"};
    }
    if (bytes.find('\0') != std::string::npos) {
        return {"is not a text file", "give a text file; export a logger's own format as CSV"};
    }
    if (bytes.find_first_not_of(" \t\r\n") == std::string::npos || bytes == "\xEF\xBB\xBF") {
        return {"is empty", ""};
    }
    return {};
}

/// What was meant by a path that leads nowhere: the whole path where it is the user's own argument; otherwise, as the case
/// that names it gives it from its own folder on, the part from the first wrong name on.
std::string neighbour(const std::filesystem::path& path, bool is_argument) {
    if (is_argument) {
        return nearby_file_remedy(path);
    }
    const std::filesystem::path near = nearby_file(path);
    if (near.empty()) {
        return "";
    }
    const auto wrong = std::ranges::mismatch(near, path).in1;
    std::filesystem::path tail;
    std::for_each(wrong, near.end(), [&](const std::filesystem::path& part) { tail /= part; });
    return fmt::format("did you mean `{}`?", tail.generic_string());
}

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

/// What a file has, up to a little more than may be read.
std::string bytes_of(std::FILE* file, const std::filesystem::path& path) {
    std::string bytes;
    std::error_code unknown;
    const std::uintmax_t size = std::filesystem::file_size(path, unknown);
    // The size is a hint: a file may grow while it is read, and pipes have none.
    bytes.reserve(unknown ? 0 : static_cast<std::size_t>(size));
    std::string block(std::size_t{1} << 16U, '\0');
    for (std::size_t n = 0;
         bytes.size() <= largest_text && (n = std::fread(block.data(), 1, block.size(), file)) > 0;) {
        bytes.append(block, 0, n);
    }
    return bytes;
}

std::optional<TextFile> read_whole(const std::filesystem::path& path, const SourceLocation& mentioned,
                                   InputErrors& errors, bool is_foreign) {
    const std::string shown = path.generic_string();
    if (const int number = errors.find_file(shown); number >= 0) {
        return TextFile{number, *errors.text(number)->get()};
    }
    const auto refuse = [&](std::string what, std::string remedy) {
        refuse_file(path, mentioned, {std::move(what), std::move(remedy)}, errors);
        return std::nullopt;
    };
    if (const ErrorText reason = not_readable(path, largest_text); !reason.what.empty()) {
        return refuse(reason.what, reason.remedy);
    }
    const File file(std::fopen(path.c_str(), "rb"), std::fclose);
    if (!file) {
        const int reason = errno;
        return refuse(fmt::format("cannot be read: {}", std::system_category().message(reason)),
                      reason == ENOENT ? neighbour(path, mentioned.file < 0) : "");
    }
    std::string bytes = bytes_of(file.get(), path);
    if (bytes.size() > largest_text) {  // it grows, or the system knows no size of it
        const ErrorText reason = too_large(bytes.size(), largest_text);
        return refuse(reason.what, reason.remedy);
    }
    if (std::ferror(file.get()) != 0) {
        return refuse(fmt::format("cannot be read: {}", std::system_category().message(errno)), "");
    }
    if (is_foreign) {
        bytes = as_utf8(std::move(bytes));
    }
    if (const ErrorText reason = defect(bytes); !reason.what.empty()) {
        return refuse(reason.what, reason.remedy);
    }
    const auto again = [path, is_foreign] {
        const File same(std::fopen(path.c_str(), "rb"), std::fclose);
        std::string text = same ? bytes_of(same.get(), path) : std::string();
        return is_foreign ? as_utf8(std::move(text)) : text;
    };
    const int number = errors.add_file(shown, std::make_shared<const SourceText>(std::move(bytes), again));
    return TextFile{number, *errors.text(number)->get()};
}

}  // namespace

std::optional<TextFile> read_text(const std::filesystem::path& path, const SourceLocation& mentioned,
                                  InputErrors& errors) {
    return with_memory(path.generic_string(), mentioned, errors,
                       [&] { return read_whole(path, mentioned, errors, false); });
}

std::optional<TextFile> read_foreign_text(const std::filesystem::path& path, const SourceLocation& mentioned,
                                          InputErrors& errors) {
    return with_memory(path.generic_string(), mentioned, errors,
                       [&] { return read_whole(path, mentioned, errors, true); });
}

}  // namespace tiretherm::input
