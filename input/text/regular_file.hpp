// SPDX-License-Identifier: BSD-3-Clause
// Only regular files of a sensible size are read: a pipe or a device may have no end. A file for which there is not enough
// memory is an error with its place, not the end of the program.
#pragma once

#include <cstdint>
#include <filesystem>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>

#include "input/text/input_error.hpp"

namespace tiretherm::input {

/// The largest file of text that is read, in bytes: some 50 million numbers.
inline constexpr std::uintmax_t largest_text = std::uintmax_t{512} << 20U;

/// Why a path is not to be opened for reading, as "is a directory", with the remedy: it is no regular file, or one of more
/// than `largest` bytes. Empty for a regular file, for a link to one, and for what does not exist, of which opening it
/// says more.
[[nodiscard]] ErrorText not_readable(const std::filesystem::path& path, std::uintmax_t largest);

/// What to say of a file of more than `largest` bytes.
[[nodiscard]] ErrorText too_large(std::uintmax_t bytes, std::uintmax_t largest);

/// Calls what reads a file. Where the memory does not suffice, that is an error.
/// @param shown the file, as messages name it  @param place where it is mentioned; file -1: nowhere
/// @returns what `read` returns, an empty value after the error
template <typename Read>
[[nodiscard]] auto with_memory(const std::string& shown, const SourceLocation& place, InputErrors& errors,
                               const Read& read) -> decltype(read()) {
    ErrorText error;
    try {
        return read();
    } catch (const std::bad_alloc&) {
        error = {"there is not enough memory for the file " + shown, "split it, or leave out columns and samples"};
    } catch (const std::length_error&) {
        error = {"the file " + shown + " announces more values than any memory has", "export it again"};
    }
    errors.add(place.file >= 0 ? place : SourceLocation{.file = errors.add_file(shown, "")}, std::move(error));
    return {};
}

}  // namespace tiretherm::input
