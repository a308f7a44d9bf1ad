// SPDX-License-Identifier: BSD-3-Clause
// Names of runs from file and laps.

#include "input/files/run_name.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace tiretherm::input {

namespace {

/// "_laps_3-9"; empty without a choice of laps.
std::string name_of_laps(std::string_view laps) {
    std::string text(laps);
    std::erase(text, ' ');
    std::ranges::replace(text, ',', '_');
    const bool is_word = !text.empty() && text.find_first_not_of("0123456789-_") == std::string::npos;
    return is_word ? fmt::format("_{}_{}", text.find_first_of("-_") == std::string::npos ? "lap" : "laps", text) : "";
}

}  // namespace

std::string plain_stem(const std::filesystem::path& file) {
    const std::string stem = file.stem().string();
    const std::size_t first = stem.find_first_not_of('.');
    return first == std::string::npos ? "unnamed" : stem.substr(first);
}

std::string run_name(const std::filesystem::path& file, std::string_view laps) {
    return plain_stem(file) + name_of_laps(laps);
}

}  // namespace tiretherm::input
