// SPDX-License-Identifier: BSD-3-Clause
// Only regular files of a sensible size are read: a pipe or a device may have no end.
#pragma once

#include <cstdint>
#include <filesystem>

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

/// Reports why a file is not read, at the place where the case names it; of a file that the user named at the file itself.
/// @param why "is empty"  @param mentioned file -1: the user's own argument
void refuse_file(const std::filesystem::path& path, const SourceLocation& mentioned, ErrorText why,
                 InputErrors& errors);

}  // namespace tiretherm::input
