// SPDX-License-Identifier: BSD-3-Clause
// Programmes of inputs for the two-node bench, drawn from a seed.
#pragma once

#include <cstdint>
#include <vector>

namespace hidden_effects {

/// What a bench logs of its inputs, in SI and kelvin; straight between the samples.
struct Programme {
    std::vector<double> time;              ///< s, ascending
    std::vector<double> speed;             ///< m/s
    std::vector<double> vertical_load;     ///< N
    std::vector<double> slip_angle;        ///< rad
    std::vector<double> lateral_force;     ///< N
    std::vector<double> air_temperature;   ///< K
    std::vector<double> road_temperature;  ///< K
    std::vector<double> throttle;          ///< 0 to 1; no part of the tire's model
};

/// Forty minutes, a sample every `interval` seconds: a minute at rest, then speeds, loads and slip angles held for one to
/// seven minutes with ramps of four seconds between them; now and then nearly unloaded or at rest. What is logged has
/// the digits of a log, and the truth is driven by what is logged.
[[nodiscard]] Programme draw_programme(std::uint64_t seed, double interval = 2.0);
/// What somebody means to drive.
struct Drive {
    std::vector<double> time;           ///< s, ascending
    std::vector<double> speed;          ///< m/s
    std::vector<double> vertical_load;  ///< N
    std::vector<double> slip_angle;     ///< rad
};
/// A drive as it is logged, on a day of its own: the seed draws air, road and throttle.
[[nodiscard]] Programme drive_programme(const Drive& drive, std::uint64_t seed);
/// Forty minutes at one speed and one load, rolling straight from the start: little can be learnt from it.
[[nodiscard]] Programme draw_dull_programme(std::uint64_t seed, double interval = 2.0);

}  // namespace hidden_effects
