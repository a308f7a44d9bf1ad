// SPDX-License-Identifier: BSD-3-Clause
// Columns of logs as signals over a run: their base units, their samples, and gaps in which they are not known.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "input/laps/repeated_lap.hpp"
#include "input/text/input_error.hpp"
#include "solver/shared_samples.hpp"
#include "solver/user_effect.hpp"

namespace tiretherm::input {

/// A column of a file that formulas may refer to, in SI base units: "37 %" is 0.37, "20 degC" is 293.15 K.
struct UserColumn {
    std::string name;
    std::string unit;  ///< the base units, "1", "K", "Pa" as "kg.m-1.s-2"
    solver::SignalHistory signal;
    std::string beside{};  ///< of a signal of a car that says nothing: another column that may be it, and moves
};

/// The base units into which a column's own unit is turned; "1" where it has none or an unknown one.
[[nodiscard]] std::string base_unit(const std::optional<std::string>& unit);

/// The column of this name; null: there is none.
[[nodiscard]] const UserColumn* find_column(const std::vector<UserColumn>& columns, std::string_view name);

/// An input may be missing in this share of its samples, or of a run's time.
constexpr double most_missing_share = 0.1;
/// s; a logger that leaves single fields empty, each no longer than this, may leave more of them so
constexpr double short_gap = 1.0;

/// Whether an input is no longer known in a gap of a run: it lasts longer than 60 s and than 5 % of the run. @param gap s
[[nodiscard]] bool too_long_a_gap(double gap, double length);

/// The samples that have a value. @param time [n] s  @param value [n], NaN where it is missing
[[nodiscard]] solver::SignalHistory known_samples(const std::vector<double>& time, const std::vector<double>& value);

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

/// A column that drives something.
struct DrivingColumn {
    const std::string& name;
    solver::SharedSamples time;  ///< s
    std::vector<double> value;   ///< [time] SI, NaN where it is missing
    bool holds = false;          ///< each value counts until the next sample
    RepeatedLap before{};        ///< that is driven before
};
/// How it drives: a missing sample is left out, so that the signal goes straight between its neighbours.
struct DrivingSamples {
    solver::SharedSamples time;  ///< s; that of the column where nothing is left out
    solver::SharedSamples value;
};
/// Gaps are an error, or a warning. @returns nothing after an error: too much is missing
[[nodiscard]] std::optional<DrivingSamples> driving_samples(DrivingColumn column, const GapRemedy& remedy,
                                                            InputErrors& errors);

}  // namespace tiretherm::input
