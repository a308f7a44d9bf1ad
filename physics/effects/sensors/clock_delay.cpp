// SPDX-License-Identifier: BSD-3-Clause
// Sensor model: logger whose clock is late or early, reading(t) = value(t - delay).

#include <array>

#include "physics/effect.hpp"

namespace tiretherm::physics::effects {

namespace {

enum : std::size_t { seconds };

constexpr std::array parameters{
    ParameterSpec{"delay", "s", 0.0, -100.0, 100.0, "how late the channel is written; negative: early", false, 0.0},
};
constexpr std::array plausible{
    PlausibleRange{"delay", -3.0, 3.0, "clocks of two loggers 0.1 to 1 s, aligned by eye some seconds; recalled",
                   "clocks agree better than that: the sensor is slow (sensor_lag) or the model is"},
};
constexpr std::array scopes{Scope::channel};

double delay(const ActiveEffect& active, std::size_t position) {
    return active.at(seconds, Scope::channel, active.channels[position]);
}

}  // namespace

extern const Effect clock_delay;
const Effect clock_delay{
    .id = "clock_delay",
    .kind = EffectKind::sensor,
    .equation = "reading(t) = value(t - delay)",
    .source = "definition",
    .valid = "delays that stay the same through a run",
    .meaning =
        "A logger whose clock is late or early against that of the inputs, by 0.1 to 1 s when two loggers are put "
        "together by hand. Without a delay it does nothing.",
    .parameters = parameters,
    .plausible = plausible,
    .scopes = scopes,
    .model = SensorModel{.delay = delay},
};

}  // namespace tiretherm::physics::effects
