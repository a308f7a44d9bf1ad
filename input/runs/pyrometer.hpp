// SPDX-License-Identifier: BSD-3-Clause
// Readings of a pyrometer at a stop: inner, centre, outer of each tire, once or several times in a run.
#pragma once

#include "input/drive/run_inputs.hpp"
#include "input/drive/run_table.hpp"

namespace tiretherm::input {

/// Adds the readings of this run, at its corner, to the list [[measured]] of its document. Readings of several places that have one
/// sensor are one number, their mean: two lumps know no places.
/// @param file of the run, null without one  @param runs all of the case, among which [[pyrometer]] may choose
void add_pyrometer_readings(TomlValue& document, const RunTable& run, const RunFile* file,
                            const std::vector<RunTable>& runs, InputErrors& errors);

}  // namespace tiretherm::input
