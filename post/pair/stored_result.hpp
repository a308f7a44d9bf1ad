// SPDX-License-Identifier: BSD-3-Clause
// A result read back from its folder: the data of its page, the values of its case, the courses of its channels.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace tiretherm::post {

/// A channel against time as its file has it, in the unit that users see.
struct StoredCourse {
    std::string name;  ///< with its run or corner where the result has several
    std::string unit;
    std::vector<double> time{};  ///< s
    std::vector<double> value{};
    std::vector<double> measured{};  ///< of a comparison; otherwise empty
};

struct StoredResult {
    std::filesystem::path folder;
    std::string kind;                      ///< "run" or "compare"
    nlohmann::ordered_json case_values{};  ///< by their keys, as they are written
    nlohmann::ordered_json data{};         ///< what --json prints
    std::vector<StoredCourse> courses{};
};

/// @errors FileError; PageError where the folder's page or table is none of this program's, or of another kind of result
[[nodiscard]] StoredResult read_result(const std::filesystem::path& folder);

}  // namespace tiretherm::post
