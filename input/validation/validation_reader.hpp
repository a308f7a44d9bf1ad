#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "input/text/section.hpp"
#include "input/validation/validation.hpp"

/// The parts of the reader of a validation table.
namespace tiretherm::input {

/// The cases that a table names, each read once, when it is first named.
class CaseShelf {
public:
    /// @param folder of the table, where the paths of its cases begin
    explicit CaseShelf(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// @param path relative to the folder, with its ending   @param mentioned where it was written
    /// @returns the case's index, or nothing when it is missing or has mistakes
    std::optional<std::size_t> find(const std::string& path, const Place& mentioned, Mistakes& mistakes);
    [[nodiscard]] const solver::Problem& problem(std::size_t index) const { return runs_[index].problem; }

    /// What is wrong with the cases, each sentence once: cases share files.
    void append_complaints(ValidationReading& reading) const;
    [[nodiscard]] std::vector<ValidationRun> take_runs() { return std::move(runs_); }

private:
    std::filesystem::path folder_;
    std::map<std::string, std::optional<std::size_t>> known_;
    std::vector<ValidationRun> runs_;
    std::vector<Mistake> mistakes_;
    std::vector<std::string> warnings_;
};

/// How a number is read from its models, and what kind of number that makes it.
struct Reckoning {
    std::array<std::optional<Expression>, n_models> models;
    Meaning meaning = Meaning::value;
    std::optional<solver::Quantity> quantity;  ///< empty when no model could be read
};

/// The keys case, files, models, channel, at, take, from, to, time_to, minus, over.
[[nodiscard]] Reckoning read_reckoning(Section& section, CaseShelf& shelf);

/// One [[number]].
[[nodiscard]] ValidationNumber read_number(Section& section, CaseShelf& shelf);

}  // namespace tiretherm::input
