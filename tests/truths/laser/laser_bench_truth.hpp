// SPDX-License-Identifier: BSD-3-Clause
// Independent truth of the laser bench, cases/practice/laser_bench.md: programme, hidden causes and noise-free sensors.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "laser/laser_truth.hpp"
#include "two_node/two_node_truth.hpp"

namespace hidden_effects {

/// The sensors of the bench, in the order of LaserBenchTrace::channel.
inline constexpr std::array<std::string_view, 3> laser_channels{"spot_centre_temperature", "spot_mean_temperature",
                                                                "inner_liner_temperature"};

/// What the laser's bench logs; straight between the samples.
struct LaserProgramme {
    std::vector<double> time;   ///< s, ascending
    std::vector<double> power;  ///< W
    std::vector<double> lamp;   ///< 0 to 1; no part of the model
    double air = 23.0;          ///< degC
};

/// Twenty minutes, a sample every five seconds: half a minute without light, then powers up to 1.5 W held for one to five
/// minutes with ramps of one sample between them, now and then none. What is logged has the digits of a log.
[[nodiscard]] LaserProgramme draw_laser_programme(std::uint64_t seed);

/// The specimen of cases/practice/laser_bench.md: what its user does not know, and what else is going on. A cause on a
/// layer names it ("tread", "bulk") as its channel. Not in the catalogue, both evenly over the inner face:
/// unknown_lamp.watts times the lamp, unknown_hours.watts times the hours since the start.
struct LaserBench {
    double absorptivity = 0.93;
    double h_top = 10.0;     ///< W/m2K
    double h_bottom = 10.0;  ///< W/m2K
    double start = 23.0;     ///< degC
    std::vector<Cause> causes{};
};

/// What the sensors give at the programme's times, without noise. [channel][sample] degC
struct LaserBenchTrace {
    std::array<std::vector<double>, laser_channels.size()> channel;
    int n_steps = 0;
};

/// The finite elements and the integrator of laser_truth.hpp, stopping at every sample.
/// @errors std::invalid_argument names a cause, a parameter or a channel that is not known
[[nodiscard]] LaserBenchTrace drive_laser(const LaserBench& bench, const LaserProgramme& programme,
                                          const LaserResolution& resolution = {.refinement = 1, .tolerance = 1e-3});

}  // namespace hidden_effects
