// SPDX-License-Identifier: BSD-3-Clause
// Reads each case of a validation table once, and once for each end of an input that changes it; collects the errors and
// warnings of all.

#include <algorithm>
#include <system_error>

#include <fmt/format.h>

#include "input/runs/reader.hpp"
#include "input/runs/runs.hpp"
#include "input/text/suggestions.hpp"
#include "input/validation/validation_reader.hpp"

namespace tiretherm::input {

namespace {

namespace fs = std::filesystem;

bool is_file(const fs::path& path) {
    std::error_code error;
    return fs::is_regular_file(path, error);
}

/// The text of the case of a model that takes another's, or nothing where there is none to take.
std::optional<std::string> text_of(const fs::path& file, const std::vector<ValidationModel>& models) {
    const std::string name = file.filename().string();
    for (const ValidationModel& model : models) {
        const std::string ending = fmt::format("_{}.toml", model.key);
        if (model.of.empty() || !name.ends_with(ending)) {
            continue;
        }
        const std::string base = fmt::format("{}_{}.toml", name.substr(0, name.size() - ending.size()), model.of);
        if (is_file(file.parent_path() / base) && is_file(file.parent_path() / model.with)) {
            return fmt::format("include = ['{}', '{}']\n", base, model.with);
        }
    }
    return std::nullopt;
}

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

// A case that the table makes from another one has no file: its text is in texts_.
std::optional<TomlValue> CaseCache::parsed(const fs::path& file, InputErrors& errors) const {
    const auto text = texts_.find(file);
    return read_document(file, errors, text == texts_.end() ? nullptr : &text->second);
}

std::optional<std::size_t> CaseCache::find(const std::string& path, const SourceLocation& mentioned,
                                           InputErrors& errors) {
    const fs::path file = (folder_ / path).lexically_normal();
    if (!is_file(file) && !texts_.contains(file)) {
        std::optional<std::string> text = text_of(file, models_);
        if (!text) {
            return errors.add(mentioned, fmt::format("there is no case {}", path), neighbour(file));
        }
        texts_[file] = std::move(*text);
    }
    const auto known = known_.find(file.generic_string());
    if (known != known_.end()) {
        return known->second;
    }
    std::optional<std::size_t>& index = known_[file.generic_string()];
    const auto text = texts_.find(file);
    Reading reading = text == texts_.end() ? read_case(file) : read_case(file, text->second);
    errors_.insert(errors_.end(), reading.errors.begin(), reading.errors.end());
    warnings_.insert(warnings_.end(), reading.warnings.begin(), reading.warnings.end());
    if (reading.problem) {
        index = runs_.size();
        runs_.push_back({.file = file, .changed = {}, .problem = std::move(*reading.problem)});
    }
    return index;
}

bool CaseCache::is_case(std::size_t index, std::string_view name) const {
    const std::string path = runs_[index].file.generic_string();
    const std::string wanted = (folder_ / name).lexically_normal().generic_string();
    return path == wanted || path == wanted + ".toml" ||
           std::ranges::any_of(models_, [&](const ValidationModel& model) {
               return path == fmt::format("{}_{}.toml", wanted, model.key);
           });
}

void CaseCache::check_names(const std::vector<LocatedString>& names, InputErrors& errors) const {
    for (const LocatedString& name : names) {
        const fs::path path = (folder_ / name.text).lexically_normal();
        const auto exists = [&](const std::string& ending) { return is_file(path.generic_string() + ending); };
        const bool known =
            exists("") || exists(".toml") || std::ranges::any_of(models_, [&](const ValidationModel& model) {
                return exists(fmt::format("_{}.toml", model.key));
            });
        if (!known) {
            errors.add(name.place, fmt::format("there is no case {}", name.text),
                       neighbour(path.generic_string() + ".toml"));
        }
    }
}

bool CaseCache::acts(const InputDefinition& input, std::size_t index, InputErrors& errors) {
    const bool belongs = input.cases.empty() || std::ranges::any_of(input.cases, [&](const LocatedString& name) {
                             return is_case(index, name.text);
                         });
    if (!belongs) {
        return false;
    }
    const fs::path& file = runs_[index].file;
    const auto [known, is_new] =
        acts_.try_emplace(fmt::format("{}\n{}", input.shown.name, file.generic_string()), false);
    if (is_new) {
        InputErrors unheard;
        const std::optional<TomlValue> document = parsed(file, unheard);
        const InputTrace trace = document ? find_in_case(input, *document) : InputTrace{};
        known->second = trace.acts;
        if (!trace.other_value.empty()) {
            errors.add(
                input.place,
                fmt::format("the value is {}, but {} has {}", input.shown.value, case_name(file), trace.other_value),
                "let value be that of the cases, or name those that have it: cases = [\"...\"]");
        }
    }
    return known->second;
}

std::optional<std::size_t> CaseCache::at_end(const InputDefinition& input, std::size_t end, std::size_t index,
                                             const InputErrors& errors) {
    const fs::path file = runs_[index].file;
    const std::string changed = fmt::format("{} = {}", input.shown.name, input.shown.ends[end]);
    const auto known = known_.find(fmt::format("{}\n{}", file.generic_string(), changed));
    if (known != known_.end()) {
        return known->second;
    }
    std::optional<std::size_t>& found = known_[fmt::format("{}\n{}", file.generic_string(), changed)];
    InputErrors own = errors;  // knows the files: values of the table stand in the case
    const std::size_t before = own.count();
    std::optional<TomlValue> document = parsed(file, own);
    if (!document) {
        return std::nullopt;
    }
    change_case(input, end, *document, own);
    solver::Problem problem = read_runs(*document, case_name(file), {}, ReadMode::measured, own).problem;
    if (own.count() > before) {
        const std::vector<InputError> all = own.in_order();
        errors_.insert(errors_.end(), all.begin(), all.end());
        return std::nullopt;
    }
    found = runs_.size();
    runs_.push_back({.file = file, .changed = changed, .problem = std::move(problem)});
    return found;
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
