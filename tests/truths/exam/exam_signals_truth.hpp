// SPDX-License-Identifier: BSD-3-Clause
// Signals that hidden heat sources follow, and decoy columns in the logs.
#pragma once

#include <vector>

#include "exam/exam_data_set_truth.hpp"

namespace hidden_effects {

/// Puts what an unknown source follows in the place of the throttle of each run, 1 at its largest absolute value.
/// @param logged [n_runs] as the bench logs them
[[nodiscard]] std::vector<RigProgramme> driven_by(const HiddenSource& source, std::vector<RigProgramme> logged);

/// A source that follows what its bench offers, or one that follows something that is hidden better.
[[nodiscard]] HiddenSource draw_source(const Rig& rig, Kind kind, std::size_t n_runs, Random& random);

/// One column that is proportional to an input of the model, or three that have nothing to do with it: a temperature
/// that rises like a tire's, a pump that is on or off, and a slow wandering.
void add_decoys(std::vector<std::vector<Column>>& logs, const std::vector<RigProgramme>& programmes, Random& random);

}  // namespace hidden_effects
