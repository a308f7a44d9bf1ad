// SPDX-License-Identifier: BSD-3-Clause
// The made-up logs of the section bench and of the bench of layers that come with the cases.
#pragma once

#include <vector>

#include "section/section_truth.hpp"
#include "two_node/shipped_truth.hpp"

namespace hidden_effects {

/// Standard deviations of the sensors' noise, in the order of section_channels. K
inline constexpr std::array<double, section_channels.size()> section_noise{0.5, 0.3, 0.3, 0.3, 0.2};

/// The bench of a section, cases/practice: three runs with nothing hidden.
[[nodiscard]] std::vector<ShippedLog> section_logs();
/// The bench of its crown alone, in layers: three runs with nothing hidden.
[[nodiscard]] std::vector<ShippedLog> layers_logs();

}  // namespace hidden_effects
