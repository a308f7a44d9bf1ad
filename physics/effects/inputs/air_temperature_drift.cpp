// SPDX-License-Identifier: BSD-3-Clause
// Input correction: air temperature that drifts from the log, T_air = logged + rate t. The thesis holds it constant
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
constexpr std::array plausible{
    PlausibleRange{"rate", -10.0, 10.0, "weather and test halls change by some K/h; recalled",
                   "no air warms or cools that fast for long: measure its temperature"},
};
constexpr std::array<std::string_view, 1> reads{"air_temperature"};

void transform(const ActiveEffect& active, Inputs& inputs) {
    inputs.air_temperature += active[rate] * inputs.time / 3600.0;
}

}  // namespace

extern const Effect air_temperature_drift;
const Effect air_temperature_drift{
    .id = "air_temperature_drift",
    .kind = EffectKind::input,
    .equation = "T_air = logged + rate t, t since the run's start",
    .source = "definition; the thesis holds the air at one temperature (hypotheses of chapter V)",
    .valid = "drifts that are straight in time over the run",
    .meaning =
        "Air around the tire that warms or cools beside the log, as in a wheelhouse or a closed hall. Every loss to "
        "the "
        "air sees it; what a camera sees reflected stays the logged air. Without a rate it does nothing.",
    .parameters = parameters,
    .plausible = plausible,
    .reads = reads,
    .model = InputCorrection{.transform = transform},
};

}  // namespace tiretherm::physics::effects
