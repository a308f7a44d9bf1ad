// SPDX-License-Identifier: BSD-3-Clause
// Input signals of a measured run, read from the columns of the file that [[run]] or --data names.
#pragma once

#include <optional>

#include "input/drive/drive.hpp"
#include "input/drive/run_columns.hpp"
#include "input/laps/laps.hpp"
#include "input/laps/repeated_lap.hpp"

namespace tiretherm::input {

/// The file of a measured run: what its columns are, and which of its samples belong to the run.
struct RunFile {
    DataFile file;
    RunColumns columns;
    std::vector<double> time{};         ///< s, ascending, all samples; empty after an error
    std::size_t first = 0;              ///< sample within `from` and `to` of the run
    std::size_t last = 0;               ///< one past the last of them
    Laps laps{};                        ///< of the whole file
    std::vector<LapWindow> left_out{};  ///< whose readings do not count
    RepeatedLap repeated{};
};

/// Opens the run's file and finds its samples; nothing after an error.
/// @param document the case with the run's tables over it
/// @param sensors names of the case's sensors  @param followed names that user effects refer to
[[nodiscard]] std::optional<RunFile> open_run_file(const RunTable& run, const TomlValue& document,
                                                   const std::vector<std::string>& sensors,
                                                   const std::vector<std::string>& followed, InputErrors& errors);

/// Reads the times of the rows that the chosen columns have. @returns false after an error
bool read_times(RunFile& file, InputErrors& errors);

/// What a file gives that drives something.
struct DrivingColumns {
    std::vector<MeasuredInput> inputs{};
    std::vector<UserColumn> followed{};  ///< in base units whatever their unit is; without points after an error
};
/// The inputs and the followed columns of a file, from its `first` sample to its `last`. What a column says while nothing is measured
/// is missing, with a warning, unless the case keeps it. @param can_split as GapRemedy has it
[[nodiscard]] DrivingColumns read_driving(const RunFile& file, ColumnKeys& keys, bool can_split, InputErrors& errors);

/// The inputs that the file gives. A missing sample is left out, so that the input goes straight between its neighbours;
/// where too much is missing that would be an invention, and is an error.
[[nodiscard]] RunInputs read_run_inputs(const RunTable& run, const RunFile* file, InputErrors& errors);

/// The readings of the sensors from which a run starts: those that [initial] names.
/// What is no reading is left out, unless the run keeps what is suspicious.
/// @param inputs of the run: a reading may jump with them  @param document the case with the run's tables over it  @param errors so far, to which nothing is added: what is wrong with
/// a sensor's column is said where it is read as measured
[[nodiscard]] std::vector<StartReading> start_readings(const RunTable& run, const RunFile& file,
                                                       const RunInputs& inputs, const TomlValue& document,
                                                       const InputErrors& errors);

}  // namespace tiretherm::input
