// SPDX-License-Identifier: BSD-3-Clause
// Sensor model: temperature channel with a constant offset, reading = value + kelvin, as of a Pt100 with long leads
// (IEC 60751).

#include <array>

#include "physics/effect.hpp"

namespace tiretherm::physics::effects {

namespace {

enum : std::size_t { kelvin };

constexpr std::array parameters{
    ParameterSpec{"kelvin", "K", 0.0, -100.0, 100.0, "added to the reading; a lead of 0.4 ohm makes 1 K on a Pt100",
                  true, 0.0},
};
constexpr std::array confounded{
    ConfoundedGroup{{"sensor_offset", "sidewall_convection"},
                    "the reading before the start, with the tire at the air's temperature: only an offset shows"}};
constexpr std::array plausible{
    PlausibleRange{"kelvin", -5.0, 5.0,
                   "infrared sensors 1 to 3 K, thermocouples 1.5 K, 0.4 ohm of lead on a Pt100 1 K; recalled",
                   "a sensor that is that wrong shows it in a tire at the air's temperature: check it there"},
    PlausibleRange{
        "kelvin", -3.0, 3.0, "thermocouples 1.5 K (class 1 of IEC 60584, recalled), 0.4 ohm of lead on a Pt100 1 K",
        "a probe that is that wrong shows it in a tire at the air's temperature: check it there", SensorKind::probe},
};
constexpr std::array scopes{Scope::channel};

double read(const ActiveEffect& active, std::size_t position, double value, const Inputs& /*logged*/) {
    return value + active.at(kelvin, Scope::channel, active.channels[position]);
}

}  // namespace

extern const Effect sensor_offset;
const Effect sensor_offset{
    .id = "sensor_offset",
    .kind = EffectKind::sensor,
    .equation = "reading = value + kelvin",
    .source = "definition; a Pt100 changes by 0.385 ohm/K (IEC 60751)",
    .valid = "some kelvin, the same through a run",
    .meaning =
        "A temperature channel that is off by the same amount from the first moment on, such as a resistance "
        "thermometer with long leads. Without kelvin it does nothing.",
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
