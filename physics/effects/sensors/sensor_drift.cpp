// SPDX-License-Identifier: BSD-3-Clause
// Sensor model: temperature channel that drifts, reading = value + rate t, as an infrared sensor whose housing warms or a
// pyrometer's window that gets dirty.

#include <array>

#include "physics/effect.hpp"

namespace tiretherm::physics::effects {

namespace {

enum : std::size_t { rate };

constexpr std::array parameters{
    ParameterSpec{"rate", "K h-1", 0.0, -1000.0, 1000.0, "how fast the reading leaves the true value", true, 0.0},
};
constexpr std::array confounded{
    ConfoundedGroup{{"sensor_drift", "air_temperature_drift", "road_temperature_drift"},
                    "a second sensor at the place, or the reading of the same state at the start and at the end: a "
                    "sensor drifts alone, air and road move all channels"}};
constexpr std::array plausible{
    PlausibleRange{"rate", -15.0, 15.0,
                   "infrared housings some K while they warm up, dirt on a window some K an hour; assumed",
                   "no sensor in order drifts that fast: check it at a known temperature before and after"},
};
constexpr std::array scopes{Scope::channel};

double read(const ActiveEffect& active, std::size_t position, double value, const Inputs& logged) {
    return value + active.at(rate, Scope::channel, active.channels[position]) * logged.time / 3600.0;
}

}  // namespace

extern const Effect sensor_drift;
const Effect sensor_drift{
    .id = "sensor_drift",
    .kind = EffectKind::sensor,
    .equation = "reading = value + rate t, t since the run's start",
    .source = "definition",
    .valid = "drifts that are straight in time over the run and begin with it",
    .meaning =
        "A temperature channel that leaves the truth more and more during a run, while the others do not: an infrared "
        "sensor whose housing warms, a window that gets dirty, an amplifier. Without a rate it does nothing.",
    .parameters = parameters,
    .plausible = plausible,
    .confounded = confounded,
    .scopes = scopes,
    .model =
        SensorModel{
            .applies_to = ChannelsOf::temperature,
            .read = read,
        },
};

}  // namespace tiretherm::physics::effects
