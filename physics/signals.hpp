// SPDX-License-Identifier: BSD-3-Clause
// Inputs of a tire at one moment (speed, load, slip, forces, temperatures and others) and their description by name and
// unit.
#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace tiretherm::physics {

/// The inputs of a tire at one moment, in SI and kelvin, radians.
struct Inputs {
    double time = 0.0;                ///< s since the run's start
    double speed = 0.0;               ///< m/s, of the road under the tire
    double vertical_load = 0.0;       ///< N
    double slip_angle = 0.0;          ///< rad
    double slip_ratio = 0.0;          ///< 1, (Omega R_R - V) / V
    double slip_speed = 0.0;          ///< m/s, Omega R_R - V, of a tire whose slip ratio has no bound: V near 0
    double lateral_force = 0.0;       ///< N
    double longitudinal_force = 0.0;  ///< N
    double camber = 0.0;              ///< rad, negative: top leaning inboard
    double inflation_pressure = 0.0;  ///< Pa above the atmosphere
    double air_temperature = 0.0;     ///< K
    double road_temperature = 0.0;    ///< K
    double wet = 0.0;                 ///< 0 or 1
    double laser_power = 0.0;         ///< W
    double brake_temperature = 0.0;   ///< K, of the disc
    double wheel_angle = 0.0;         ///< rad turned since the run's start

    friend bool operator==(const Inputs&, const Inputs&) = default;
};

/// Name, unit and plausible range of each member of Inputs.
struct Signal {
    std::string_view name;
    std::string_view unit;  ///< UDUNITS
    double Inputs::*member;
    double low;
    double high;
    std::string_view meaning;
};

/// Speed at which the contact slides along the tire's heading, Omega R_R - V, by the slip ratio or the slip speed, of which
/// one is given. @returns m/s
[[nodiscard]] inline double longitudinal_slip_speed(const Inputs& inputs) {
    return inputs.speed * inputs.slip_ratio + inputs.slip_speed;
}

/// Speed of the tread around the wheel's axis, Omega R_R, by which the tire is deformed: a wheel that spins on the spot rolls,
/// a locked one does not. @returns m/s
[[nodiscard]] inline double rolling_speed(const Inputs& inputs) {
    return inputs.speed + longitudinal_slip_speed(inputs);
}

[[nodiscard]] std::span<const Signal> signals();
/// On the straight line from one moment (share 0) to another (share 1).
[[nodiscard]] Inputs between(const Inputs& from, const Inputs& to, double share);
[[nodiscard]] const Signal* find_signal(std::string_view name);  ///< null when absent

}  // namespace tiretherm::physics
