// SPDX-License-Identifier: BSD-3-Clause
// Reads each case of a validation table once and collects the errors and warnings of all cases.

#include <algorithm>
#include <system_error>

#include <fmt/format.h>

#include "input/model/reader.hpp"
#include "input/text/suggestions.hpp"
#include "input/validation/validation_reader.hpp"

namespace tiretherm::input {

namespace {

namespace fs = std::filesystem;

/// What to do about a case that is not there: the nearest name of its folder.
std::string neighbour(const fs::path& file) {
    std::vector<std::string> names;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(file.parent_path(), error)) {
        names.push_back(entry.path().filename().string());
    }
    const std::string near = nearest(file.filename().string(), names);
    return near.empty() ? "give its path from the table's folder" : fmt::format("did you mean `{}`?", near);
}

}  // namespace

std::optional<std::size_t> CaseCache::find(const std::string& path, const SourceLocation& mentioned,
                                           InputErrors& errors) {
    const fs::path file = (folder_ / path).lexically_normal();
    std::error_code error;
    if (!fs::is_regular_file(file, error)) {
        errors.add(mentioned, fmt::format("there is no case {}", path), neighbour(file));
        return std::nullopt;
    }
    const auto known = known_.find(file.generic_string());
    if (known != known_.end()) {
        return known->second;
    }
    std::optional<std::size_t>& index = known_[file.generic_string()];
    Reading reading = read_case(file);
    errors_.insert(errors_.end(), reading.errors.begin(), reading.errors.end());
    warnings_.insert(warnings_.end(), reading.warnings.begin(), reading.warnings.end());
    if (reading.problem) {
        index = runs_.size();
        runs_.push_back({.file = file, .problem = std::move(*reading.problem)});
    }
    return index;
}

void CaseCache::append_messages(ValidationReading& reading) const {
    for (const InputError& error : errors_) {
        const auto same = [&](const InputError& other) {
            return other.file == error.file && other.line == error.line && other.what == error.what;
        };
        if (std::none_of(reading.errors.begin(), reading.errors.end(), same)) {
            reading.errors.push_back(error);
        }
    }
    for (const std::string& warning : warnings_) {
        if (std::find(reading.warnings.begin(), reading.warnings.end(), warning) == reading.warnings.end()) {
            reading.warnings.push_back(warning);
        }
    }
}

}  // namespace tiretherm::input
