// SPDX-License-Identifier: BSD-3-Clause
// A temporary directory that is removed at the end of a test.
#pragma once

#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <string>

#include <fmt/format.h>

namespace tiretherm::sample {

/// A directory of its own for a test, removed at its end.
class Scratch {
public:
    Scratch() {
        static std::atomic<int> next = 0;
        path_ = std::filesystem::temp_directory_path() / fmt::format("tiretherm_{}_{}", getpid(), next++);
        std::filesystem::create_directories(path_);
    }
    ~Scratch() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;

    [[nodiscard]] std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

}  // namespace tiretherm::sample
