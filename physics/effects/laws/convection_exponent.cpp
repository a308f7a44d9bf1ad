// SPDX-License-Identifier: BSD-3-Clause
// Property modifier: another exponent of forced convection, h_forced = h_forced(pivot) (V/pivot)^exponent; 0.571 in
// thesis (32), 0.805 above Re = 40 000 in Hilpert 1933.

#include <array>
#include <cmath>

#include "physics/convection.hpp"
#include "physics/effect.hpp"

namespace tiretherm::physics::effects {

namespace {

enum : std::size_t { exponent, pivot };

constexpr std::array parameters{
    ParameterSpec{"exponent", "1", 0.805, 0.0, 2.0,
                  "exponent of the speed in the forced part; 0.571 in the thesis, 0.805 of a cylinder at Re > 40 000",
                  false, 0.571},
    ParameterSpec{"pivot", "m s-1", 25.0, 1.0, 100.0, "speed at which both exponents give the same coefficient"},
};
constexpr std::array confounded{
    ConfoundedGroup{{"convection_exponent", "groove_convection", "air_convection.lambda_h"},
                    "speed steps over a wide range at constant load: an exponent changes sign at one speed, area and "
                    "level do not; standing still shows none of them"}};
constexpr std::array plausible{
    PlausibleRange{"exponent", 0.5, 0.85,
                   "laminar 0.5 to turbulent 0.8 (boundary layers), Hilpert's cylinder 0.805 at Re > 40 000",
                   "no flow over a body follows such a power of the speed"},
};
constexpr std::array<std::string_view, 1> reads{"speed"};

/// Keeps the exponent that air_convection has, as its only weight.
void place(const PlacementContext& context, ActiveEffect& active) {
    active.weights = {forced_convection(context).exponent};
}

/// h'(V) = h(pivot) (V/pivot)^n' = h(V) (V/pivot)^(n' - n). At rest h(V) is nothing and stays so.
void modify_laws(const ActiveEffect& active, const Tire& /*tire*/, const Inputs& inputs, Laws& laws) {
    if (const double ratio = std::abs(inputs.speed) / active[pivot]; ratio > 0.0) {
        laws.forced *= std::pow(ratio, active[exponent] - active.weights.front());
    }
}

}  // namespace

extern const Effect convection_exponent;
const Effect convection_exponent{
    .id = "convection_exponent",
    .kind = EffectKind::loss,
    .equation = "h_forced = h_forced(pivot) (V/pivot)^exponent; floor and exponential of (33) as they are",
    .source = "thesis (32) has 0.571; Hilpert, Forsch. Ing.-Wes. 4, 1933, has 0.805 above Re = 40 000",
    .valid = "Re of 1e4 to 1e6; exponents of 0.5 to 0.81 are known",
    .meaning =
        "Another growth of forced convection with speed, equal to the thesis's law at the pivot: less heat lost "
        "below it and more above, or the other way round. Coasting shows it too.",
    .parameters = parameters,
    .plausible = plausible,
    .confounded = confounded,
    .reads = reads,
    .needs_tire = true,
    .model =
        PropertyModifier{
            .place = place,
            .modify_laws = modify_laws,
        },
};

}  // namespace tiretherm::physics::effects
