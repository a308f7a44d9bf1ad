// SPDX-License-Identifier: BSD-3-Clause
// Programmes of inputs for the section bench, drawn from a seed.
#pragma once

#include <cstdint>
#include <vector>

#include "two_node/programme_truth.hpp"

namespace hidden_effects {

/// A programme on which the wheel leans too.
struct SectionProgramme : Programme {
    std::vector<double> camber;  ///< rad, negative: top inboard
};

/// Forty minutes, a sample every `interval` seconds: a minute at rest, then speeds, loads, camber and slip angles held for
/// one to six minutes with ramps of four seconds between them; now and then nearly unloaded or at rest. What is logged
/// has the digits of a log, and the truth is driven by what is logged.
[[nodiscard]] SectionProgramme draw_section_programme(std::uint64_t seed, double interval = 4.0);

}  // namespace hidden_effects
