// SPDX-License-Identifier: BSD-3-Clause
// Sensor model: temperature channel with a gain error about its calibration temperature, reading = value + excess
// (value - reference).

#include <array>

#include "physics/effect.hpp"

namespace tiretherm::physics::effects {

namespace {

enum : std::size_t { excess, reference };

constexpr std::array parameters{
    ParameterSpec{"excess", "1", 0.0, -1.0, 10.0, "gain of the channel less 1", false, 0.0},
    ParameterSpec{"reference", "K", 298.15, 0.0, 1000.0, "temperature that the channel reads right"},
};
constexpr std::array plausible{
    PlausibleRange{"excess", -0.1, 0.1, "infrared sensors 1 to 5 % of the rise, with emissivity up to 10 %; recalled",
                   "no gain is that wrong: the place is not the one that is simulated"},
    PlausibleRange{"excess", -0.05, 0.05, "probes conduct heat along their leads, 1 to 5 % of the rise; recalled",
                   "no probe's gain is that wrong: it sits elsewhere, or a loss is missing", SensorKind::probe},
};
constexpr std::array scopes{Scope::channel};

double read(const ActiveEffect& active, std::size_t position, double value, const Inputs& /*logged*/) {
    const int channel = active.channels[position];
    const double about = active.at(reference, Scope::channel, channel);
    return value + active.at(excess, Scope::channel, channel) * (value - about);
}

}  // namespace

extern const Effect sensor_gain;
const Effect sensor_gain{
    .id = "sensor_gain",
    .kind = EffectKind::sensor,
    .equation = "reading = value + excess (value - reference), reference 25 degC",
    .source = "definition",
    .valid = "errors in proportion, some per cent",
    .meaning =
        "A temperature channel that is right at the temperature of its calibration and off in proportion beyond. "
        "Without an excess it does nothing.",
    .parameters = parameters,
    .plausible = plausible,
    .scopes = scopes,
    .model =
        SensorModel{
            .applies_to = ChannelsOf::temperature,
            .read = read,
        },
};

}  // namespace tiretherm::physics::effects
