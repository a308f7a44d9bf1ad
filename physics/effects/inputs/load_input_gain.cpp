// SPDX-License-Identifier: BSD-3-Clause
// Input correction: vertical load that is off by a factor, Fz = gain logged.

#include <array>

#include "physics/effect.hpp"

namespace tiretherm::physics::effects {

namespace {

enum : std::size_t { gain };

constexpr std::array parameters{
    ParameterSpec{"gain", "1", 1.0, 0.0, 10.0, "true vertical load over the logged one", false, 1.0},
};
constexpr std::array plausible{
    PlausibleRange{"gain", 0.9, 1.1, "load cells 1 %, loads estimated from a vehicle's motion 5 to 10 %; recalled",
                   "no load is known that badly: the loss follows the load otherwise (load_exponent_of_loss)"},
};
constexpr std::array<std::string_view, 1> reads{"vertical_load"};

void transform(const ActiveEffect& active, Inputs& inputs) { inputs.vertical_load *= active[gain]; }

}  // namespace

extern const Effect load_input_gain;
const Effect load_input_gain{
    .id = "load_input_gain",
    .kind = EffectKind::input,
    .equation = "Fz = gain logged",
    .source = "definition",
    .valid = "errors in proportion to the load, some per cent",
    .meaning =
        "A load cell, or a load distribution, that is off by a factor: strain-energy loss, contact and radii follow.",
    .parameters = parameters,
    .plausible = plausible,
    .reads = reads,
    .model = InputCorrection{.transform = transform},
};

}  // namespace tiretherm::physics::effects
