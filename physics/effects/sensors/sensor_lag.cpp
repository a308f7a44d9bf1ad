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
constexpr std::array confounded{
    ConfoundedGroup{{"sensor_lag", "clock_delay"},
                    "a step of the load or the laser: a lag rounds it, a delay moves it; a finer grid, for coarse "
                    "cells lag too"}};
constexpr std::array plausible{
    PlausibleRange{"tau", 0.0, 180.0, "infrared sensors below 3 s, probes 5 to 20 s, gas 125 to 180 s; recalled",
                   "no sensor is that slow: something stores heat that the model lacks"},
    PlausibleRange{
        "tau", 0.0, 3.0, "response times of infrared sensors 10 ms to 1 s with the logger's filter; recalled",
        "no infrared sensor is that slow: the surface stores more heat than the model's, or the grid is too coarse",
        SensorKind::infrared},
    PlausibleRange{"tau", 0.0, 30.0, "probes in rubber 5 to 20 s; recalled",
                   "no probe is that slow: something stores heat that the model lacks", SensorKind::probe},
    PlausibleRange{"tau", 0.0, 180.0, "sensors of wheel modules 125 to 180 s; recalled",
                   "no sensor in a wheel is that slow: the rim or the gas stores more heat", SensorKind::gas},
};
constexpr std::array scopes{Scope::channel};

double lag(const ActiveEffect& active, std::size_t position) {
    return active.at(tau, Scope::channel, active.channels[position]);
}

}  // namespace

extern const Effect sensor_lag;
const Effect sensor_lag{
    .id = "sensor_lag",
    .kind = EffectKind::sensor,
    .equation = "tau dT_m/dt = T - T_m, T_m(0) = T(0)",
    .source = "first-order sensor",
    .valid = "one time constant, 0.1 to 60 s",
    .meaning =
        "A sensor that is slow: it reads too low while the tire heats, too high while it cools, and right when nothing "
        "changes.",
    .parameters = parameters,
    .plausible = plausible,
    .confounded = confounded,
    .scopes = scopes,
    .model = SensorModel{.lag = lag},
};

}  // namespace tiretherm::physics::effects
