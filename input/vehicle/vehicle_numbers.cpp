// SPDX-License-Identifier: BSD-3-Clause
// Keys of the numbers of [vehicle]; from them the masses, lengths, shares and tires of the car.

#include "input/vehicle/vehicle_numbers.hpp"

#include <algorithm>

namespace tiretherm::input {

namespace {

constexpr std::array<VehicleNumberSpec, n_vehicle_numbers> number_specs{{
#define VEHICLE_NUMBER(key, absent) {#key, absent},
#include "input/vehicle/vehicle_numbers.list"
}};
constexpr double nearest_axle = 0.01;  ///< of the wheelbase, between an axle and the centre of gravity

void place_axles(const VehicleNumbers& numbers, physics::Vehicle& vehicle) {
    using enum VehicleNumber;
    const double length = numbers.or_else(wheelbase, 2.0);
    const double behind =
        numbers.or_else(centre_of_gravity_behind_front_axle, (1.0 - numbers.or_else(front_weight_share, 0.5)) * length);
    physics::Axle& front = vehicle.axles[0];
    physics::Axle& rear = vehicle.axles[1];
    front.distance = std::clamp(behind, nearest_axle * length, (1.0 - nearest_axle) * length);
    rear.distance = length - front.distance;
    front.track = numbers.or_else(front_track, 1.5);
    rear.track = numbers.or_else(rear_track, front.track);
    front.roll_centre_height = numbers[front_roll_centre_height];
    rear.roll_centre_height = numbers[rear_roll_centre_height];
    front.toe_in = numbers[front_toe_in];
    rear.toe_in = numbers[rear_toe_in];
}

void share_forces(const VehicleNumbers& numbers, const VehicleKind& kind, physics::Vehicle& vehicle) {
    using enum VehicleNumber;
    physics::Axle& front = vehicle.axles[0];
    physics::Axle& rear = vehicle.axles[1];
    const auto share_out = [&](double physics::Axle::*member, double of_front, double whole = 1.0) {
        front.*member = of_front * whole;
        rear.*member = (1.0 - of_front) * whole;
    };
    share_out(&physics::Axle::roll_stiffness_share, numbers.or_else(front_roll_stiffness_share, 0.5));
    share_out(&physics::Axle::downforce_area, numbers.or_else(front_downforce_share, 0.5), numbers[downforce_area]);
    share_out(&physics::Axle::brake_share, numbers.or_else(front_brake_share, 0.5));
    share_out(&physics::Axle::drive_share, kind.driven == DrivenAxle::front  ? 1.0
                                           : kind.driven == DrivenAxle::rear ? 0.0
                                                                             : numbers.or_else(front_drive_share, 0.5));
}

void give_tires(const VehicleNumbers& numbers, const VehicleKind& kind, physics::Vehicle& vehicle) {
    using enum VehicleNumber;
    physics::Axle& front = vehicle.axles[0];
    physics::Axle& rear = vehicle.axles[1];
    if (kind.laws[0]) {
        for (std::size_t axle = 0; axle < kind.laws.size(); ++axle) {
            physics::MagicFormula scaled = kind.laws[axle].value();
            scaled.lambda.mux *= numbers[friction_scale];
            scaled.lambda.muy *= numbers[friction_scale];
            scaled.lambda.Kx *= numbers[stiffness_scale];
            scaled.lambda.Ky *= numbers[stiffness_scale];
            vehicle.axles[axle].tire.magic_formula = scaled;
        }
        return;
    }
    front.tire.cornering_stiffness = numbers.or_else(front_cornering_stiffness, 1.0);
    rear.tire.cornering_stiffness = numbers.or_else(rear_cornering_stiffness, 1.0);
    front.tire.slip_stiffness = numbers.or_else(front_slip_stiffness, 1.0);
    rear.tire.slip_stiffness = numbers.or_else(rear_slip_stiffness, 1.0);
    front.tire.friction = numbers.or_else(VehicleNumber::friction, front.tire.friction);
    rear.tire.friction = front.tire.friction;
}

}  // namespace

std::span<const VehicleNumberSpec> vehicle_numbers() { return number_specs; }

const VehicleNumberSpec& spec_of(VehicleNumber number) { return number_specs[static_cast<std::size_t>(number)]; }

VehicleNumbers::VehicleNumbers() { std::ranges::transform(number_specs, all_.begin(), &VehicleNumberSpec::absent); }

VehicleNumbers::VehicleNumbers(std::span<const double> all) { std::ranges::copy(all, all_.begin()); }

physics::Vehicle vehicle_of(const VehicleNumbers& numbers, const VehicleKind& kind) {
    using enum VehicleNumber;
    physics::Vehicle vehicle{.mass = numbers.or_else(VehicleNumber::mass, 1000.0),
                             .cg_height = numbers.or_else(centre_of_gravity_height, 0.5),
                             .drag_area = numbers[VehicleNumber::drag_area],
                             .air_density = numbers[VehicleNumber::air_density]};
    place_axles(numbers, vehicle);
    vehicle.yaw_inertia =
        numbers.or_else(yaw_inertia, vehicle.mass * vehicle.axles[0].distance * vehicle.axles[1].distance);
    share_forces(numbers, kind, vehicle);
    give_tires(numbers, kind, vehicle);
    return vehicle;
}

physics::Brake brake_of(const VehicleNumbers& numbers) {
    return {.heat_capacity = numbers[VehicleNumber::brake_heat_capacity],
            .cooling = numbers[VehicleNumber::brake_cooling]};
}

}  // namespace tiretherm::input
