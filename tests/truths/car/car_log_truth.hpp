// SPDX-License-Identifier: BSD-3-Clause
// What the logger of the made-up car records, as the export of an AiM logger.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "car/car_truth.hpp"

namespace hidden_effects {

/// A channel as a logger names it, with its noise already in it.
struct LoggedChannel {
    std::string name;
    std::string unit;  ///< as AiM writes it: C, g, deg/s
    int digits = 2;
    std::vector<double> value;  ///< [n_times]
};

/// As a logger writes it.
[[nodiscard]] std::string number(double value, int digits);

/// Speed, accelerations (lateral positive in right turns), yaw rate, steering, throttle, brake pressure, air temperature, place,
/// and an infrared sensor on each tire. No loads, no slips, no road temperature.
[[nodiscard]] std::vector<LoggedChannel> logged_channels(const Session& session, std::uint64_t seed);

/// An export of RaceStudio 3: lines of description, names, units, values, all quoted. @param rate 1/s
[[nodiscard]] std::string aim_export(const Session& session, const std::vector<LoggedChannel>& channels, double rate);

/// The same with what measuring wheels and sensors on the brakes give: load, slips, forces in the axes of the tire, temperature of
/// each disc.
[[nodiscard]] std::vector<LoggedChannel> logged_by_measuring_wheels(const Session& session, std::uint64_t seed);

/// The log of cases/car/wheels.toml: twelve laps, two samples a second, brakes that warm the tires.
[[nodiscard]] std::string shipped_wheel_log();
/// What is hidden in it.
[[nodiscard]] HiddenInCar hidden_in_wheel_log();

/// The log that comes with cases/car: eight laps, ten samples a second.
[[nodiscard]] std::string shipped_car_log();

}  // namespace hidden_effects
