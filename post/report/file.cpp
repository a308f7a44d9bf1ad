// SPDX-License-Identifier: BSD-3-Clause
// Writing beside the old file and renaming, appending by lines, and error messages with the system's reason.

#include "post/report/file.hpp"

#include <cerrno>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace tiretherm::post {

FileError::FileError(std::string_view doing, const std::filesystem::path& path, std::string_view reason)
    : std::runtime_error(fmt::format("cannot {} {}: {}", doing, path.string(), reason)), path_(path) {}

std::string system_reason(int error_number) { return std::generic_category().message(error_number); }

std::string read_text(const std::filesystem::path& path) {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
    if (!file) {
        throw FileError("read", path, system_reason(errno));
    }
    std::string text;
    char block[4096];
    while (const std::size_t n = std::fread(block, 1, sizeof block, file.get())) {
        text.append(block, n);
    }
    if (std::ferror(file.get()) != 0) {
        throw FileError("read", path, system_reason(errno));
    }
    return text;
}

std::filesystem::path create_folder(std::filesystem::path folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) {
        throw FileError("create the directory", folder, error.message());
    }
    return folder;
}

void replace_file(const std::filesystem::path& path, std::string_view content) {
    std::filesystem::path draft = path;
    draft += ".part";
    std::error_code error;
    std::filesystem::remove(draft, error);  // a link of that name is not written through
    try {
        AppendFile(draft).append(content);
        std::filesystem::rename(draft, path, error);
        if (error) {
            throw FileError("rename", draft, error.message());
        }
    } catch (const FileError&) {
        std::filesystem::remove(draft, error);
        throw;
    }
}

void write_with_folder(const std::filesystem::path& path, std::string_view content) {
    std::vector<std::filesystem::path> missing;
    std::error_code error;
    for (std::filesystem::path folder = path.parent_path();
         !folder.empty() && !std::filesystem::exists(folder, error) && folder != folder.parent_path();
         folder = folder.parent_path()) {
        missing.push_back(folder);
    }
    try {
        if (path.has_parent_path()) {
            create_folder(path.parent_path());
        }
        replace_file(path, content);
    } catch (const FileError&) {
        for (const std::filesystem::path& folder : missing) {
            std::filesystem::remove(folder, error);  // unless somebody else has put something there
        }
        throw;
    }
}

AppendFile::AppendFile(std::filesystem::path path) : path_(std::move(path)), file_(std::fopen(path_.c_str(), "wb")) {
    if (!file_) {
        throw FileError("create", path_, system_reason(errno));
    }
}

void AppendFile::append(std::string_view text) {
    if (std::fwrite(text.data(), 1, text.size(), file_.get()) != text.size() || std::fflush(file_.get()) != 0) {
        throw FileError("write", path_, system_reason(errno));
    }
}

}  // namespace tiretherm::post
