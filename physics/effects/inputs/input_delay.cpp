// SPDX-License-Identifier: BSD-3-Clause
// Input correction: inputs whose log is late or early, x(t) = logged(t + delay), each by a delay of its own.

#include <array>

#include "physics/effect.hpp"

namespace tiretherm::physics::effects {

namespace {

constexpr double most = 600.0;  // s, of a receiver whose clock was set during the run

constexpr ParameterSpec delay_of(std::string_view signal) {
    return {signal, "s", 0.0, -most, most, "how late this input is written; negative: early", false, 0.0};
}

constexpr std::array parameters{
    delay_of("speed"),         delay_of("vertical_load"),      delay_of("slip_angle"), delay_of("slip_ratio"),
    delay_of("lateral_force"), delay_of("longitudinal_force"), delay_of("camber"),     delay_of("laser_power"),
};
constexpr std::array plausible{
    PlausibleRange{
        "*", -3.0, 3.0,
        "clocks of two loggers and filters of estimated signals 0.1 to 1 s, aligned by eye some seconds; recalled",
        "signals are not that late: compare their steps with those of another signal"},
};
constexpr std::array<std::string_view, 8> may_read{"speed",         "vertical_load",      "slip_angle", "slip_ratio",
                                                   "lateral_force", "longitudinal_force", "camber",     "laser_power"};

double delay(const ActiveEffect& active, const Signal& signal) {
    const int parameter = find_parameter(*active.effect, signal.name);
    return parameter < 0 ? 0.0 : active[static_cast<std::size_t>(parameter)];
}

}  // namespace

extern const Effect input_delay;
const Effect input_delay{
    .id = "input_delay",
    .kind = EffectKind::input,
    .equation =
        "x(t) = logged(t + delay of x), x one of speed, vertical_load, slip_angle, slip_ratio, lateral_force, "
        "longitudinal_force, camber, laser_power",
    .source = "definition",
    .valid = "delays that stay the same through a run; a log is read off between its samples by straight lines",
    .meaning =
        "An input that comes late, as loads and slips that are computed from filtered accelerations do by 0.1 to 0.5 "
        "s: "
        "heat then rises after the tire has warmed up. Without a delay it does nothing.",
    .parameters = parameters,
    .plausible = plausible,
    .may_read = may_read,
    .model = InputCorrection{.delay = delay},
};

}  // namespace tiretherm::physics::effects
