// SPDX-License-Identifier: BSD-3-Clause
// Says of each column that the model does not use what it is, so that a diagnosis takes nothing for a cause that is an effect.
#pragma once

#include <string>
#include <vector>

#include "input/measurements/experiment.hpp"
#include "input/toml/toml_table.hpp"

namespace tiretherm::input {

/// Sets kind, reason and may_be_cause of the unused columns, of all runs together: by name and unit, then by their course
/// beside the inputs, the temperature sensors and each other. A column has one kind in all runs.
void classify_unused(std::vector<MeasuredRun>& runs);

/// The keys `signals` and `ignore` of [diagnose]: names of columns, `*` and `?` in them.
struct SignalChoice {
    bool has_signals = false;  ///< only these are tried, whatever they are
    std::vector<LocatedString> signals;
    std::vector<LocatedString> ignored;  ///< never tried
};
[[nodiscard]] SignalChoice read_signal_choice(TomlTable& diagnose);

/// Lets the choice decide which columns may be causes. A word of `signals` that means no column is an error, one of `ignore` a
/// warning. Without files, or where one could not be read, nothing is decided.
void choose_signals(const SignalChoice& choice, std::vector<MeasuredRun>& runs, InputErrors& errors);

/// A column as a page of results has it.
struct ColumnSummary {
    std::string name;
    ColumnKind kind = ColumnKind::drive;
    std::string reason;
    bool may_be_cause = true;
};
/// The unused columns of all runs, each once, in the order of the files.
[[nodiscard]] std::vector<ColumnSummary> unused_columns(const std::vector<MeasuredRun>& runs);

/// A kind in words: "temperature of the tire".
[[nodiscard]] std::string_view text_of(ColumnKind kind);
/// A kind as files have it: "temperature_of_tire".
[[nodiscard]] std::string_view word_of(ColumnKind kind);

}  // namespace tiretherm::input
