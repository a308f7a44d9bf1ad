// SPDX-License-Identifier: BSD-3-Clause
// Reads [vehicle]: masses and lengths, then how drive, brakes and roll stiffness are shared, then signs and smoothing.

#include "input/vehicle/vehicle_settings.hpp"

#include <array>

#include <fmt/format.h>

#include "input/text/quantity_specs.hpp"
#include "input/vehicle/vehicle_tire.hpp"

namespace tiretherm::input {

namespace {

using physics::Axle;
using physics::Vehicle;

constexpr std::size_t front = 0;
constexpr std::size_t rear = 1;

constexpr QuantitySpec mass{
    .unit = "kg", .low = 0.0, .high = 1e5, .above = true, .usual_low = 150.0, .usual_high = 4e4};
constexpr QuantitySpec wheelbase{
    .unit = "m", .low = 0.0, .high = 20.0, .above = true, .usual_low = 1.2, .usual_high = 7.0};
constexpr QuantitySpec track{.unit = "m", .low = 0.0, .high = 5.0, .above = true, .usual_low = 0.9, .usual_high = 2.6};
constexpr QuantitySpec cg_height{
    .unit = "m", .low = 0.0, .high = 5.0, .above = true, .usual_low = 0.2, .usual_high = 2.0};
constexpr QuantitySpec roll_centre{.unit = "m", .low = -1.0, .high = 2.0, .usual_low = -0.2, .usual_high = 0.8};
constexpr QuantitySpec inertia{
    .unit = "kg m2", .low = 0.0, .high = 1e6, .above = true, .usual_low = 50.0, .usual_high = 1e5};
constexpr QuantitySpec share{.unit = "1", .low = 0.0, .high = 1.0};
constexpr QuantitySpec drag_area{.unit = "m2", .low = 0.0, .high = 20.0, .usual_low = 0.0, .usual_high = 8.0};
constexpr QuantitySpec downforce_area{.unit = "m2", .low = -20.0, .high = 20.0, .usual_low = -2.0, .usual_high = 8.0};
constexpr QuantitySpec air_density{
    .unit = "kg m-3", .low = 0.0, .high = 3.0, .above = true, .usual_low = 0.8, .usual_high = 1.5};
constexpr QuantitySpec steering_ratio{
    .unit = "1", .low = 0.0, .high = 100.0, .above = true, .usual_low = 1.0, .usual_high = 30.0};
constexpr QuantitySpec toe{.unit = "radian", .low = -0.1, .high = 0.1, .usual_low = -0.01, .usual_high = 0.01};
constexpr QuantitySpec brake_capacity{
    .unit = "J K-1", .low = 0.0, .high = 1e6, .above = true, .usual_low = 500.0, .usual_high = 3e4};
constexpr QuantitySpec brake_cooling{.unit = "W K-1", .low = 0.0, .high = 1e4, .usual_low = 1.0, .usual_high = 300.0};
constexpr QuantitySpec smoothing{.unit = "s", .low = 0.0, .high = 10.0, .usual_low = 0.0, .usual_high = 1.0};

/// A quantity that must be there, with an example of a car's size where it is not.
std::optional<double> required(TomlTable& table, std::string_view key, const QuantitySpec& spec,
                               std::string_view example) {
    if (!table.has(key)) {
        static_cast<void>(table.value(key, Need::required, fmt::format("{} = {}", key, example)));
        return std::nullopt;
    }
    return table.quantity(key, spec, Need::required);
}

/// Distances of the axles from the centre of gravity, by the share of the front axle or by the distance to it.
void read_centre_of_gravity(TomlTable& table, double wheelbase_read, Vehicle& vehicle) {
    const std::optional<double> distance =
        table.quantity("centre_of_gravity_behind_front_axle", {.unit = "m", .low = 0.0, .high = 20.0, .above = true});
    const bool by_distance = table.has("centre_of_gravity_behind_front_axle");
    const std::optional<double> of_front = by_distance ? table.quantity("front_weight_share", share)
                                                       : required(table, "front_weight_share", share, "0.48");
    if (by_distance && table.has("front_weight_share")) {
        table.add_error("front_weight_share", "the centre of gravity is given twice, by a share and by a distance",
                        "keep one of them");
        return;
    }
    if (of_front && (*of_front <= 0.0 || *of_front >= 1.0)) {
        table.add_error(
            "front_weight_share",
            fmt::format("front_weight_share is {:.6g}: the centre of gravity is not between the axles", *of_front),
            "write the static load of the front axle over the weight, such as 0.48");
        return;
    }
    if (wheelbase_read <= 0.0) {
        return;
    }
    const double behind = distance.value_or(of_front ? (1.0 - *of_front) * wheelbase_read : 0.5 * wheelbase_read);
    if (behind >= wheelbase_read) {
        table.add_error("centre_of_gravity_behind_front_axle",
                        fmt::format("the centre of gravity is {:.6g} m behind the front axle and the wheelbase {:.6g} "
                                    "m: it is not between the axles",
                                    behind, wheelbase_read),
                        "write the distance along the car, less than the wheelbase");
        return;
    }
    vehicle.axles[front].distance = behind;
    vehicle.axles[rear].distance = wheelbase_read - behind;
}

void read_lengths(TomlTable& table, Vehicle& vehicle) {
    vehicle.mass = required(table, "mass", mass, "\"1350 kg\"").value_or(1000.0);
    const std::optional<double> length = required(table, "wheelbase", wheelbase, "\"2.7 m\"");
    vehicle.axles[front].track = required(table, "front_track", track, "\"1.55 m\"").value_or(1.5);
    vehicle.axles[rear].track = table.quantity("rear_track", track).value_or(vehicle.axles[front].track);
    vehicle.cg_height = required(table, "centre_of_gravity_height", cg_height, "\"0.5 m\"").value_or(0.5);
    read_centre_of_gravity(table, length.value_or(0.0), vehicle);
    const std::optional<double> yaw = table.quantity("yaw_inertia", inertia);
    vehicle.yaw_inertia = yaw.value_or(vehicle.mass * vehicle.axles[front].distance * vehicle.axles[rear].distance);
    vehicle.axles[front].roll_centre_height = table.quantity("front_roll_centre_height", roll_centre).value_or(0.0);
    vehicle.axles[rear].roll_centre_height = table.quantity("rear_roll_centre_height", roll_centre).value_or(0.0);
    const double stiffness = required(table, "front_roll_stiffness_share", share, "0.55").value_or(0.5);
    vehicle.axles[front].roll_stiffness_share = stiffness;
    vehicle.axles[rear].roll_stiffness_share = 1.0 - stiffness;
    vehicle.axles[front].toe_in = table.quantity("front_toe_in", toe).value_or(0.0);
    vehicle.axles[rear].toe_in = table.quantity("rear_toe_in", toe).value_or(0.0);
}

void read_aerodynamics(TomlTable& table, Vehicle& vehicle) {
    vehicle.drag_area = table.quantity("drag_area", drag_area).value_or(0.0);
    vehicle.air_density = table.quantity("air_density", air_density).value_or(vehicle.air_density);
    const double area = table.quantity("downforce_area", downforce_area).value_or(0.0);
    const std::optional<double> of_front = table.quantity(
        "front_downforce_share", {.unit = "1", .low = -2.0, .high = 3.0, .usual_low = 0.0, .usual_high = 1.0},
        table.has("downforce_area") ? Need::required : Need::optional);
    if (of_front && !table.has("downforce_area")) {
        table.add_error("front_downforce_share", "front_downforce_share is given without downforce_area",
                        "add downforce_area = \"1.2 m2\", which is -C_L A, or remove the share");
    }
    vehicle.axles[front].downforce_area = of_front.value_or(0.5) * area;
    vehicle.axles[rear].downforce_area = (1.0 - of_front.value_or(0.5)) * area;
}

void read_shares(TomlTable& table, Vehicle& vehicle) {
    constexpr std::array<std::string_view, 3> driven{"front", "rear", "all"};
    const std::optional<std::size_t> word = table.choice("driven_axle", driven, Need::required);
    const bool all = word && *word == 2;
    const std::optional<double> of_front =
        table.quantity("front_drive_share", share, all ? Need::required : Need::optional);
    if (of_front && word && !all) {
        table.add_error("front_drive_share",
                        fmt::format("front_drive_share is given, but only the {} axle is driven", driven[*word]),
                        "write driven_axle = \"all\", or remove the share");
    }
    const double drive = all ? of_front.value_or(0.5) : word && *word == 0 ? 1.0 : 0.0;
    const double brake = required(table, "front_brake_share", share, "0.65").value_or(0.5);
    vehicle.axles[front].drive_share = drive;
    vehicle.axles[rear].drive_share = 1.0 - drive;
    vehicle.axles[front].brake_share = brake;
    vehicle.axles[rear].brake_share = 1.0 - brake;
}

void read_signs(TomlTable& table, VehicleSettings& settings) {
    constexpr std::array<std::string_view, 3> turns{"left", "right", "automatic"};
    constexpr std::array<std::string_view, 2> sides{"left", "right"};
    const auto read = [&](std::string_view key, std::span<const std::string_view> words, TurnSign& sign) {
        if (const std::optional<std::size_t> word = table.choice(key, words)) {
            sign = static_cast<TurnSign>(*word);
        }
    };
    read("lateral_acceleration_sign", turns, settings.lateral_acceleration);
    read("yaw_rate_sign", sides, settings.yaw_rate);
    read("steering_sign", sides, settings.steering);
}

}  // namespace

std::optional<VehicleSettings> read_vehicle_settings(TomlTable& root, const ProblemBuilder& builder) {
    TomlTable table = root.subtable("vehicle");
    if (!table.exists()) {
        return std::nullopt;
    }
    const std::size_t before = table.errors().count();
    VehicleSettings settings{.place = table.place()};
    const std::optional<std::size_t> corner = table.choice("corner", physics::corner_names, Need::required);
    settings.corner = static_cast<physics::Corner>(corner.value_or(0));
    read_lengths(table, settings.vehicle);
    read_aerodynamics(table, settings.vehicle);
    read_shares(table, settings.vehicle);
    read_vehicle_tires(table, builder, settings);
    settings.steering_ratio = table.quantity("steering_ratio", steering_ratio).value_or(0.0);
    settings.brake.heat_capacity =
        table.quantity("brake_heat_capacity", brake_capacity).value_or(settings.brake.heat_capacity);
    settings.brake.cooling = table.quantity("brake_cooling", brake_cooling).value_or(settings.brake.cooling);
    settings.smoothing = table.quantity("smoothing", smoothing).value_or(settings.smoothing);
    read_signs(table, settings);
    return table.errors().count() == before ? std::optional(settings) : std::nullopt;
}

}  // namespace tiretherm::input
