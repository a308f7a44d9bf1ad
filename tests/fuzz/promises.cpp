// SPDX-License-Identifier: BSD-3-Clause
// Checks of messages, and the scratch folder, which is removed when the program ends.

#include "fuzz/promises.hpp"

#include <unistd.h>

#include <fstream>

#include <fmt/format.h>

namespace tiretherm::fuzz {

namespace fs = std::filesystem;

namespace {

/// Far more than the longest sentence with a quoted line; a value of a user's is cut before it is quoted.
constexpr std::size_t longest_message = 4000;

class Folder {
public:
    Folder() {
        const fs::path shared = "/dev/shm";
        path_ = (fs::is_directory(shared) ? shared : fs::temp_directory_path()) /
                fmt::format("tiretherm_fuzz_{}", getpid());
        fs::create_directories(path_);
        fs::create_directory_symlink(fs::path(TIRETHERM_SOURCE_DIR) / "cases", path_ / "cases");
    }
    ~Folder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    [[nodiscard]] const fs::path& path() const { return path_; }

private:
    fs::path path_;
};

}  // namespace

void promise(bool kept, const std::string& sentence) {
    if (!kept) {
        throw BrokenPromise(sentence);
    }
}

void check_messages(const std::vector<input::InputError>& errors, const std::vector<std::string>& warnings) {
    for (const input::InputError& error : errors) {
        promise(!error.what.empty(), "an error without a text");
        promise(!error.file.empty(), "an error without a file: " + error.what);
        promise(error.line >= 0 && error.column >= 0 && error.length >= 0, "an error before its file: " + error.what);
        const std::size_t size = error.what.size() + error.remedy.size();
        promise(size <= longest_message, fmt::format("a message of {} bytes: {:.200}", size, error.what));
        const std::size_t rendered = input::render(error).size();
        promise(rendered <= 4 * longest_message, fmt::format("an error of {} bytes as shown", rendered));
    }
    for (const std::string& warning : warnings) {
        promise(!warning.empty() && warning.size() <= longest_message,
                fmt::format("a warning of {} bytes: {:.200}", warning.size(), warning));
    }
}

void check_outcome(bool result, const std::vector<input::InputError>& errors,
                   const std::vector<std::string>& warnings) {
    promise(result == errors.empty(), result ? "a result beside errors" : "neither a result nor an error");
    check_messages(errors, warnings);
}

fs::path scratch_file(const std::string& name, std::string_view bytes) {
    static const Folder folder;
    const fs::path path = folder.path() / name;
    fs::create_directories(path.parent_path());
    std::ofstream file(path, std::ios::binary | std::ios::trunc);
    file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    file.close();
    promise(file.good(), "the scratch folder cannot be written");
    return path;
}

fs::path shipped(const std::string& name) { return fs::path(TIRETHERM_SOURCE_DIR) / "cases" / name; }

}  // namespace tiretherm::fuzz
