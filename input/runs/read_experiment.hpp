// SPDX-License-Identifier: BSD-3-Clause
// Entry point for measured cases: a case file with its runs, or a list of input errors.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "input/materials/ply_summary.hpp"
#include "input/measurements/experiment.hpp"
#include "input/model/size_limits.hpp"
#include "input/parameters/column_change.hpp"
#include "input/parameters/mesh_change.hpp"
#include "input/text/input_error.hpp"

namespace tiretherm::input {

/// What comes of reading a case beside what it is read for.
struct CaseFindings {
    std::vector<InputError> errors{};          ///< all of the case and of its files, in the order of their places
    std::vector<std::string> warnings{};       ///< unusual but possible: "case.toml:12: ..."
    std::vector<std::string> data_warnings{};  ///< what is suspicious about the logs of its runs, a sentence each
    std::vector<std::string> files{};          ///< all that were read: the case, what it includes, logs, frames, tables
    SizeLimits limits{};
    std::vector<PlySummary> plies{};     ///< materials of cords in rubber that layers are made of
    std::vector<std::string> corners{};  ///< of the case: FL, FR ...; empty: it is of one tire

    /// Takes what was said so far. What several corners say alike stands once.
    void take(const InputErrors& said);
};

/// An experiment that has been read. There is one exactly when there is no error.
struct ExperimentReading : CaseFindings {
    std::optional<Experiment> experiment{};
};

/// Whether measured values are required.
enum class ReadMode : std::uint8_t {
    measured,  ///< something must have been measured
    planned    ///< runs without measured values say what is going to be done
};

/// Reads a case with its [[run]] tables and [[parameter]] tables, all files that they mention included.
/// @param data files of runs that take the place of the case's own; their columns have standard names
/// @param change of the mesh, to see what the grid's error is
/// @param columns that are read otherwise than the case and the files say
[[nodiscard]] ExperimentReading read_experiment(const std::filesystem::path& file,
                                                const std::vector<std::filesystem::path>& data = {},
                                                ReadMode mode = ReadMode::measured, const MeshChange& change = {},
                                                const std::vector<ColumnChange>& columns = {});

}  // namespace tiretherm::input
