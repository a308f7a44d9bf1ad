// SPDX-License-Identifier: BSD-3-Clause
// Reading and writing files safely: whole replacement by renaming, append-only text, folders, and the error that names
// path and reason.
#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>

namespace tiretherm::post {

/// A file that could not be read or written; what() names it and the system's reason.
class FileError : public std::runtime_error {
public:
    /// @param doing the verb that failed: "write", "create", "rename"
    FileError(std::string_view doing, const std::filesystem::path& path, std::string_view reason);

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

/// The system's sentence for an errno, "No space left on device".
[[nodiscard]] std::string system_reason(int error_number);

/// The whole of a file. @errors FileError
[[nodiscard]] std::string read_text(const std::filesystem::path& path);

/// Creates a folder with those above it, where it is missing. @returns it  @errors FileError
std::filesystem::path create_folder(std::filesystem::path folder);

/// Writes a whole file beside the old one and renames it, so that a reader sees one or the other, never a half.
/// @errors FileError
void replace_file(const std::filesystem::path& path, std::string_view content);

/// The same with the folders above it, where they are missing; where the file cannot be written none of them is left.
/// @errors FileError
void write_with_folder(const std::filesystem::path& path, std::string_view content);

/// A text file that grows line by line. What was appended survives the end of the process, however it ends.
class AppendFile {
public:
    /// Creates the file, or empties it. @errors FileError
    explicit AppendFile(std::filesystem::path path);

    /// @errors FileError
    void append(std::string_view text);

private:
    struct Closer {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    std::filesystem::path path_;
    std::unique_ptr<std::FILE, Closer> file_;
};

}  // namespace tiretherm::post
