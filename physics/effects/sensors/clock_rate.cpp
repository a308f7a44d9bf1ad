// SPDX-License-Identifier: BSD-3-Clause
// Sensor model: logger whose clock is slow or fast, reading(t) = value(t - rate t), as two quartz clocks put together at the
// run's start leave each other.

#include <array>

#include "physics/effect.hpp"

namespace tiretherm::physics::effects {

namespace {

enum : std::size_t { rate };

constexpr std::array parameters{
    ParameterSpec{"rate", "1", 0.0, -0.3, 0.3,
                  "share of the time by which the channel falls behind; 0.001: 3.6 s in an hour", false, 0.0},
};
constexpr std::array confounded{ConfoundedGroup{
    {"clock_rate", "clock_delay"},
    "one sharp event at the start and one at the end of a run: a delay moves both by the same, a rate the "
    "later one more"}};
constexpr std::array plausible{
    PlausibleRange{"rate", -0.005, 0.005,
                   "quartz clocks 1e-4, loggers that count samples of a nominal rate up to 0.5 %; assumed",
                   "no clock in order is that wrong: compare both logs' lengths"},
};
constexpr std::array scopes{Scope::channel};

double clock_rate_of(const ActiveEffect& active, std::size_t position) {
    return active.at(rate, Scope::channel, active.channels[position]);
}

}  // namespace

extern const Effect clock_rate;
const Effect clock_rate{
    .id = "clock_rate",
    .kind = EffectKind::sensor,
    .equation = "reading(t) = value(t - rate t), t since the run's start",
    .source = "definition",
    .valid = "clocks that agree at the run's start and leave each other evenly",
    .meaning =
        "A logger whose clock is slow or fast against that of the inputs, as where samples are counted at a rate that "
        "is "
        "not quite the nominal one: its readings come later and later. Without a rate it does nothing.",
    .parameters = parameters,
    .plausible = plausible,
    .confounded = confounded,
    .scopes = scopes,
    .model = SensorModel{.clock_rate = clock_rate_of},
};

}  // namespace tiretherm::physics::effects
