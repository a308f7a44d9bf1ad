// SPDX-License-Identifier: BSD-3-Clause
// A small specimen with a camera of 3 by 4 pixels, to which tests add frames.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "input/measurements/measured_bench.hpp"

namespace tiretherm::input {

/// A small disc under a laser with a camera of 3 rows and 4 columns; tests add their runs.
inline constexpr std::string_view camera_bench = R"([mesh]
kind = "axisymmetric"
radius = [{ to = "20 mm", cells = 10 }]
[[mesh.layer]]
name = "tread"
thickness = "5 mm"
cells = 4
material = "rubber"
[[material]]
name = "rubber"
density = "1100 kg/m3"
heat_capacity = "1800 J/kgK"
conductivity = "0.5 W/mK"
[effects.laser]
radius = "5 mm"
[effects.still_air]
patches = ["top", "bottom"]
[drive]
laser_power = "1 W"
air_temperature = "23 degC"
[initial]
temperature = "23 degC"
[time]
end = "20 s"
)";

inline constexpr std::string_view one_camera = "[[camera]]\nname = \"camera\"\npixel_size = \"2 mm\"\n";
inline constexpr std::string_view one_run = "[[run]]\nname = \"heating\"\nframes = \"frames.csv\"\n";

/// Two frames of 3 x 4 pixels; pixel r1c2 has the value `middle` in the second one.
inline std::string frames_csv(const std::string& middle = "33.5") {
    std::string text = "time [s]";
    for (int pixel = 0; pixel < 12; ++pixel) {
        text += ",r" + std::to_string(pixel / 4) + "c" + std::to_string(pixel % 4) + " [degC]";
    }
    text += "\n0";
    for (int pixel = 0; pixel < 12; ++pixel) {
        text += "," + std::to_string(20 + pixel);
    }
    text += "\n20";
    for (int pixel = 0; pixel < 12; ++pixel) {
        text += "," + (pixel == 6 ? middle : std::to_string(30 + pixel));
    }
    return text + "\n";
}

}  // namespace tiretherm::input
