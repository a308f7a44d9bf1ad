// SPDX-License-Identifier: BSD-3-Clause
// Input correction: speed that is off by a factor, V = gain logged.

#include <array>

#include "physics/effect.hpp"

namespace tiretherm::physics::effects {

namespace {

enum : std::size_t { gain };

constexpr std::array parameters{
    ParameterSpec{"gain", "1", 1.0, 0.0, 10.0, "true speed over the logged one", false, 1.0},
};
constexpr std::array plausible{
    PlausibleRange{"gain", 0.97, 1.03, "wheel speed by the rolling radius, 1 to 2 %; recalled",
                   "no speed is known that badly: convection or loss follow it otherwise"},
};
constexpr std::array<std::string_view, 1> reads{"speed"};

void transform(const ActiveEffect& active, Inputs& inputs) { inputs.speed *= active[gain]; }

}  // namespace

extern const Effect speed_input_gain;
const Effect speed_input_gain{
    .id = "speed_input_gain",
    .kind = EffectKind::input,
    .equation = "V = gain logged",
    .source = "definition",
    .valid = "errors in proportion to the speed, some per cent",
    .meaning =
        "A speed that is off by a factor, such as one taken from a wheel of another radius: convection, loss and "
        "friction follow, each by its own law of speed.",
    .parameters = parameters,
    .plausible = plausible,
    .reads = reads,
    .model = InputCorrection{.transform = transform},
};

}  // namespace tiretherm::physics::effects
