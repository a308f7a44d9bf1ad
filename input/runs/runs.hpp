// SPDX-License-Identifier: BSD-3-Clause
// Reads a case once for each of its measured runs; also used for a case without runs.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "input/runs/read_experiment.hpp"
#include "input/toml/document.hpp"
#include "solver/hot_spot/hot_spot.hpp"

namespace tiretherm::input {

/// A case with all its runs, as far as they could be read: sound only where there is no error.
struct Runs : CaseFindings {
    solver::Problem problem{};  ///< of the first run, or of the case itself
    Experiment experiment{};
    std::vector<solver::Critical> critical{};  ///< of `problem`

    /// The problem of a run by its name; of the first where that is empty or unknown.
    [[nodiscard]] const solver::Problem& problem_of(const std::string& run) const;
};

/// Reads the case once for each of its runs, with the run's tables over its own; the case itself where it has none.
/// @param name of the case  @param data files that take the place of the case's runs
[[nodiscard]] Runs read_runs(const TomlValue& document, const std::string& name,
                             const std::vector<std::filesystem::path>& data, ReadMode mode, InputErrors& errors);

/// "laser/one_watt" for .../cases/laser/one_watt.toml, otherwise the file's stem.
[[nodiscard]] std::string case_name(const std::filesystem::path& file);

/// Sentences without their repetitions: each run of a case says the same about it.
[[nodiscard]] std::vector<std::string> unique(const std::vector<std::string>& sentences);

}  // namespace tiretherm::input
