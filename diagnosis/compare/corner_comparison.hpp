// SPDX-License-Identifier: BSD-3-Clause
// What the corners of a car have in common in a comparison, and what only some of them show.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "diagnosis/compare/comparison_statistics.hpp"
#include "diagnosis/compare/phase.hpp"

namespace tiretherm::diagnosis {

struct PhaseFigures {
    Phase phase = Phase::standing;
    double share = 0.0;  ///< of the time with samples
    Figures figures;
};

/// A channel at one corner, over all its runs.
struct CornerFigures {
    std::string corner;  ///< FL, FR, RL or RR
    Figures figures;
    std::vector<PhaseFigures> phases;
};

/// Corners whose bias in a driving phase has one sign beyond chance.
struct CommonBias {
    Phase phase = Phase::standing;
    std::vector<std::string> corners{};
    std::string group{};  ///< "all", "front", "rear", "left" or "right", where they are just those; empty otherwise
    double least = 0.0;   ///< bias of the corner where it is smallest in magnitude, simulated - measured, SI
    double most = 0.0;    ///< and largest
    double share = 0.0;   ///< of the time with samples, mean over these corners
};

/// The longest phase first. A corner counts where its bias is more than twice its standard deviation. Nothing of fewer than
/// two corners. @param corners of one channel
[[nodiscard]] std::vector<CommonBias> common_biases(std::span<const CornerFigures> corners);

}  // namespace tiretherm::diagnosis
