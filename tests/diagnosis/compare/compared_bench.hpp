// SPDX-License-Identifier: BSD-3-Clause
// The two-node bench at constant temperature with short logs of known differences, for tests of the comparison.
#pragma once

#include <string>
#include <string_view>

#include "input/measurements/measured_bench.hpp"

namespace tiretherm::diagnosis::sample {

/// The bench of two nodes with no effect at all.
inline const std::string idle = std::string(input::bench) + R"(standard_deviation = "0.4 K"
[effects]
strain_energy_loss = { on = false }
sliding_friction = { on = false }
air_convection = { on = false }
road_contact = { on = false }
)";

/// Whatever it is driven with, it stays at 23 degC.
inline const std::string idle_bench = idle + R"([[run]]
file = "first.csv"
[[run.measured]]
channel = "bulk_temperature"
value = "25 degC"
uncertainty = "0.5 K"
source = "needle"
[[run]]
file = "second.csv"
)";

/// Heated to 1e6 K in a step, far beyond where the conductivity of its link falls below zero.
inline const std::string burning_bench = idle + R"(uniform_source = { power_density = "1e12 W/m3" }
layer_conductivity = { slope = "-1 %/K" }
[time]
step = "8 s"
[[run]]
file = "first.csv"
)";

/// Two seconds at rest, a start, a second of slip; the last reading of the bulk is missing.
/// Simulated less measured: bulk +1, -1, 0, +1, surface -2, -2, -2, -1, -1 K.
inline constexpr std::string_view first_log =
    "time [s],speed [km/h],vertical_load [N],slip_angle [deg],lateral_force [N],air_temperature [degC],throttle [-],"
    "surface_temperature [degC],bulk_temperature [degC]\n"
    "0,0,4000,0,0,13,0.1,25,22\n"
    "2,0,4000,0,0,13,0.2,25,24\n"
    "4,36,4000,0,0,13,0.3,25,23\n"
    "6,36,4000,1,-1000,13,0.4,24,22\n"
    "8,36,4000,0,0,13,0.5,24,\n";

/// Bulk: +3, +3 K. No surface, no throttle.
inline constexpr std::string_view second_log =
    "time [s],speed [km/h],vertical_load [N],slip_angle [deg],lateral_force [N],air_temperature [degC],"
    "bulk_temperature [degC]\n"
    "0,36,4000,0,0,13,20\n"
    "10,36,4000,0,0,13,20\n";

}  // namespace tiretherm::diagnosis::sample
