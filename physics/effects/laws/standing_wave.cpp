// SPDX-License-Identifier: BSD-3-Clause
// Property modifier: loss of the standing wave above a critical speed, SEL' = SEL (1 + gain max(0, V -
// critical_speed)^2) (the wave: Turner 1954).

#include <algorithm>
#include <array>
#include <cmath>

#include "physics/effect.hpp"

namespace tiretherm::physics::effects {

namespace {

enum : std::size_t { gain, critical_speed };

constexpr std::array parameters{
    ParameterSpec{"gain", "1/(km/h)^2", 1e-4, 0.0, 1.0,
                  "growth of the loss with the square of the excess speed; assumed", false, 0.0},
    ParameterSpec{
        "critical_speed", "km h-1", 140.0, 0.0, 500.0,
        "speed at which the wave appears; 200 to 300 km/h for a car tire at its pressure, recalled; less with less"},
};
/// The signature begins at the wave's speed.
constexpr std::array trials{
    TrialValues{.parameter = "gain",
                .other = "critical_speed",
                .held = {80.0, 95.0, 110.0, 125.0, 140.0, 155.0, 170.0, 190.0, 215.0, 245.0}},
};
constexpr std::array plausible{
    PlausibleRange{"gain", 0.0, 1e-3, "the loss doubles within 30 to 100 km/h above the wave's speed; recalled",
                   "the tire would not last a minute above that speed"},
    PlausibleRange{"critical_speed", 80.0, 350.0,
                   "200 to 300 km/h at the right pressure, from 80 km/h at a low one; recalled",
                   "below it no tire has a standing wave"},
};
constexpr std::array<std::string_view, 1> reads{"speed"};
constexpr double metres_per_second_in_kmh = 3.6;

double excess_speed(const ActiveEffect& active, const Tire& /*tire*/, const Inputs& inputs) {
    return std::max(0.0, metres_per_second_in_kmh * std::abs(rolling_speed(inputs)) - active[critical_speed]);
}

void modify_laws(const ActiveEffect& active, const Tire& tire, const Inputs& inputs, Laws& laws) {
    const double excess = excess_speed(active, tire, inputs);
    laws.loss *= 1.0 + active[gain] * excess * excess;
}

/// A parabola stands for the wave near its beginning (this file's own bound).
constexpr std::array compared{ComparedRange{"", 0.0, 40.0, "stated", "km/h above its critical speed", excess_speed}};

}  // namespace

extern const Effect standing_wave;
const Effect standing_wave{
    .id = "standing_wave",
    .kind = EffectKind::source,
    .equation = "SEL' = SEL (1 + gain max(0, V - critical_speed)^2)",
    .source = "parabola from the critical speed on; the wave: Turner, Rubber Chem. Technol. 27, 1954 (recalled)",
    .valid = "up to some 40 km/h above the critical speed; the gain is assumed, to be fitted",
    .meaning =
        "Above a critical speed the tread leaves the contact as a wave that stands behind it and the loss runs away. "
        "Nothing below. The wave heats the shoulders first; here the excess is spread as the loss is.",
    .compared = compared,
    .parameters = parameters,
    .plausible = plausible,
    .trials = trials,
    .reads = reads,
    .model = PropertyModifier{.modify_laws = modify_laws},
};

}  // namespace tiretherm::physics::effects
