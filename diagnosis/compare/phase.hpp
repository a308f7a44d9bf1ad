// SPDX-License-Identifier: BSD-3-Clause
// Driving phase of a tire at a moment, determined from its inputs alone: standing, slipping, slowing down or free rolling; of a
// tire of a car by its forces: cornering, braking, driving or straight.
#pragma once

#include <array>
#include <cstdint>

#include "input/measurements/experiment.hpp"

namespace tiretherm::diagnosis {

/// What a tire is doing, determined from its inputs alone; the first that holds.
enum class Phase : std::uint8_t {
    standing,      ///< slower than 0.1 m/s: nothing is made, soak
    slipping,      ///< a slip angle of 0.3 degrees or more, or a slip ratio of 0.5 % or more
    slowing,       ///< speed falls faster than 0.01 g, which is what rolling resistance alone does: coasting, braking
    free_rolling,  ///< anything else: rolling straight at a steady or rising speed
    cornering,     ///< of a car: the forces are 15 % of the load or more, and the lateral one is the largest
    braking,       ///< the same, and the longitudinal one is, against the motion
    driving,       ///< the same, along the motion
    straight       ///< of a car: smaller forces
};
inline constexpr std::array phases{Phase::standing,  Phase::slipping, Phase::slowing, Phase::free_rolling,
                                   Phase::cornering, Phase::braking,  Phase::driving, Phase::straight};

/// Whether a run is that of a tire of a car whose load and lateral force are known.
[[nodiscard]] bool has_forces(const input::MeasuredRun& run);
/// @param time s, within the run  @param now the inputs there  @param of_car by the forces of the tire: on a track its slip is never below that of `slipping`
[[nodiscard]] Phase phase_at(const solver::Problem& problem, double time, const physics::Inputs& now, bool of_car);

}  // namespace tiretherm::diagnosis
