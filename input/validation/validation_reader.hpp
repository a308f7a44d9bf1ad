// SPDX-License-Identifier: BSD-3-Clause
// Interfaces within the reader of a validation table: case cache, evaluation, inputs and number.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "input/toml/toml_table.hpp"
#include "input/validation/input_definition.hpp"
#include "input/validation/validation.hpp"

/// The parts of the reader of a validation table.
namespace tiretherm::input {

/// Cache of the cases that a table names: each is read once, when it is first named.
class CaseCache {
public:
    /// @param folder of the table, where the paths of its cases begin
    CaseCache(std::filesystem::path folder, const std::vector<ValidationModel>& models)
        : folder_(std::move(folder)), models_(models) {}

    [[nodiscard]] const std::vector<ValidationModel>& models() const { return models_; }

    /// @param path relative to the folder, with its ending   @param mentioned where it was written
    /// @returns the case's index, or nothing when it is missing or has errors
    std::optional<std::size_t> find(const std::string& path, const SourceLocation& mentioned, InputErrors& errors);
    [[nodiscard]] const solver::Problem& problem(std::size_t index) const { return runs_[index].problem; }

    /// Reports names of cases that are no files.
    void check_names(const std::vector<LocatedString>& names, InputErrors& errors) const;
    /// Whether an input acts on a case: it belongs to its cases, and the case gives what it changes. Reports a case that
    /// has another value than the input says, once.
    [[nodiscard]] bool acts(const InputDefinition& input, std::size_t index, InputErrors& errors);
    /// The case with an input at an end of its range.
    /// @param errors of the table; a copy of them reads the changed case   @returns nothing when it has errors
    /// @pre acts(input, index)
    std::optional<std::size_t> at_end(const InputDefinition& input, std::size_t end, std::size_t index,
                                      const InputErrors& errors);
    /// Whether a case is the one that a table calls `name`: its path, with or without model and ending.
    [[nodiscard]] bool is_case(std::size_t index, std::string_view name) const;

    /// What is wrong with the cases, each sentence once: cases share files.
    void append_messages(ValidationReading& reading) const;
    [[nodiscard]] std::vector<ValidationRun> take_runs() { return std::move(runs_); }

private:
    /// A case with what it includes, or nothing after an error.
    std::optional<TomlValue> parsed(const std::filesystem::path& file, InputErrors& errors) const;

    std::filesystem::path folder_;
    std::vector<ValidationModel> models_;
    std::map<std::filesystem::path, std::string> texts_;  ///< of cases that are no files
    std::map<std::string, std::optional<std::size_t>> known_;
    std::map<std::string, bool> acts_;  ///< by input and case
    std::vector<ValidationRun> runs_;
    std::vector<InputError> errors_;
    std::vector<std::string> warnings_;
};

/// How a number is evaluated from the results of its models, and what kind of number that makes it.
struct Evaluation {
    std::vector<std::optional<Expression>> models;  ///< [models]
    Meaning meaning = Meaning::value;
    std::optional<solver::Quantity> quantity;  ///< empty when no model could be read
};

/// The keys case, files, models, channel, at, take, from, to, time_to, minus, over.
[[nodiscard]] Evaluation read_evaluation(TomlTable& table, CaseCache& cache);

/// One [[number]]. @param inputs all [[input]] of the table
[[nodiscard]] ValidationNumber read_number(TomlTable& table, const std::vector<InputDefinition>& inputs,
                                           CaseCache& cache);

/// The keys inputs and inferred_from_it of a number whose models have been read.
[[nodiscard]] std::vector<NumberInput> read_number_inputs(TomlTable& table, const std::vector<InputDefinition>& inputs,
                                                          const Evaluation& evaluation, CaseCache& cache);

/// Every readout of an expression, for its run to be asked or changed.
template <typename OneExpression, typename Visit>
void visit_readouts(OneExpression& expression, const Visit& visit) {
    const auto both = [&](auto& difference) {
        visit(difference.of);
        if (difference.minus) {
            visit(*difference.minus);
        }
    };
    both(expression.of);
    if (expression.over) {
        both(*expression.over);
    }
}

}  // namespace tiretherm::input
