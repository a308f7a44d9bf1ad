// SPDX-License-Identifier: BSD-3-Clause
// Input correction: road temperature that drifts from the log, T_road = logged + rate t. The thesis holds it constant
// (chapter V).

#include <array>

#include "physics/effect.hpp"

namespace tiretherm::physics::effects {

namespace {

enum : std::size_t { rate };

constexpr std::array parameters{
    ParameterSpec{"rate", "K h-1", 0.0, -1000.0, 1000.0, "how fast the true temperature leaves the logged one", true,
                  0.0},
};
constexpr std::array<std::string_view, 1> reads{"road_temperature"};

void transform(const ActiveEffect& active, Inputs& inputs) {
    inputs.road_temperature += active[rate] * inputs.time / 3600.0;
}

}  // namespace

extern const Effect road_temperature_drift;
const Effect road_temperature_drift{
    .id = "road_temperature_drift",
    .kind = Kind::input,
    .equation = "T_road = logged + rate t, t since the run's start",
    .source = "definition; the thesis holds the track at one temperature (hypotheses of chapter V)",
    .valid = "drifts that are straight in time over the run",
    .meaning =
        "A track or drum that warms or cools beside the log: the sun, or the tire's own heat on a drum. Without a "
        "rate it does nothing.",
    .parameters = parameters,
    .reads = reads,
    .model = InputCorrection{.transform = transform},
};

}  // namespace tiretherm::physics::effects
