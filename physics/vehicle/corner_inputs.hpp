// SPDX-License-Identifier: BSD-3-Clause
// What each of a car's four tires does at one moment: load, forces, slips and speed, from the motion of the car.
#pragma once

#include "physics/vehicle/wheel_loads.hpp"

namespace tiretherm::physics {

/// What a tire does, by the conventions of physics/conventions.cpp: a tire on the left is the one on the right in a
/// mirror, so that slip angle and lateral force of both are positive where the road pushes the tire towards the middle
/// of the car.
struct CornerInputs {
    double speed = 0.0;               ///< m/s, of the road under the tire: V -/+ r t/2
    double vertical_load = 0.0;       ///< N
    double slip_angle = 0.0;          ///< rad
    double slip_ratio = 0.0;          ///< 1
    double lateral_force = 0.0;       ///< N
    double longitudinal_force = 0.0;  ///< N
    bool lifted = false;
    bool exceeds = false;  ///< the forces are more than the tire can give: slips are those of its peak
};

struct VehicleMoment {
    std::array<CornerInputs, n_corners> corners{};
    bool rolls_over = false;
};

/// What has been measured at the wheels goes before what the model says.
struct MeasuredWheels {
    std::array<std::optional<double>, n_corners> vertical_load{};  ///< N
    double camber = 0.0;                                           ///< rad, of the vehicle, all wheels alike
};

/// Wheel by wheel. The wheels of an axle have one slip angle, apart from their toe, and share the axle's lateral force by
/// what each then gives. Combined slip is a friction ellipse: a tire that gives Fx of at most Dx gives
/// sqrt(1 - (Fx/Dx)^2) of its lateral force in pure slip, and the reverse (Milliken & Milliken 1995, ch. 2). Forces
/// always add up to those of the axle, also where the tires cannot give them.
/// @param axle the only one whose wheels are wanted: 0 in front, 1 at the rear
[[nodiscard]] VehicleMoment vehicle_moment(const Vehicle& vehicle, const VehicleMotion& motion,
                                           const MeasuredWheels& measured = {}, std::optional<std::size_t> axle = {});

}  // namespace tiretherm::physics
