// SPDX-License-Identifier: BSD-3-Clause
// Input signals of a measured run, read from the columns of the file that [[run]] or --data names.
#pragma once

#include <optional>

#include "input/drive/run_columns.hpp"
#include "input/laps/laps.hpp"
#include "input/laps/repeated_lap.hpp"
#include "input/model/problem_builder.hpp"

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

/// An input may be missing in this share of its samples, or of a run's time.
constexpr double most_missing_share = 0.1;
/// s; a logger that leaves single fields empty, each no longer than this, may leave more of them so
constexpr double short_gap = 1.0;

/// Whether an input is no longer known in a gap of a run: it lasts longer than 60 s and than 5 % of the run. @param gap s
[[nodiscard]] bool too_long_a_gap(double gap, double length);

/// The samples that have a value. @param time [n] s  @param value [n], NaN where it is missing
[[nodiscard]] solver::SignalHistory known_samples(const std::vector<double>& time, const std::vector<double>& value);

/// A signal of which each value counts until the next sample: a jump there, as two points at one time.
[[nodiscard]] solver::SignalHistory held(const solver::SignalHistory& samples);

/// Why a signal with these gaps is not known well enough to drive a run; nothing where it is.
/// @param time [n] s  @param value [n], NaN where it is missing
/// @returns with the remedy of a run that can be split; without one where nothing is known
[[nodiscard]] std::optional<ErrorText> gap_error(const std::string& name, const std::vector<double>& time,
                                                 const std::vector<double>& value);

/// What to do about a signal with gaps.
struct GapRemedy {
    SourceLocation place;    ///< of the column
    std::string elsewhere;   ///< where to have the signal from instead
    bool can_split = false;  ///< a part of the file may be left out
};

/// Reports gaps in a signal as an error, or as a warning. @returns whether it is known well enough
bool judge_gaps(const std::string& name, const std::vector<double>& time, const std::vector<double>& value,
                const GapRemedy& remedy, InputErrors& errors);

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
