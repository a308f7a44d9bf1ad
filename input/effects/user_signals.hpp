// SPDX-License-Identifier: BSD-3-Clause
// Signals for user effects: the history of a formula over a run.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "input/effects/formula_sampling.hpp"
#include "input/effects/user_formula.hpp"
#include "input/measurements/experiment.hpp"
#include "input/measurements/logged_signal.hpp"
#include "solver/user_effect.hpp"

/// What a user effect may follow: inputs, columns of a file, the time since the run's start, and formulas
/// of these.
namespace tiretherm::input {

/// What a formula makes of a run's signals. Its jumps and kinks are found exactly. Between them it has points at the
/// samples of a log; where it follows schedules, constants or the time, as many as its integral takes.
/// @param columns must have all signals of the formula that the input signals do not give
[[nodiscard]] FormulaSamples signal_history_of(const Formula& formula, const solver::InputSignals& input_signals,
                                               const std::vector<UserColumn>& columns,
                                               const solver::Settings& settings);

/// Why a run cannot be simulated with a formula, as the end of a sentence that begins with its key: it changes faster
/// than its points, or is not a finite number for longer than an input may be missing.
[[nodiscard]] std::optional<ErrorText> formula_error(const FormulaSamples& samples, const solver::Settings& settings);

/// The same for a measured run, as a table [[source]] with this formula is read: inputs, unused columns, sensors.
/// @errors std::invalid_argument for what is no formula of the run's signals
[[nodiscard]] solver::SignalHistory signal_history_of(std::string_view follows, const MeasuredRun& run);

}  // namespace tiretherm::input
