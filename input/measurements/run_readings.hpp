#pragma once

#include <string>
#include <vector>

#include "input/measurements/data_findings.hpp"
#include "input/measurements/experiment.hpp"
#include "input/measurements/run_inputs.hpp"

namespace tiretherm::input {

/// What the sensors' columns of a run's file say.
void read_series(const RunFile& file, const Draft& draft, Mistakes& mistakes, MeasuredRun& run);

/// Columns that the model does not use, where they are numbers.
void read_unused(const RunFile& file, const solver::Settings& settings, Mistakes& mistakes, MeasuredRun& run);

/// Numbers of the run with their uncertainty. One of the run's own without uncertainty is a mistake; one of the case
/// may stand there only to be shown.
/// @param document the case with the run's tables over it
void read_numbers(const Draft& draft, const Node& document, const RunTable& table, Mistakes& mistakes,
                  MeasuredRun& run);

/// A run against which nothing can be held is of no use.
/// @param file null: none, or one that could not be read  @param sensors names of the case's sensors
void require_readings(const MeasuredRun& run, const RunTable& table, const RunFile* file,
                      const std::vector<std::string>& sensors, Mistakes& mistakes);

/// What is to be looked at for suspicious signals.
[[nodiscard]] Recording recording_of(const RunFile& file, const Draft& draft, const MeasuredRun& run);

}  // namespace tiretherm::input
