// SPDX-License-Identifier: BSD-3-Clause
// Which effects, numbers of effects and errors of instruments may be added to the runs of a table, each within the range
// that an engineer expects.
#pragma once

#include <string>
#include <vector>

#include "diagnosis/detect/candidates.hpp"
#include "diagnosis/quoted/addition.hpp"

namespace tiretherm::diagnosis::quoted {

inline constexpr const char* gain_key = "gain";
inline constexpr const char* offset_key = "offset";
inline constexpr double gain_reference = 298.15;  ///< K, as of sensor_gain: the temperature that is read right

/// What may be added to a run: effects that are off, and numbers of effects that are on. Not the user's own effects,
/// sensor models, and what has no plausible range.
[[nodiscard]] std::vector<Candidate> candidates_in(const solver::Problem& problem);
/// Whether a candidate of a run is what an addition means.
[[nodiscard]] bool is_of(const Candidate& candidate, const Addition& addition, const solver::Problem& problem);
/// Adds those that are not there yet, with their plausible ranges.
void add_effects(std::vector<Addition>& all, const std::vector<Candidate>& candidates, const solver::Problem& problem);

/// A sensor's name without its side: "bulk_temperature" of "inside_shoulder_bulk_temperature".
[[nodiscard]] std::string instrument_of(const std::string& channel);
/// Offset and gain of all sensors of this name. @param source first word of the sources that quote them
void add_instrument(std::vector<Addition>& all, const std::string& name, const std::string& source);

}  // namespace tiretherm::diagnosis::quoted
