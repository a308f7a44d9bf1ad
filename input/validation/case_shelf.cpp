#include <algorithm>
#include <system_error>

#include <fmt/format.h>

#include "input/model/reader.hpp"
#include "input/validation/validation_reader.hpp"
#include "input/text/words.hpp"

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

std::optional<std::size_t> CaseShelf::find(const std::string& path, const Place& mentioned, Mistakes& mistakes) {
    const fs::path file = (folder_ / path).lexically_normal();
    std::error_code error;
    if (!fs::is_regular_file(file, error)) {
        mistakes.add(mentioned, fmt::format("there is no case {}", path), neighbour(file));
        return std::nullopt;
    }
    const auto known = known_.find(file.generic_string());
    if (known != known_.end()) {
        return known->second;
    }
    std::optional<std::size_t>& index = known_[file.generic_string()];
    Reading reading = read_case(file);
    mistakes_.insert(mistakes_.end(), reading.mistakes.begin(), reading.mistakes.end());
    warnings_.insert(warnings_.end(), reading.warnings.begin(), reading.warnings.end());
    if (reading.problem) {
        index = runs_.size();
        runs_.push_back({.file = file, .problem = std::move(*reading.problem)});
    }
    return index;
}

void CaseShelf::append_complaints(ValidationReading& reading) const {
    for (const Mistake& mistake : mistakes_) {
        const auto same = [&](const Mistake& other) {
            return other.file == mistake.file && other.line == mistake.line && other.what == mistake.what;
        };
        if (std::none_of(reading.mistakes.begin(), reading.mistakes.end(), same)) {
            reading.mistakes.push_back(mistake);
        }
    }
    for (const std::string& warning : warnings_) {
        if (std::find(reading.warnings.begin(), reading.warnings.end(), warning) == reading.warnings.end()) {
            reading.warnings.push_back(warning);
        }
    }
}

}  // namespace tiretherm::input
