// SPDX-License-Identifier: BSD-3-Clause
// Property modifier: more loss on a drum than on a flat road, SEL' = SEL sqrt((1 + R0 curvature)/(1 + R0
// curvature_of_the_law)), curvature = 1/R_drum (after the drum correction of ISO 28580).

#include <array>

#include "physics/effect.hpp"
#include "physics/tire_laws/rolling_resistance.hpp"

namespace tiretherm::physics::effects {

namespace {

enum : std::size_t { curvature };

constexpr std::array parameters{
    ParameterSpec{"curvature", "m-1", 1.1716, 0.0, 10.0,
                  "of what the tire rolls on: 1 / radius of the drum; 1.1716 for 1.707 m diameter, 0 for a flat road",
                  false, 0.0, &Tire::curvature_of_loss},
};
constexpr std::array plausible{
    PlausibleRange{"curvature", 0.0, 1.7, "definition: drums of 1.2 m (1.67) to 2 m (1.0) diameter, flat road 0",
                   "there is no such drum"},
};

void modify_laws(const ActiveEffect& active, const Tire& tire, const Inputs& /*inputs*/, Laws& laws) {
    laws.loss *= to_drum(1.0, tire.curvature_of_loss(), active[curvature], tire.unloaded_radius);
}

}  // namespace

extern const Effect drum_curvature;
const Effect drum_curvature{
    .id = "drum_curvature",
    .kind = EffectKind::source,
    .equation =
        "SEL' = SEL sqrt((1 + R0 curvature)/(1 + R0 c_law)), curvature = 1/R_drum, c_law = 2/loss_drum_diameter",
    .source = "correction between drums of ISO 28580, taken to a flat road (recalled, not read)",
    .valid = "drums of 1 m radius and more, tires of half their radius and less",
    .meaning =
        "A drum bends the contact more than a flat road: the loss is higher by one factor, 17 to 18 % on a drum of "
        "1.7 m diameter. The factor counts from the road on which the loss was measured: a flat one, or the drum that "
        "loss_drum_diameter of the tire names. On that drum it is 1, on a flat road (curvature 0) below 1. Without "
        "this "
        "effect the tire rolls on the road of its law.",
    .parameters = parameters,
    .plausible = plausible,
    .needs_tire = true,
    .model = PropertyModifier{.modify_laws = modify_laws},
};

}  // namespace tiretherm::physics::effects
