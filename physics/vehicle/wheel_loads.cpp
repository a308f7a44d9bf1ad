// SPDX-License-Identifier: BSD-3-Clause
// Equilibrium of heave, pitch, roll and yaw; loads are cut at 0 and the rest is carried by the other wheels.

#include "physics/vehicle/wheel_loads.hpp"

#include <algorithm>
#include <cmath>

namespace tiretherm::physics {

namespace {

constexpr std::size_t front = 0;
constexpr std::size_t rear = 1;

std::array<double, 2> axle_loads(const Vehicle& vehicle, const VehicleMotion& motion, double q, VehicleForces& out) {
    const double pitch = vehicle.mass * motion.longitudinal_acceleration * vehicle.cg_height / vehicle.wheelbase();
    const double heavier = motion.vertical_acceleration / standard_gravity;
    std::array<double, 2> load{
        heavier * vehicle.static_axle_load(front) - pitch + q * vehicle.axles[front].downforce_area,
        heavier * vehicle.static_axle_load(rear) + pitch + q * vehicle.axles[rear].downforce_area};
    const double total = std::max(0.0, load[front] + load[rear]);
    for (std::size_t i = 0; i < 2; ++i) {
        if (load[i] < 0.0) {
            load[i] = 0.0;
            load[1 - i] = total;
            out.lifted[2 * i] = out.lifted[2 * i + 1] = true;
        }
    }
    return load;
}

/// Half the difference of right and left. N
std::array<double, 2> lateral_transfer(const Vehicle& vehicle, const VehicleMotion& motion,
                                       const std::array<double, 2>& load, VehicleForces& out) {
    double roll = vehicle.mass * motion.lateral_acceleration * vehicle.cg_height;
    for (std::size_t i = 0; i < 2; ++i) {
        roll -= out.lateral_of_axle[i] * vehicle.axles[i].roll_centre_height;
    }
    std::array<double, 2> transfer{};
    for (std::size_t i = 0; i < 2; ++i) {
        const Axle& axle = vehicle.axles[i];
        transfer[i] =
            (out.lateral_of_axle[i] * axle.roll_centre_height + axle.roll_stiffness_share * roll) / axle.track;
    }
    // What an axle cannot carry with one wheel in the air is left to the other one; then that one may lift as well.
    for (const std::size_t i : {front, rear, front}) {
        const double excess = std::abs(transfer[i]) - 0.5 * load[i];
        if (excess > 0.0) {
            const double moment = std::copysign(excess, transfer[i]) * vehicle.axles[i].track;
            out.lifted[2 * i + (transfer[i] > 0.0 ? 0 : 1)] = true;
            transfer[i] = std::copysign(0.5 * load[i], transfer[i]);
            transfer[1 - i] += moment / vehicle.axles[1 - i].track;
        }
    }
    for (std::size_t i = 0; i < 2; ++i) {
        const double most = 0.5 * load[i];
        out.rolls_over = out.rolls_over || std::abs(transfer[i]) > most * (1.0 + 1e-9) + 1e-9;
        transfer[i] = std::clamp(transfer[i], -most, most);
    }
    return transfer;
}

void share_longitudinal(const Vehicle& vehicle, const VehicleMotion& motion, double q, VehicleForces& out) {
    const double force = vehicle.mass * motion.longitudinal_acceleration + q * vehicle.drag_area;
    const bool drives = force >= 0.0 || motion.brakes_released;
    for (std::size_t i = 0; i < 2; ++i) {
        const double share = drives ? vehicle.axles[i].drive_share : vehicle.axles[i].brake_share;
        const double left = out.vertical[2 * i];
        const double right = out.vertical[2 * i + 1];
        // Alike on both sides, but a wheel in the air gives nothing; an axle in the air leaves all to the other.
        const std::size_t of = left + right > 0.0 ? i : 1 - i;
        const bool both = out.vertical[2 * of] > 0.0 && out.vertical[2 * of + 1] > 0.0;
        for (const std::size_t corner : {2 * of, 2 * of + 1}) {
            out.longitudinal[corner] += both ? 0.5 * share * force : out.vertical[corner] > 0.0 ? share * force : 0.0;
        }
    }
}

}  // namespace

double RoadPlane::across() const { return gravity * std::sin(bank); }

double RoadPlane::vertical_acceleration(double lateral_acceleration) const {
    return gravity / std::cos(bank) + lateral_acceleration * std::tan(bank);
}

VehicleForces vehicle_forces(const Vehicle& vehicle, const VehicleMotion& motion) {
    VehicleForces out;
    const double q = 0.5 * vehicle.air_density * motion.speed * motion.speed;
    const double lateral = vehicle.mass * motion.lateral_acceleration;
    out.lateral_of_axle[front] =
        (lateral * vehicle.axles[rear].distance + vehicle.yaw_inertia * motion.yaw_acceleration) / vehicle.wheelbase();
    out.lateral_of_axle[rear] = lateral - out.lateral_of_axle[front];
    const std::array<double, 2> load = axle_loads(vehicle, motion, q, out);
    const std::array<double, 2> transfer = lateral_transfer(vehicle, motion, load, out);
    for (std::size_t corner = 0; corner < n_corners; ++corner) {
        const std::size_t axle = axle_of(corner);
        out.vertical[corner] = 0.5 * load[axle] + (is_left(corner) ? -transfer[axle] : transfer[axle]);
    }
    share_longitudinal(vehicle, motion, q, out);
    return out;
}

}  // namespace tiretherm::physics
