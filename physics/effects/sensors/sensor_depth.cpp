// SPDX-License-Identifier: BSD-3-Clause
// Sensor model: probe that sits deeper or shallower than stated, z = stated + offset.

#include <array>

#include "physics/effect.hpp"

namespace tiretherm::physics::effects {

namespace {

enum : std::size_t { offset };

constexpr std::array parameters{
    ParameterSpec{"offset", "m", 0.0, -0.1, 0.1, "how much deeper than stated the sensor sits", false, 0.0},
};
constexpr std::array plausible{
    PlausibleRange{"offset", -0.003, 0.003, "a hole for a probe is drilled to 1 to 2 mm; recalled",
                   "depths are known better than that: another cause makes the gradient"},
};
constexpr std::array scopes{Scope::channel};

double depth_offset(const ActiveEffect& active, std::size_t position) {
    return active.at(offset, Scope::channel, active.channels[position]);
}

}  // namespace

extern const Effect sensor_depth;
const Effect sensor_depth{
    .id = "sensor_depth",
    .kind = EffectKind::sensor,
    .equation = "z = stated + offset",
    .source = "definition",
    .valid = "some mm; where the field is straight over them",
    .meaning =
        "A probe that sits deeper or shallower than stated, for channels that read at a point: what it changes follows "
        "the heat flux and vanishes in a soaked tire. Without an offset it does nothing.",
    .parameters = parameters,
    .plausible = plausible,
    .scopes = scopes,
    .needs_grid = true,
    .model =
        SensorModel{
            .applies_to = ChannelsOf::temperature_at_point,
            .depth_offset = depth_offset,
        },
};

}  // namespace tiretherm::physics::effects
