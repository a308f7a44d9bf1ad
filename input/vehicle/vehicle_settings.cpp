// SPDX-License-Identifier: BSD-3-Clause
// Reads [vehicle]: masses and lengths, then how drive, brakes and roll stiffness are shared, then signs and smoothing.

#include "input/vehicle/vehicle_settings.hpp"

#include <array>

#include <fmt/format.h>

#include "input/text/quantity_specs.hpp"

namespace tiretherm::input {

namespace {

/// A number that must be there, with an example of a car's size where it is not.
void require(TomlTable& table, VehicleNumber number, std::string_view example, VehicleNumbers& into) {
    const std::string_view key = spec_of(number).key;
    if (table.has(key)) {
        take(table, number, into, Need::required);
    } else {
        static_cast<void>(table.value(key, Need::required, fmt::format("{} = {}", key, example)));
    }
}

/// The centre of gravity by the share of the front axle or by the distance to it.
void read_centre_of_gravity(TomlTable& table, VehicleNumbers& numbers) {
    using enum VehicleNumber;
    take(table, centre_of_gravity_behind_front_axle, numbers);
    const bool by_distance = table.has("centre_of_gravity_behind_front_axle");
    if (by_distance) {
        take(table, front_weight_share, numbers);
    } else {
        require(table, front_weight_share, "0.48", numbers);
    }
    if (by_distance && table.has("front_weight_share")) {
        table.add_error("front_weight_share", "the centre of gravity is given twice, by a share and by a distance",
                        "keep one of them");
        return;
    }
    const double of_front = numbers[front_weight_share];
    if (of_front <= 0.0 || of_front >= 1.0) {
        table.add_error(
            "front_weight_share",
            fmt::format("front_weight_share is {:.6g}: the centre of gravity is not between the axles", of_front),
            "write the static load of the front axle over the weight, such as 0.48");
        return;
    }
    const double behind = numbers[centre_of_gravity_behind_front_axle];
    if (behind >= numbers[wheelbase]) {
        table.add_error("centre_of_gravity_behind_front_axle",
                        fmt::format("the centre of gravity is {:.6g} m behind the front axle and the wheelbase {:.6g} "
                                    "m: it is not between the axles",
                                    behind, numbers[wheelbase]),
                        "write the distance along the car, less than the wheelbase");
    }
}

void read_lengths(TomlTable& table, VehicleNumbers& numbers) {
    using enum VehicleNumber;
    require(table, mass, "\"1350 kg\"", numbers);
    require(table, wheelbase, "\"2.7 m\"", numbers);
    require(table, front_track, "\"1.55 m\"", numbers);
    take(table, rear_track, numbers);
    require(table, centre_of_gravity_height, "\"0.5 m\"", numbers);
    read_centre_of_gravity(table, numbers);
    take(table, yaw_inertia, numbers);
    take(table, front_roll_centre_height, numbers);
    take(table, rear_roll_centre_height, numbers);
    require(table, front_roll_stiffness_share, "0.55", numbers);
    take(table, front_toe_in, numbers);
    take(table, rear_toe_in, numbers);
}

void read_aerodynamics(TomlTable& table, VehicleNumbers& numbers) {
    using enum VehicleNumber;
    take(table, drag_area, numbers);
    take(table, air_density, numbers);
    take(table, downforce_area, numbers);
    take(table, front_downforce_share, numbers, table.has("downforce_area") ? Need::required : Need::optional);
    if (!std::isnan(numbers[front_downforce_share]) && !table.has("downforce_area")) {
        table.add_error("front_downforce_share", "front_downforce_share is given without downforce_area",
                        "add downforce_area = \"1.2 m2\", which is -C_L A, or remove the share");
    }
}

void read_shares(TomlTable& table, VehicleNumbers& numbers, VehicleKind& kind) {
    using enum VehicleNumber;
    const std::optional<std::string_view> word = table.word("driven_axle");
    const bool all = word == "all";
    take(table, front_drive_share, numbers, all ? Need::required : Need::optional);
    if (!std::isnan(numbers[front_drive_share]) && word && !all) {
        table.add_error("front_drive_share",
                        fmt::format("front_drive_share is given, but only the {} axle is driven", *word),
                        "write driven_axle = \"all\", or remove the share");
    }
    kind.driven = all ? DrivenAxle::all : word == "front" ? DrivenAxle::front : DrivenAxle::rear;
    require(table, front_brake_share, "0.65", numbers);
}

void read_signs(TomlTable& table, VehicleSettings& settings) {
    const auto read = [&](std::string_view key, TurnSign& sign) {
        if (const std::optional<std::size_t> word = table.choice(key)) {
            sign = static_cast<TurnSign>(*word);
        }
    };
    read("lateral_acceleration_sign", settings.lateral_acceleration);
    read("yaw_rate_sign", settings.yaw_rate);
    read("steering_sign", settings.steering);
    read("bank_sign", settings.bank_sign);
}

}  // namespace

std::optional<VehicleSettings> read_vehicle_settings(TomlTable& root, const std::optional<physics::MagicFormula>& law) {
    TomlTable table = root.subtable("vehicle");
    if (!table.exists()) {
        return std::nullopt;
    }
    const std::size_t before = table.errors().count();
    VehicleSettings settings{.place = table.place()};
    const std::optional<std::size_t> corner = table.choice("corner", Need::required);
    settings.corner = static_cast<physics::Corner>(corner.value_or(0));
    read_lengths(table, settings.numbers);
    read_aerodynamics(table, settings.numbers);
    read_shares(table, settings.numbers, settings.kind);
    read_vehicle_tires(table, law, settings);
    take(table, VehicleNumber::steering_ratio, settings.numbers);
    take(table, VehicleNumber::brake_heat_capacity, settings.numbers);
    take(table, VehicleNumber::brake_cooling, settings.numbers);
    settings.smoothing = table.quantity("smoothing").value_or(settings.smoothing);
    settings.bank = table.quantity("bank").value_or(0.0);
    settings.slope = table.quantity("slope").value_or(0.0);
    settings.has_gravity = table.flag("vertical_acceleration_has_gravity");
    read_signs(table, settings);
    return table.errors().count() == before ? std::optional(settings) : std::nullopt;
}

}  // namespace tiretherm::input
