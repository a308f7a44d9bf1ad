// SPDX-License-Identifier: BSD-3-Clause
// Sensor model: pressure sensor on the rim whose membrane the rotation loads, reading = p/(1 + kappa V^2).

#include <array>

#include "physics/effect.hpp"

namespace tiretherm::physics::effects {

namespace {

enum : std::size_t { kappa };

constexpr std::array parameters{
    ParameterSpec{"kappa", "s2 m-2", 1e-5, 0.0, 1.0, "1 % low at 32 m/s; assumed", false, 0.0},
};
constexpr std::array plausible{
    PlausibleRange{"kappa", 0.0, 5e-5,
                   "readings of wheel modules fall by 1 % at 32 m/s (1e-5 s2/m2), some more; assumed",
                   "no pressure sensor is that sensitive to its rotation"},
};
constexpr std::array scopes{Scope::channel};
constexpr std::array<std::string_view, 1> reads{"speed"};

double read(const ActiveEffect& active, std::size_t position, double value, const Inputs& logged) {
    const double per_square = active.at(kappa, Scope::channel, active.channels[position]);
    return value / (1.0 + per_square * logged.speed * logged.speed);
}

/// Sensors on the rim (this file's own bound).
constexpr std::array compared{ComparedRange{"speed", 0.0, 300.0 / 3.6, "stated"}};

}  // namespace

extern const Effect pressure_reading_speed;
const Effect pressure_reading_speed{
    .id = "pressure_reading_speed",
    .kind = EffectKind::sensor,
    .equation = "reading = p/(1 + kappa V^2)",
    .source = "definition: a membrane that the wheel's rotation loads with V^2; the number is assumed",
    .valid = "sensors on the rim, up to 300 km/h; the number is assumed, to be fitted",
    .meaning =
        "A pressure sensor on the rim that reads lower the faster the wheel turns, at once and by the square of the "
        "speed. For channels of pressure.",
    .compared = compared,
    .parameters = parameters,
    .plausible = plausible,
    .scopes = scopes,
    .reads = reads,
    .model =
        SensorModel{
            .applies_to = ChannelsOf::pressure,
            .read = read,
        },
};

}  // namespace tiretherm::physics::effects
