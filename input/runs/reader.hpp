// SPDX-License-Identifier: BSD-3-Clause
// Entry point for case files: a TOML file with its includes and data files becomes a problem, or a list of input
// errors.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "input/laps/laps.hpp"
#include "input/runs/read_experiment.hpp"
#include "input/toml/document.hpp"
#include "solver/problem.hpp"

/// What a user writes: case files in TOML with units, logs in CSV, and what is wrong with them.
namespace tiretherm::input {

/// A run of a case as it is simulated.
struct RunOfCase {
    std::string name{};    ///< empty: the case has neither [[run]] nor [[corner]]
    std::string corner{};  ///< FL, FR, RL or RR; empty: the case has no [[corner]]
    solver::Problem problem;
    std::vector<Lap> laps{};                          ///< of its log
    std::vector<solver::FreeParameter> parameters{};  ///< of [[parameter]], those that this run follows
};

/// A case that has been read. There is a problem exactly when there is no error.
struct Reading : CaseFindings {
    std::optional<solver::Problem> problem{};
    std::vector<std::string> runs{};  ///< names of the case's [[run]] tables; empty without any
    std::string run{};                ///< of them that which the problem is
    std::vector<RunOfCase> chosen{};  ///< of read_case_run: one run, or that of each corner
};

/// Reads a case file with all that it includes and mentions. Never throws on account of what a user wrote.
/// @errors std::runtime_error when the units' data base is not installed
[[nodiscard]] Reading read_case(const std::filesystem::path& file);
/// The same for one of the case's runs, which need not have measured anything: at all corners, where the case has any.
/// @param run its name, at one corner RUN_CORNER; empty: the first
[[nodiscard]] Reading read_case_run(const std::filesystem::path& file, const std::string& run);
/// The same of a document that has been read, such as one with other values. @param file of the case, for its name
[[nodiscard]] std::vector<RunOfCase> runs_of_document(const TomlValue& document, const std::filesystem::path& file,
                                                      const std::string& run, InputErrors& errors);
/// The same with a text in the place of the file's own, which need not be there yet.
[[nodiscard]] Reading read_case(const std::filesystem::path& file, const std::string& text);

/// All errors and warnings of a reading as a compiler shows them, empty when there is none.
[[nodiscard]] std::string render(const CaseFindings& reading);

}  // namespace tiretherm::input
