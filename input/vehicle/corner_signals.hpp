// SPDX-License-Identifier: BSD-3-Clause
// The inputs of a tire of a car against time, from the car's log.
#pragma once

#include "input/vehicle/vehicle_motion.hpp"
#include "physics/vehicle/corner_inputs.hpp"

namespace tiretherm::input {

/// What has been measured at the wheels, as histories; without points: not measured.
struct MeasuredWheelHistories {
    solver::SignalHistory vertical_load{};  ///< N, of this tire
    solver::SignalHistory camber{};         ///< rad, of the vehicle
};

/// What a tire did over a log, and for which share of the time it did what the model cannot follow.
struct CornerHistory {
    std::vector<physics::CornerInputs> inputs;  ///< [n] at MotionHistory::time
    double lifted = 0.0;                        ///< share of the time in which the wheel is in the air
    double exceeds = 0.0;                       ///< share of the time in which the tire cannot give the forces
    double rolls_over = 0.0;                    ///< share of the time in which the car does
};

/// Only the tire's axle is computed. @param motion of one log
[[nodiscard]] CornerHistory corner_history(const physics::Vehicle& vehicle, physics::Corner corner,
                                           const MotionHistory& motion, const MeasuredWheelHistories& measured = {});

}  // namespace tiretherm::input
