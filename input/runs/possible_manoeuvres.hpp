// SPDX-License-Identifier: BSD-3-Clause
// The manoeuvres of which a diagnosis chooses the next experiment.
#pragma once

#include <vector>

#include "input/measurements/experiment.hpp"
#include "input/toml/document.hpp"

namespace tiretherm::input {

/// The list [[diagnose.possible]], or without it the manoeuvres of cases/manoeuvres.toml.
/// @param runs of the case: a manoeuvre with an input that the first of them does not have is left out
[[nodiscard]] std::vector<Manoeuvre> read_possible(const TomlValue& document, const std::vector<MeasuredRun>& runs,
                                                   InputErrors& errors);

}  // namespace tiretherm::input
