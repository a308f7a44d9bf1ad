// SPDX-License-Identifier: BSD-3-Clause
// A two-node case whose inputs come from measured runs, and a short log for it.
#pragma once

#include <string>
#include <string_view>

#include "input/runs/read_experiment.hpp"
#include "support/written.hpp"

namespace tiretherm::input {

/// A two-node tire whose inputs are left to its runs; tests add to it.
inline constexpr std::string_view bench = R"(
[tire]
size = "225/50 R17"
unloaded_radius = "330.8 mm"
[mesh]
kind = "two_node"
surface_mass_share = 0.15
bulk_depth = "10 mm"
material = "rubber"
[[material]]
name = "rubber"
density = "1100 kg/m3"
heat_capacity = "1800 J/kgK"
conductivity = "0.5 W/mK"
[initial]
temperature = "23 degC"
[[sensor]]
name = "surface_temperature"
kind = "region"
region = "surface"
[[sensor]]
name = "bulk_temperature"
kind = "region"
region = "bulk"
)";

/// A log of five samples with everything that the bench needs.
inline constexpr std::string_view log_of_five =
    "time [s],speed [km/h],vertical_load [N],air_temperature [degC],road_temperature [degC],throttle [-],"
    "surface_temperature [degC],bulk_temperature [degC]\n"
    "0,36,4000,25,30,0.10,25.0,25.5\n"
    "2,54,4100,25,30,0.20,25.5,25.8\n"
    "5,72,4200,25,31,0.35,26.0,26.1\n"
    "6,72,4200,26,31,0.40,26.3,26.6\n"
    "10,36,4000,26,31,0.15,26.1,27.0\n";

/// A text with every `what` turned into `by`.
inline std::string replaced(std::string text, const std::string& what, const std::string& by) {
    for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size()) {
        text.replace(at, what.size(), by);
    }
    return text;
}

inline std::string error_report(const ExperimentReading& reading) {
    std::string text;
    for (const InputError& error : reading.errors) {
        text += render(error);
    }
    for (const std::string& warning : reading.warnings) {
        text += "warning: " + warning + "\n";
    }
    return text;
}

inline const MeasuredSeries* find_series(const MeasuredRun& run, std::string_view channel) {
    for (const MeasuredSeries& series : run.series) {
        if (run.problem.channels[series.channel].name == channel) {
            return &series;
        }
    }
    return nullptr;
}

}  // namespace tiretherm::input
