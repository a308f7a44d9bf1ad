// SPDX-License-Identifier: BSD-3-Clause
// Wheel angle over a run, from its signal or the integral of V/R_R (thesis (62)), with a point wherever an edge of the
// travelling contact reaches a column or the next sector.
#pragma once

#include <cstddef>
#include <optional>

#include "solver/problem.hpp"

namespace tiretherm::solver {

/// The wheel's angle over a run, with a point, where a step must end, wherever the edge of a travelling contact comes to a
/// column or passes from one sector of a ring to the next: what happens between two points is smooth. The angle is that of
/// the input signals where they give one, and otherwise the integral of V / R_R (thesis (62)) from 0 at the start.
/// @param most points that are worth having  @returns nothing when there would be more
[[nodiscard]] std::optional<Series> wheel_angle(const Problem& problem, std::size_t most);

/// Whether any effect that is on goes round the tire.
[[nodiscard]] bool has_travelling_effect(const Problem& problem);

}  // namespace tiretherm::solver
