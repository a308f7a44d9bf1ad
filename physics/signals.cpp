// SPDX-License-Identifier: BSD-3-Clause
// Table of all input signals with unit, plausible range and meaning; linear interpolation between two moments.

#include "physics/signals.hpp"

#include <algorithm>
#include <array>
#include <numbers>

namespace tiretherm::physics {

namespace {

constexpr double pi = std::numbers::pi;

constexpr std::array<Signal, 15> table{{
    {"speed", "m s-1", &Inputs::speed, -150.0, 150.0, "speed of the road under the tire"},
    {"vertical_load", "N", &Inputs::vertical_load, 0.0, 2e5, "vertical load on the tire"},
    {"slip_angle", "radian", &Inputs::slip_angle, -0.45 * pi, 0.45 * pi, "slip angle; either sign convention"},
    {"slip_ratio", "1", &Inputs::slip_ratio, -1.0, 20.0, "(Omega R_R - V) / V"},
    {"slip_speed", "m s-1", &Inputs::slip_speed, -150.0, 150.0,
     "Omega R_R - V, in the place of slip_ratio where V may be near 0"},
    {"lateral_force", "N", &Inputs::lateral_force, -2e5, 2e5,
     "lateral force; either sign convention, but for the shoulder that it loads"},
    {"longitudinal_force", "N", &Inputs::longitudinal_force, -2e5, 2e5, "longitudinal force"},
    {"camber", "radian", &Inputs::camber, -0.5 * pi, 0.5 * pi, "camber, negative with the top leaning inboard"},
    {"inflation_pressure", "Pa", &Inputs::inflation_pressure, 0.0, 2e6, "inflation pressure above the atmosphere"},
    {"air_temperature", "K", &Inputs::air_temperature, 200.0, 400.0, "temperature of the air around the tire"},
    {"road_temperature", "K", &Inputs::road_temperature, 200.0, 400.0, "temperature of the road or drum"},
    {"wet", "1", &Inputs::wet, 0.0, 1.0, "1 on a wet road, 0 on a dry one"},
    {"laser_power", "W", &Inputs::laser_power, 0.0, 1e4, "power of the laser on the tread"},
    {"brake_temperature", "K", &Inputs::brake_temperature, 200.0, 1500.0, "temperature of the brake disc"},
    {"wheel_angle", "radian", &Inputs::wheel_angle, -1e8, 1e8,
     "angle that the wheel has turned since the start; without it, it follows from speed and load"},
}};

}  // namespace

std::span<const Signal> signals() { return table; }

Inputs between(const Inputs& from, const Inputs& to, double share) {
    Inputs inputs;
    inputs.time = from.time + share * (to.time - from.time);
    for (const Signal& signal : table) {
        inputs.*signal.member = from.*signal.member + share * (to.*signal.member - from.*signal.member);
    }
    return inputs;
}

const Signal* find_signal(std::string_view name) {
    const auto found = std::find_if(table.begin(), table.end(), [&](const Signal& s) { return s.name == name; });
    return found == table.end() ? nullptr : &*found;
}

}  // namespace tiretherm::physics
