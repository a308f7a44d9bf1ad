// SPDX-License-Identifier: BSD-3-Clause
// Input correction: absorbed laser power, P = factor exp(-fall t) logged, for light that is reflected and a laser whose
// power falls.

#include <array>
#include <cmath>

#include "physics/effect.hpp"

namespace tiretherm::physics::effects {

namespace {

enum : std::size_t { factor, fall };

constexpr std::array parameters{
    ParameterSpec{"factor", "1", 0.95, 0.0, 2.0, "absorbed power over that of the laser effect; 0.90 to 0.97 recalled",
                  false, 1.0},
    ParameterSpec{"fall", "h-1", 0.0, -100.0, 100.0, "rate at which the power falls off, of itself", false, 0.0},
};
constexpr std::array plausible{
    PlausibleRange{"factor", 0.8, 1.05, "black rubber 0.90 to 0.97 with a power meter of 5 %, recalled",
                   "black rubber reflects less than that: the conductivity is off"},
    PlausibleRange{"fall", -0.2, 0.2, "power of a diode laser drifts by some per cent in an hour, recalled",
                   "no laser ages that fast: something warms or cools slowly"},
};
constexpr std::array<std::string_view, 1> reads{"laser_power"};

void transform(const ActiveEffect& active, Inputs& inputs) {
    inputs.laser_power *= active[factor] * std::exp(-active[fall] * inputs.time / 3600.0);
}

}  // namespace

extern const Effect laser_absorptivity;
const Effect laser_absorptivity{
    .id = "laser_absorptivity",
    .kind = EffectKind::input,
    .equation = "P = factor exp(-fall t) logged, t since the run's start",
    .source = "definition; the values for carbon-black rubber are recalled",
    .valid = "0.85 to 0.97 for carbon-black rubber (recalled)",
    .meaning =
        "Light that the rubber reflects, and a laser whose power sags: front and back of a specimen fall by the same "
        "share and the time constant stays.",
    .parameters = parameters,
    .plausible = plausible,
    .reads = reads,
    .model = InputCorrection{.transform = transform},
};

}  // namespace tiretherm::physics::effects
