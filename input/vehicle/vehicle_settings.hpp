// SPDX-License-Identifier: BSD-3-Clause
// The table [vehicle]: a car, which wheel the case's tire is, and how the signals of its log are to be taken.
#pragma once

#include <optional>

#include "input/model/problem_builder.hpp"
#include "physics/vehicle/brake.hpp"
#include "physics/vehicle/vehicle.hpp"

/// From the log of a car to the inputs of each of its tires.
namespace tiretherm::input {

/// In which turn a signal of the log is positive, or how that is found out.
enum class TurnSign : std::uint8_t { left, right, automatic };

struct VehicleSettings {
    physics::Vehicle vehicle{};
    physics::Corner corner = physics::Corner::front_left;
    physics::Brake brake{};       ///< of each wheel
    double steering_ratio = 0.0;  ///< steering wheel over road wheels; 0: not given
    double smoothing = 0.2;       ///< s
    TurnSign lateral_acceleration = TurnSign::automatic;
    TurnSign yaw_rate = TurnSign::left;
    TurnSign steering = TurnSign::left;
    bool has_slip_ratio = true;  ///< the tires have a longitudinal law
    SourceLocation place{};
};

/// Reads [vehicle]. @returns nothing after an error, all of which are reported, or without the table
[[nodiscard]] std::optional<VehicleSettings> read_vehicle_settings(TomlTable& root, const ProblemBuilder& builder);

}  // namespace tiretherm::input
