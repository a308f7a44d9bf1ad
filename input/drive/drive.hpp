// SPDX-License-Identifier: BSD-3-Clause
// The table [drive] and the inputs of a measured run, which win over it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "input/laps/laps.hpp"
#include "input/measurements/driven_signals.hpp"
#include "input/toml/toml_table.hpp"
#include "solver/problem.hpp"

namespace tiretherm::input {

/// An input that the file of a measured run gives.
struct MeasuredInput {
    const physics::Signal* signal = nullptr;
    SourceLocation place;  ///< of its heading
    solver::SharedSamples time;
    solver::SharedSamples value;  ///< [time]; empty after an error
};

/// What a sensor reads that [initial] names in the place of a temperature.
struct StartReading {
    std::string sensor;             ///< or one of an array's channels
    solver::SignalHistory reading;  ///< s, K
};

/// What the file of a measured run gives beside the tables of the case. It wins over them, but not over tables of the
/// run's own.
struct RunInputs {
    const TomlValue* table = nullptr;  ///< the run's own; null for a file given beside the case
    std::string name;
    SourceLocation place;  ///< where the file is mentioned, or the run
    bool has_file = false;
    bool unreadable = false;  ///< which inputs the file would give is unknown: no missing one is reported
    std::vector<MeasuredInput> inputs{};
    std::vector<UserColumn> columns{};    ///< that user effects follow; without points after an error
    std::vector<std::string> headings{};  ///< of all columns of the file
    std::vector<StartReading> start_readings{};
    double file_first = 0.0;            ///< s, of the file's first sample, whether or not it is in the run
    std::optional<double> first{};      ///< s, first time in the run's part of the file, less `lead`
    bool part_of_file = false;          ///< `from` or `laps` choose where it begins
    double lead = 0.0;                  ///< s, for which laps are driven before
    std::vector<LapWindow> left_out{};  ///< whose readings do not count
    std::optional<double> last{};       ///< s, last time in the file
    CourseOverGround course{};          ///< where the case has a car, and its file says where it drives

    /// Whether the file gives anything that acts on the tire.
    [[nodiscard]] bool drives() const { return unreadable || !inputs.empty() || !columns.empty(); }
    /// Whether the run has a value of its own for the key of a table.
    [[nodiscard]] bool says(std::string_view of_table, std::string_view key) const;
    /// Whether a signal that stands in [drive] at this key comes from the file instead.
    [[nodiscard]] bool overrides(std::string_view key, std::string_view signal) const;
};

/// The times of what drives a run, s.
struct DrivenSpan {
    std::optional<double> logged_from{};  ///< first sample of any log of [drive]
    std::optional<double> logged_to{};    ///< last sample of any log of [drive]
    std::optional<double> from{};         ///< first row of any schedule or log
    std::optional<double> to{};           ///< last row of any schedule or log
};

/// The table [drive] as it was read.
struct DriveTable {
    DrivenSignals signals{};
    DrivenSpan span{};
};

/// @param run that is measured, null: none  @param followed names that user effects and [vehicle] refer to
[[nodiscard]] DriveTable read_drive(TomlTable& root, const RunInputs* run, const std::vector<std::string>& followed);

/// The table [time]. @param run that is measured, null: none
[[nodiscard]] solver::Settings read_time_settings(TomlTable& root, const DrivenSpan& span, const RunInputs* run);

/// The table [initial]: temperatures of the nodes, K; empty after an error.
/// @param problem with its mesh, inputs and settings  @param run that is measured, null: none
[[nodiscard]] std::vector<double> read_initial(TomlTable& root, const solver::Problem& problem,
                                               const GivenSignals& given, const RunInputs* run);

}  // namespace tiretherm::input
