// SPDX-License-Identifier: BSD-3-Clause
// Interfaces within the reader of a validation table: case cache, evaluation and number.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "input/toml/toml_table.hpp"
#include "input/validation/validation.hpp"

/// The parts of the reader of a validation table.
namespace tiretherm::input {

/// Cache of the cases that a table names: each is read once, when it is first named.
class CaseCache {
public:
    /// @param folder of the table, where the paths of its cases begin
    explicit CaseCache(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// @param path relative to the folder, with its ending   @param mentioned where it was written
    /// @returns the case's index, or nothing when it is missing or has errors
    std::optional<std::size_t> find(const std::string& path, const SourceLocation& mentioned, InputErrors& errors);
    [[nodiscard]] const solver::Problem& problem(std::size_t index) const { return runs_[index].problem; }

    /// What is wrong with the cases, each sentence once: cases share files.
    void append_messages(ValidationReading& reading) const;
    [[nodiscard]] std::vector<ValidationRun> take_runs() { return std::move(runs_); }

private:
    std::filesystem::path folder_;
    std::map<std::string, std::optional<std::size_t>> known_;
    std::vector<ValidationRun> runs_;
    std::vector<InputError> errors_;
    std::vector<std::string> warnings_;
};

/// How a number is evaluated from the results of its models, and what kind of number that makes it.
struct Evaluation {
    std::array<std::optional<Expression>, n_models> models;
    Meaning meaning = Meaning::value;
    std::optional<solver::Quantity> quantity;  ///< empty when no model could be read
};

/// The keys case, files, models, channel, at, take, from, to, time_to, minus, over.
[[nodiscard]] Evaluation read_evaluation(TomlTable& table, CaseCache& cache);

/// One [[number]].
[[nodiscard]] ValidationNumber read_number(TomlTable& table, CaseCache& cache);

}  // namespace tiretherm::input
