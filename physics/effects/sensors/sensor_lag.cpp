// SPDX-License-Identifier: BSD-3-Clause
// Sensor model: slow first-order sensor, tau dT_m/dt = T - T_m, T_m(0) = T(0).

#include <array>

#include "physics/effect.hpp"

namespace tiretherm::physics::effects {

namespace {

enum : std::size_t { tau };

constexpr std::array parameters{
    ParameterSpec{"tau", "s", 10.0, 0.0, 1e5,
                  "time constant; 5 to 20 s of a probe in rubber, 125 to 180 s in gas, recalled", false, 0.0},
};
constexpr std::array scopes{Scope::channel};

double lag(const ActiveEffect& active, std::size_t position) {
    return active.at(tau, Scope::channel, active.channels[position]);
}

}  // namespace

extern const Effect sensor_lag;
const Effect sensor_lag{
    .id = "sensor_lag",
    .kind = Kind::sensor,
    .equation = "tau dT_m/dt = T - T_m, T_m(0) = T(0)",
    .source = "first-order sensor",
    .valid = "one time constant, 0.1 to 60 s",
    .meaning =
        "A sensor that is slow: it reads too low while the tire heats, too high while it cools, and right when nothing "
        "changes.",
    .parameters = parameters,
    .scopes = scopes,
    .model = SensorModel{.lag = lag},
};

}  // namespace tiretherm::physics::effects
