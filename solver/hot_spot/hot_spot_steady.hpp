// SPDX-License-Identifier: BSD-3-Clause
// Steady hot spot and surface of each step of a test, and the surface temperature at which a hot spot would reach its
// critical temperature in a slow test.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "solver/hot_spot/hot_spot.hpp"
#include "solver/hot_spot/schedule_steps.hpp"

namespace tiretherm::solver {

/// A hot spot and the surface beside it in one state. K; NaN where nobody knows
struct SpotAndSurface {
    double hottest = std::numeric_limits<double>::quiet_NaN();
    double surface = std::numeric_limits<double>::quiet_NaN();
};

/// What each step would come to if it were held for ever: its steady state.
/// @returns [criticals][steps]; NaN for a ramp and where there is no steady state
[[nodiscard]] std::vector<std::vector<SpotAndSurface>> steady_spots(const Problem& problem,
                                                                    std::span<const Critical> criticals,
                                                                    std::span<const ScheduleStep> steps);

/// What the surface would read if the hot spot stood at its critical temperature for ever: straight between the steady
/// states of the two steps, one after the other, on either side of it. It is the threshold that slow tests would set for
/// a camera.
/// @param steady [steps], in the order of the test  @returns K; NaN where no two steps lie on either side
[[nodiscard]] double surface_threshold(std::span<const SpotAndSurface> steady, double critical);

}  // namespace tiretherm::solver
