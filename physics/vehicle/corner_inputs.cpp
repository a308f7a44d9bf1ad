// SPDX-License-Identifier: BSD-3-Clause
// Shares an axle's lateral force at one slip angle, then finds each wheel's slip ratio.

#include "physics/vehicle/corner_inputs.hpp"

#include <algorithm>
#include <cmath>

#include "physics/vehicle/slip_curve.hpp"

namespace tiretherm::physics {

namespace {

constexpr double least_left = 0.1;  ///< of a force, beside the other one at its peak

/// What the ellipse leaves of a force in pure slip. @param used share of the other direction's peak
double left_by(double used) { return std::max(least_left, std::sqrt(std::max(0.0, 1.0 - used * used))); }

/// The share of what the tire can give that a force needs; 0 where its law has no force in this direction.
double used_of(const SlipCurve& curve, double force) {
    const double most = curve.most(force);
    return most > 0.0 ? std::abs(force) / most : 0.0;
}

/// One wheel while its axle's force is shared.
struct Wheel {
    SlipCurve along;
    SlipCurve across;
    double left = 1.0;  ///< what the longitudinal force leaves of the lateral one
};

/// The share of lateral force that each wheel of an axle gives at one slip angle, and that angle.
void share_lateral(double axle_force, double toe, std::array<CornerInputs*, 2> corners, std::array<Wheel, 2>& wheels) {
    // In the axes of the car. The wheel on the left is in a mirror; toe-in turns both towards the middle.
    const auto given = [&](std::size_t i, double angle) {
        return i == 0 ? -wheels[0].left * wheels[0].across.force(toe - angle)
                      : wheels[1].left * wheels[1].across.force(toe + angle);
    };
    const auto force = [&](double angle) { return given(0, angle) + given(1, angle); };
    const double low = std::min(wheels[1].across.first() - toe, toe - wheels[0].across.last());
    const double high = std::max(wheels[1].across.last() - toe, toe - wheels[0].across.first());
    const double load = corners[0]->vertical_load + corners[1]->vertical_load;
    const double angle = slip_where(force, axle_force, low, high, 1e-12 * load);
    const double missing = axle_force - force(angle);
    const bool exceeds = std::abs(missing) > 1e-6 * load;
    for (std::size_t i = 0; i < 2; ++i) {
        CornerInputs& corner = *corners[i];
        const double share = load > 0.0 ? corner.vertical_load / load : 0.5;
        const double to_left = given(i, angle) + share * missing;
        const double mirrored = i == 0 ? -1.0 : 1.0;
        corner.lateral_force = mirrored * to_left;
        corner.slip_angle = corner.vertical_load > 0.0 ? wheels[i].across.as_written(toe + mirrored * angle) : 0.0;
        corner.exceeds = corner.exceeds || (exceeds && corner.vertical_load > 0.0);
    }
}

}  // namespace

VehicleMoment vehicle_moment(const Vehicle& vehicle, const VehicleMotion& motion, const MeasuredWheels& measured,
                             std::optional<std::size_t> only_axle) {
    const VehicleForces forces = vehicle_forces(vehicle, motion);
    VehicleMoment moment{.rolls_over = forces.rolls_over};
    for (std::size_t axle = only_axle.value_or(0); axle <= only_axle.value_or(1); ++axle) {
        const Axle& its = vehicle.axles[axle];
        const double static_load = 0.5 * vehicle.static_axle_load(axle);
        const std::array<CornerInputs*, 2> corners{&moment.corners[2 * axle], &moment.corners[2 * axle + 1]};
        const auto wheel = [&](std::size_t i) {
            const std::size_t corner = 2 * axle + i;
            CornerInputs& in = *corners[i];
            in.speed = motion.speed + (i == 0 ? -0.5 : 0.5) * motion.yaw_rate * its.track;
            in.vertical_load = std::max(0.0, measured.vertical_load[corner].value_or(forces.vertical[corner]));
            in.lifted = forces.lifted[corner];
            in.longitudinal_force = forces.longitudinal[corner];
            Wheel made{.along = SlipCurve::longitudinal(its.tire, in.vertical_load, static_load, measured.camber),
                       .across = SlipCurve::lateral(its.tire, in.vertical_load, static_load, measured.camber)};
            made.left = left_by(used_of(made.along, in.longitudinal_force));
            return made;
        };
        std::array<Wheel, 2> wheels{wheel(0), wheel(1)};
        share_lateral(forces.lateral_of_axle[axle], its.toe_in, corners, wheels);
        for (std::size_t i = 0; i < 2; ++i) {
            CornerInputs& in = *corners[i];
            const double left = left_by(used_of(wheels[i].across, in.lateral_force));
            in.slip_ratio = wheels[i].along.slip(in.longitudinal_force / left);
            in.exceeds = in.exceeds || used_of(wheels[i].along, in.longitudinal_force) > 1.0 + 1e-9;
        }
    }
    return moment;
}

}  // namespace tiretherm::physics
