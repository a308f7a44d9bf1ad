// SPDX-License-Identifier: BSD-3-Clause
// Which way an input counts as positive, in words, for every input signal.
#pragma once

#include <string_view>

#include "physics/signals.hpp"

namespace tiretherm::physics {

/// Which way an input counts as positive, and what its sign means to the laws that read it. Axes as drawn in
/// docs/axes.svg: x forwards, y to the left, z up, of a tire on the right-hand side of the vehicle.
/// @returns sentences; empty for none of the signals
[[nodiscard]] std::string_view sign_convention(const Signal& signal);

}  // namespace tiretherm::physics
