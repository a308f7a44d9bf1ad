// SPDX-License-Identifier: BSD-3-Clause
// Property modifier: T_eq' = T_eq + per_decade log10(f/reference), an error of the time-temperature (WLF) shift of
// thesis (48).

#include <array>
#include <cmath>

#include "physics/effect.hpp"

namespace tiretherm::physics::effects {

namespace {

enum : std::size_t { per_decade, reference };

constexpr std::array parameters{
    ParameterSpec{"per_decade", "K", 0.0, -100.0, 100.0,
                  "added to the equivalent temperature per decade of frequency above the reference", true, 0.0},
    ParameterSpec{"reference", "Hz", 52.0, 1e-3, 1e6, "frequency at which the compound was characterised, f0 of (48)"},
};
constexpr std::array plausible{
    PlausibleRange{"per_decade", -12.0, 12.0,
                   "WLF with the thesis's constants shifts 11.5 K per decade at f0; an error of it is not larger",
                   "no compound shifts that much with frequency"},
};
constexpr std::array<std::string_view, 2> reads{"speed", "vertical_load"};

void modify_laws(const ActiveEffect& active, const Tire& tire, const Inputs& inputs, Laws& laws) {
    if (std::abs(rolling_speed(inputs)) > standing_speed) {  // below it there is no loss, and no logarithm
        const double frequency = tire.revolutions(inputs);
        laws.loss_shift += active[per_decade] * std::log10(frequency / active[reference]);
    }
}

}  // namespace

extern const Effect loss_frequency_shift;
const Effect loss_frequency_shift{
    .id = "loss_frequency_shift",
    .kind = EffectKind::source,
    .equation = "T_eq' = T_eq + per_decade log10(f/reference)",
    .source = "definition, beside thesis (48): universal WLF constants are only a first guess for a filled compound",
    .valid = "one or two decades about the frequency of the characterisation; -20 to 20 K a decade",
    .meaning =
        "A time-temperature shift that is wrong: the loss tangent at a given temperature changes with the logarithm of "
        "the speed. None at the frequency of the characterisation, none where there is no loss.",
    .parameters = parameters,
    .plausible = plausible,
    .reads = reads,
    .needs_tire = true,
    .model = PropertyModifier{.modify_laws = modify_laws},
};

}  // namespace tiretherm::physics::effects
