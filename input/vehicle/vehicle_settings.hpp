// SPDX-License-Identifier: BSD-3-Clause
// The table [vehicle]: a car, which wheel the case's tire is, and how the signals of its log are to be taken.
#pragma once

#include <algorithm>
#include <optional>

#include "input/toml/toml_table.hpp"
#include "input/vehicle/vehicle_numbers.hpp"

/// From the log of a car to the inputs of each of its tires.
namespace tiretherm::input {

/// In which turn a signal of the log is positive, or how that is found out.
enum class TurnSign : std::uint8_t { left, right, automatic };

struct VehicleSettings {
    VehicleNumbers numbers{};
    VehicleKind kind{};
    physics::Corner corner = physics::Corner::front_left;
    double smoothing = 0.2;  ///< s
    TurnSign lateral_acceleration = TurnSign::automatic;
    TurnSign yaw_rate = TurnSign::automatic;
    TurnSign steering = TurnSign::automatic;
    TurnSign bank_sign = TurnSign::automatic;
    double bank = 0.0;                  ///< rad, where the log has none; positive: falls to the left
    double slope = 0.0;                 ///< rad, where the log has none
    std::optional<bool> has_gravity{};  ///< of the log's vertical acceleration; empty: as it says itself
    SourceLocation place{};

    /// Whether the tires of all axles have a longitudinal law.
    [[nodiscard]] bool has_slip_ratio() const {
        return std::ranges::all_of(kind.laws, [](const std::optional<physics::MagicFormula>& law) {
            return !law || (law->pCx1 != 0.0 && law->pDx1 != 0.0);
        });
    }
};

/// Reads [vehicle]. @param law of [tire], which is that of all wheels where [vehicle] names none
/// @returns nothing after an error, all of which are reported, or without the table
[[nodiscard]] std::optional<VehicleSettings> read_vehicle_settings(TomlTable& root,
                                                                   const std::optional<physics::MagicFormula>& law);

/// Reads a number of the car.
void take(TomlTable& table, VehicleNumber number, VehicleNumbers& into, Need need = Need::optional);

/// Reads property_file, or the four stiffnesses and the friction; with neither it is the .tir of [tire].
void read_vehicle_tires(TomlTable& table, const std::optional<physics::MagicFormula>& of_tire,
                        VehicleSettings& settings);

}  // namespace tiretherm::input
