// SPDX-License-Identifier: BSD-3-Clause
// Driving phase of a tire at a moment, determined from its inputs alone: standing, slipping, slowing down or free
// rolling.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "solver/problem.hpp"

namespace tiretherm::diagnosis {

/// What a tire is doing, determined from its inputs alone; the first that holds.
enum class Phase : std::uint8_t {
    standing,     ///< slower than 0.1 m/s: nothing is made, soak
    slipping,     ///< a slip angle of 0.3 degrees or more, or a slip ratio of 0.5 % or more
    slowing,      ///< speed falls faster than 0.01 g, which is what rolling resistance alone does: coasting, braking
    free_rolling  ///< anything else: rolling straight at a steady or rising speed
};
inline constexpr std::array phases{Phase::standing, Phase::slipping, Phase::slowing, Phase::free_rolling};

[[nodiscard]] std::string_view name_of(Phase phase);
/// "speed below 0.1 m/s"
[[nodiscard]] std::string_view meaning_of(Phase phase);

/// @param time s, within the run
[[nodiscard]] Phase phase_at(const solver::Problem& problem, double time);

}  // namespace tiretherm::diagnosis
