// SPDX-License-Identifier: BSD-3-Clause
// Access to tests/bad_cases: wrong files, and beside each the message that a user must read.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

/// Wrong files and, beside each, what the user must then read.
namespace tiretherm::input::expected {

inline std::filesystem::path folder() { return std::filesystem::path(TIRETHERM_SOURCE_DIR) / "tests" / "bad_cases"; }

/// Stems of the TOML files of a folder, sorted.
inline std::vector<std::string> names(const std::filesystem::path& in) {
    std::vector<std::string> found;
    for (const auto& entry : std::filesystem::directory_iterator(in)) {
        if (entry.path().extension() == ".toml") {
            found.push_back(entry.path().stem().string());
        }
    }
    std::sort(found.begin(), found.end());
    return found;
}

inline std::string text_of(const std::filesystem::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

/// Paths as if the checker had been started in the folder.
inline std::string relative(std::string text) {
    const std::string prefix = folder().generic_string() + "/";
    for (std::size_t at = 0; (at = text.find(prefix, at)) != std::string::npos;) {
        text.erase(at, prefix.size());
    }
    return text;
}

}  // namespace tiretherm::input::expected
