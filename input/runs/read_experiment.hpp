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
#include "input/parameters/mesh_change.hpp"
#include "input/text/input_error.hpp"

namespace tiretherm::input {

/// An experiment that has been read. There is one exactly when there is no error.
struct ExperimentReading {
    std::optional<Experiment> experiment;
    std::vector<InputError> errors;
    std::vector<std::string> warnings;
    std::vector<std::string> data_warnings;  ///< what is suspicious about the data, a sentence each
    std::vector<std::string> files{};        ///< all that were read: the case, what it includes, logs, frames, tables
    std::vector<PlySummary> plies{};         ///< materials of cords in rubber that layers are made of
};

/// Whether measured values are required.
enum class ReadMode : std::uint8_t {
    measured,  ///< something must have been measured
    planned    ///< runs without measured values say what is going to be done
};

/// Reads a case with its [[run]] tables and [[parameter]] tables, all files that they mention included.
/// @param data files of runs that take the place of the case's own; their columns have standard names
/// @param change of the mesh, to see what the grid's error is
[[nodiscard]] ExperimentReading read_experiment(const std::filesystem::path& file,
                                                const std::vector<std::filesystem::path>& data = {},
                                                ReadMode mode = ReadMode::measured, const MeshChange& change = {});

}  // namespace tiretherm::input
