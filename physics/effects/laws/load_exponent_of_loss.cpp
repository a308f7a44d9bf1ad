// SPDX-License-Identifier: BSD-3-Clause
// Property modifier: SEL' = SEL (Fz/reference)^exponent. The thesis over-estimates one tire at low load and under-
// estimates it at high load (VI.1).

#include <array>
#include <cmath>

#include "physics/effect.hpp"

namespace tiretherm::physics::effects {

namespace {

enum : std::size_t { exponent, reference };

constexpr std::array parameters{
    ParameterSpec{"exponent", "1", 0.0, -3.0, 3.0, "of the load, beside what the law has already", false, 0.0},
    ParameterSpec{"reference", "N", 4500.0, 1.0, 1e6, "load at which the loss is left as it is"},
};
constexpr std::array confounded{
    ConfoundedGroup{{"load_exponent_of_loss", "strain_energy_loss.tan_delta_a", "drum_curvature"},
                    "load steps at constant speed; the same tire on the drum and on a flat track"}};
constexpr std::array plausible{
    PlausibleRange{"exponent", -0.6, 0.6,
                   "SAE J2452: loss with the load to the power 0.8 to 1.2 (recalled), where the thesis's law has 1.4",
                   "no tire's loss follows the load like that: the load is logged wrong"},
};
constexpr std::array<std::string_view, 1> reads{"vertical_load"};

void modify_laws(const ActiveEffect& active, const Tire& tire, const Inputs& inputs, Laws& laws) {
    if (tire.touches(inputs.vertical_load)) {
        laws.loss *= std::pow(inputs.vertical_load / active[reference], active[exponent]);
    }
}

double share_of_reference(const ActiveEffect& active, const Tire& tire, const Inputs& inputs) {
    return tire.touches(inputs.vertical_load) ? inputs.vertical_load / active[reference] : 0.0;
}

/// A power stands for the measured course about one load (this file's own bound).
constexpr std::array compared{ComparedRange{"", 0.5, 1.5, "stated", "times its reference load", share_of_reference}};

}  // namespace

extern const Effect load_exponent_of_loss;
const Effect load_exponent_of_loss{
    .id = "load_exponent_of_loss",
    .kind = EffectKind::source,
    .equation = "SEL' = SEL (Fz/reference)^exponent",
    .source = "definition; thesis VI.1 over-estimates one tire at low load and under-estimates it at high",
    .valid = "0.5 to 1.5 times the reference load; exponents of 0 to 1 beside the law's own",
    .meaning =
        "Loss that grows with the load otherwise than the law has it: (43) with (37), (44) and (57) makes it nearly "
        "proportional to Fz, measured tires lie between Fz and Fz^2.",
    .compared = compared,
    .parameters = parameters,
    .plausible = plausible,
    .confounded = confounded,
    .reads = reads,
    .needs_tire = true,
    .model = PropertyModifier{.modify_laws = modify_laws},
};

}  // namespace tiretherm::physics::effects
