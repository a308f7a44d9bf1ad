// SPDX-License-Identifier: BSD-3-Clause
// The inputs of a tire of a car against time, from the car's log.
#pragma once

#include <array>
#include <memory>

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

/// Both tires of an axle, which share its forces: left and right.
using AxleHistory = std::array<CornerHistory, 2>;

/// @param corner one of the axle's tires, of which `measured` is  @param motion of one log
[[nodiscard]] AxleHistory axle_history(const physics::Vehicle& vehicle, physics::Corner corner,
                                       const MotionHistory& motion, const MeasuredWheelHistories& measured);

/// What one tire of a car has found in a log, for the others.
struct CarMotion {
    solver::Digest::Value origin{};  ///< `motion_origin` of the log and the car's numbers
    std::shared_ptr<const MotionHistory> history{};
    solver::Digest::Value axle_origin{};  ///< of all that the axle follows from
    std::shared_ptr<const AxleHistory> axle{};
};

}  // namespace tiretherm::input
