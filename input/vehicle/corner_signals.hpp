// SPDX-License-Identifier: BSD-3-Clause
// The inputs of all four tires of a car against time, from its log.
#pragma once

#include "input/vehicle/vehicle_motion.hpp"
#include "physics/vehicle/corner_inputs.hpp"

namespace tiretherm::input {

/// What has been measured at the wheels, as histories; without points: not measured.
struct MeasuredWheelHistories {
    std::array<solver::SignalHistory, physics::n_corners> vertical_load{};  ///< N
    solver::SignalHistory camber{};                                         ///< rad, of the vehicle
};

/// What a tire did over a log, and for which share of the time it did what the model cannot follow.
struct CornerHistory {
    std::vector<physics::CornerInputs> inputs;  ///< [n] at MotionHistory::time
    double lifted = 0.0;                        ///< share of the time in which the wheel is in the air
    double exceeds = 0.0;                       ///< share of the time in which the tire cannot give the forces
};

struct CornerSignals {
    std::array<CornerHistory, physics::n_corners> corners{};
    double rolls_over = 0.0;  ///< share of the time
};

/// All four tires in one call. @param motion of one log
[[nodiscard]] CornerSignals corner_signals(const physics::Vehicle& vehicle, const MotionHistory& motion,
                                           const MeasuredWheelHistories& measured = {});

}  // namespace tiretherm::input
