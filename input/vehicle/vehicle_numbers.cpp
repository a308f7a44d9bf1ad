// SPDX-License-Identifier: BSD-3-Clause
// Keys, units and ranges of the numbers of [vehicle]; from them the masses, lengths, shares and tires of the car.

#include "input/vehicle/vehicle_numbers.hpp"

#include <algorithm>

namespace tiretherm::input {

namespace {

constexpr QuantitySpec mass{
    .unit = "kg", .low = 0.0, .high = 1e5, .above = true, .usual_low = 150.0, .usual_high = 4e4};
constexpr QuantitySpec wheelbase{
    .unit = "m", .low = 0.0, .high = 20.0, .above = true, .usual_low = 1.2, .usual_high = 7.0};
constexpr QuantitySpec track{.unit = "m", .low = 0.0, .high = 5.0, .above = true, .usual_low = 0.9, .usual_high = 2.6};
constexpr QuantitySpec cg_height{
    .unit = "m", .low = 0.0, .high = 5.0, .above = true, .usual_low = 0.2, .usual_high = 2.0};
constexpr QuantitySpec cg_distance{.unit = "m", .low = 0.0, .high = 20.0, .above = true};
constexpr QuantitySpec roll_centre{.unit = "m", .low = -1.0, .high = 2.0, .usual_low = -0.2, .usual_high = 0.8};
constexpr QuantitySpec inertia{
    .unit = "kg m2", .low = 0.0, .high = 1e6, .above = true, .usual_low = 50.0, .usual_high = 1e5};
constexpr QuantitySpec share{.unit = "1", .low = 0.0, .high = 1.0};
constexpr QuantitySpec drag_area{.unit = "m2", .low = 0.0, .high = 20.0, .usual_low = 0.0, .usual_high = 8.0};
constexpr QuantitySpec downforce_area{.unit = "m2", .low = -20.0, .high = 20.0, .usual_low = -2.0, .usual_high = 8.0};
constexpr QuantitySpec downforce_share{.unit = "1", .low = -2.0, .high = 3.0, .usual_low = 0.0, .usual_high = 1.0};
constexpr QuantitySpec air_density{
    .unit = "kg/m3", .low = 0.0, .high = 3.0, .above = true, .usual_low = 0.8, .usual_high = 1.5};
constexpr QuantitySpec steering_ratio{
    .unit = "1", .low = 0.0, .high = 100.0, .above = true, .usual_low = 1.0, .usual_high = 30.0};
constexpr QuantitySpec toe{.unit = "radian", .low = -0.1, .high = 0.1, .usual_low = -0.01, .usual_high = 0.01};
constexpr QuantitySpec cornering{
    .unit = "N/rad", .low = 0.0, .high = 1e7, .above = true, .usual_low = 5e3, .usual_high = 1e6};
constexpr QuantitySpec slip{.unit = "N", .low = 0.0, .high = 1e7, .above = true, .usual_low = 5e3, .usual_high = 1e6};
constexpr QuantitySpec friction{
    .unit = "1", .low = 0.0, .high = 10.0, .above = true, .usual_low = 0.2, .usual_high = 2.5};
constexpr QuantitySpec scale{.unit = "1", .low = 0.0, .high = 10.0, .above = true, .usual_low = 0.5, .usual_high = 1.5};
constexpr QuantitySpec brake_capacity{
    .unit = "J/K", .low = 0.0, .high = 1e6, .above = true, .usual_low = 500.0, .usual_high = 3e4};
constexpr QuantitySpec brake_cooling{.unit = "W/K", .low = 0.0, .high = 1e4, .usual_low = 1.0, .usual_high = 300.0};

constexpr std::array<VehicleNumberSpec, n_vehicle_numbers> number_specs{{
    {"mass", mass},
    {"wheelbase", wheelbase},
    {"front_track", track},
    {"rear_track", track},
    {"centre_of_gravity_height", cg_height},
    {"centre_of_gravity_behind_front_axle", cg_distance},
    {"front_weight_share", share},
    {"yaw_inertia", inertia},
    {"front_roll_centre_height", roll_centre, 0.0},
    {"rear_roll_centre_height", roll_centre, 0.0},
    {"front_roll_stiffness_share", share},
    {"front_toe_in", toe, 0.0},
    {"rear_toe_in", toe, 0.0},
    {"drag_area", drag_area, 0.0},
    {"air_density", air_density, physics::Vehicle{}.air_density},
    {"downforce_area", downforce_area, 0.0},
    {"front_downforce_share", downforce_share},
    {"front_drive_share", share},
    {"front_brake_share", share},
    {"front_cornering_stiffness", cornering},
    {"rear_cornering_stiffness", cornering},
    {"front_slip_stiffness", slip},
    {"rear_slip_stiffness", slip},
    {"friction", friction},
    {"friction_scale", scale, 1.0},
    {"stiffness_scale", scale, 1.0},
    {"steering_ratio", steering_ratio},
    {"brake_heat_capacity", brake_capacity, physics::Brake{}.heat_capacity},
    {"brake_cooling", brake_cooling, physics::Brake{}.cooling},
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
