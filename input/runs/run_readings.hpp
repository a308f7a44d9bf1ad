// SPDX-License-Identifier: BSD-3-Clause
// Measured values of a run: sensor columns of its file and the numbers of [[measured]].
#pragma once

#include <string>
#include <vector>

#include "input/drive/run_inputs.hpp"
#include "input/measurements/data_warnings.hpp"
#include "input/measurements/experiment.hpp"

namespace tiretherm::input {

/// What the sensors' columns of a run's file say.
void read_series(const RunFile& file, const solver::Problem& problem, InputErrors& errors, MeasuredRun& run);

/// Columns that the model does not use, where they are numbers.
/// @param beside the run of another corner, whose columns are the same where its samples are; null: none
void read_unused(const RunFile& file, const solver::Settings& settings, const MeasuredRun* beside, InputErrors& errors,
                 MeasuredRun& run);

/// Warns where gas or rim start far from what their sensor reads first, because [initial] does not say where.
/// @param document the case with the run's tables over it
void warn_of_starts(const TomlValue& document, const solver::Problem& problem, const MeasuredRun& run,
                    InputErrors& errors);

/// Numbers of the run with their uncertainty. One of the run's own without uncertainty is an error; one of the case
/// may stand there only to be shown.
/// @param document the case with the run's tables over it
void read_numbers(const solver::Problem& problem, const TomlValue& document, const RunTable& table, InputErrors& errors,
                  MeasuredRun& run);

/// A run without measured values is an error.
/// @param file null: none, or one that could not be read  @param sensors names of the case's sensors
void require_readings(const MeasuredRun& run, const RunTable& table, const RunFile* file,
                      const std::vector<std::string>& sensors, InputErrors& errors);

/// What is to be looked at for suspicious signals.
[[nodiscard]] Recording recording_of(const RunFile& file, const RunInputs& inputs, const solver::Problem& problem,
                                     const MeasuredRun& run);

}  // namespace tiretherm::input
