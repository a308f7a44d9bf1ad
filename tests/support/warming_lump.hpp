// SPDX-License-Identifier: BSD-3-Clause
// A plate of one temperature heated by speed: closed form of a step-speed test, and its case.
#pragma once

#include <cmath>
#include <string>
#include <vector>

/// A plate of one temperature that a speed heats: the closed form of a step-speed test, and its case.
namespace tiretherm::support {

/// C dT/dt = a v - G (T - T_air) with C = 10 kJ/K, G = 10 W/K, so 1000 s, and a = 20 W per m/s: a speed v settles at
/// 20 + 2 v degC. From 20 degC, steps of one length.
struct WarmingLump {
    double step = 600.0;  ///< s
    double first = 20.0;  ///< m/s
    double rise = 2.0;    ///< m/s

    [[nodiscard]] double settled(int i) const { return 20.0 + 2.0 * (first + rise * i); }
    /// When a temperature is passed. @param steps most of them  @returns s; NaN where it is not
    [[nodiscard]] double passing(double celsius, int steps) const {
        double T = 20.0;
        for (int i = 0; i < steps; ++i) {
            const double end = settled(i) + (T - settled(i)) * std::exp(-step / 1000.0);
            if (end >= celsius) {
                return step * i + 1000.0 * std::log((T - settled(i)) / (celsius - settled(i)));
            }
            T = end;
        }
        return std::nan("");
    }
    /// At the end of a step, the first is 0. degC
    [[nodiscard]] double at_end(int i) const {
        double T = 20.0;
        for (int k = 0; k <= i; ++k) {
            T = settled(k) + (T - settled(k)) * std::exp(-step / 1000.0);
        }
        return T;
    }
};

/// Everything of its case but the schedule of the inputs and the end of the run.
inline const std::string warming_plate = R"(
title = "A plate that a speed warms"
[mesh]
kind = "layers"
area = "1 m2"
[[mesh.layer]]
name = "plate"
thickness = "10 mm"
cells = 3
material = "metal"
[[material]]
name = "metal"
density = "1000 kg/m3"
heat_capacity = "1000 J/kgK"
conductivity = "400 W/mK"
[effects.still_air]
h = "10 W/m2K"
patches = ["outside"]
[[source]]
name = "running"
follows = "speed"
at = "plate"
watts = "20 W"
[initial]
temperature = "20 degC"
[[sensor]]
name = "top"
kind = "point"
depth = "0 mm"
)";

/// Three steps of ten minutes: 20, 22 and 24 m/s.
inline const std::string three_steps = R"(
[drive]
air_temperature = "20 degC"
[[drive.schedule]]
columns = ["time [min]", "speed [m/s]"]
rows = [[0, 20], [10, 20], [10, 22], [20, 22], [20, 24], [30, 24]]
[time]
end = "30 min"
tolerance = "0.0001 K"
output = "5 s"
)";

inline std::string critical(const std::string& temperature) {
    return "[[critical]]\nname = \"plate\"\ntemperature = \"" + temperature + "\"\nsurface = \"top\"\n";
}

}  // namespace tiretherm::support
