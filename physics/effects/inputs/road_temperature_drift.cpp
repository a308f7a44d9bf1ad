// SPDX-License-Identifier: BSD-3-Clause
// Input correction: road temperature that is off or drifts from the log, T_road = logged + offset + rate t. The thesis holds it
// constant (chapter V).

#include <array>

#include "physics/effect.hpp"

namespace tiretherm::physics::effects {

namespace {

enum : std::size_t { rate, offset };

constexpr std::array parameters{
    ParameterSpec{"rate", "K h-1", 0.0, -1000.0, 1000.0, "how fast the true temperature leaves the logged one", true,
                  0.0},
    // Without a value at which it is absent: a fit may free it where a case says so, and it is no cause by itself.
    ParameterSpec{"offset", "K", 0.0, -100.0, 100.0, "how much hotter the road is than given, at the start", true},
};
constexpr std::array plausible{
    PlausibleRange{"rate", -30.0, 30.0,
                   "asphalt between sun and shade 5 K in ten minutes, some K/h over a session; recalled",
                   "no road warms or cools that fast for long: measure its temperature"},
};
constexpr std::array<std::string_view, 1> reads{"road_temperature"};

void transform(const ActiveEffect& active, Inputs& inputs) {
    inputs.road_temperature += active[offset] + active[rate] * inputs.time / 3600.0;
}

}  // namespace

extern const Effect road_temperature_drift;
const Effect road_temperature_drift{
    .id = "road_temperature_drift",
    .kind = EffectKind::input,
    .equation = "T_road = logged + offset + rate t, t since the run's start",
    .source = "definition; the thesis holds the track at one temperature (hypotheses of chapter V)",
    .valid = "drifts that are straight in time over the run",
    .meaning =
        "A track or drum that is hotter than given, or that warms or cools beside the log: the sun, or the tire's own "
        "heat on a drum. Where the road was not measured, give it the air's temperature and free the offset. Without a "
        "rate and an offset it does nothing.",
    .parameters = parameters,
    .plausible = plausible,
    .reads = reads,
    .model = InputCorrection{.transform = transform},
};

}  // namespace tiretherm::physics::effects
