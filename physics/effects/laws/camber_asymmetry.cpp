// SPDX-License-Identifier: BSD-3-Clause
// Property modifier: camber moves loss between the shoulders, 1 - c gamma at the inside and 1 + c gamma at the outside
// one (geometry of a leaning band, derived in this file; thesis IV.1.1).

#include <array>

#include "physics/effect.hpp"

namespace tiretherm::physics::effects {

namespace {

enum : std::size_t { c };

// A wheel leaning by gamma presses a place y from its centre plane down by delta + gamma y, and the energy of a spring
// grows with the square: 1 + 2 gamma y/delta. At the shoulders of a 225/50 R17, y = 0.08 m, under 4 kN, delta = 17 mm:
// c = 2 y/delta = 9.5 1/rad.
constexpr std::array parameters{
    ParameterSpec{"c", "rad-1", 10.0, 0.0, 100.0,
                  "how much of a shoulder's loss moves per radian of camber; from geometry", false, 0.0},
};
constexpr std::array plausible{
    PlausibleRange{"c", 0.0, 20.0,
                   "thesis: 15 K between the shoulders at 140 km/h, a few degrees of camber; 10 from geometry",
                   "one shoulder would carry all of the loss at a few degrees of camber"},
};
constexpr std::array<std::string_view, 1> may_read{"camber"};

void modify_laws(const ActiveEffect& active, const Tire& /*tire*/, const Inputs& inputs, Laws& laws) {
    laws.loss_skew += active[c] * inputs.camber;
}

}  // namespace

extern const Effect camber_asymmetry;
const Effect camber_asymmetry{
    .id = "camber_asymmetry",
    .kind = EffectKind::source,
    .equation = "share of the loss: inside shoulder 1 - c gamma, outside shoulder 1 + c gamma, straight between",
    .source =
        "geometry of a leaning band, this file; thesis IV.1.1: the inside shoulder runs 15 K above the outside one",
    .valid =
        "camber of some degrees; the gain is of the order of the thesis's 15 K between the shoulders, to be fitted",
    .meaning =
        "Camber loads one shoulder more than the other: with the top leaning inboard (negative camber) the inside one. "
        "The total stays. A mesh without shoulders does not show it.",
    .parameters = parameters,
    .plausible = plausible,
    .may_read = may_read,
    .needs_tire = true,
    .needs_grid = true,
    .model = PropertyModifier{.modify_laws = modify_laws},
};

}  // namespace tiretherm::physics::effects
