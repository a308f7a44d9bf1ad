// SPDX-License-Identifier: BSD-3-Clause
// Property modifier: wind from the side adds to the speed of the air about the tread, V_air = (V^2 + speed^2)^(1/2).

#include <array>
#include <cmath>

#include "physics/convection.hpp"
#include "physics/effect.hpp"

namespace tiretherm::physics::effects {

namespace {

enum : std::size_t { across };

constexpr std::array parameters{
    ParameterSpec{"speed", "m s-1", 0.0, 0.0, 100.0, "of the wind across the direction of travel", false, 0.0},
};
constexpr std::array confounded{
    ConfoundedGroup{{"wind", "convection_exponent", "air_convection.lambda_h"},
                    "an anemometer; or slow laps beside fast ones: wind counts where the tire is slow"}};
/// Its square counts: the slope at nothing is nothing.
constexpr std::array trials{TrialValues{.parameter = "speed", .trials = {5.0, 10.0, 15.0}}};
constexpr std::array plausible{
    PlausibleRange{"speed", 0.0, 15.0, "Beaufort 0 to 7; a test is stopped before", "no test is driven in such a wind"},
};
constexpr std::array<std::string_view, 1> reads{"speed"};

/// Keeps the exponent that air_convection has, as its only weight.
void place(const PlacementContext& context, ActiveEffect& active) {
    active.weights = {forced_convection(context).exponent};
}

/// h(V_air) = h(V) (V_air/V)^n. At rest h(V) is nothing and stays so: what wind does to a tire that stands is not in the law.
void modify_laws(const ActiveEffect& active, const Tire& /*tire*/, const Inputs& inputs, Laws& laws) {
    if (const double V = std::abs(inputs.speed); V > 0.0) {
        laws.forced *= std::pow(std::hypot(V, active[across]) / V, active.weights.front());
    }
}

}  // namespace

extern const Effect wind;
const Effect wind{
    .id = "wind",
    .kind = EffectKind::loss,
    .equation = "h_forced = h_forced(V) ((V^2 + speed^2)/V^2)^(n/2), n the exponent of air_convection",
    .source = "definition: the air's speed past the tire; head and tail wind cancel round a lap to first order",
    .valid = "wind across the direction of travel, even over the run; the tire rolls",
    .meaning =
        "Wind from the side, which no log has: the tread meets air that is faster than the tire rolls, most of all "
        "where "
        "it is slow. It acts on the forced convection of the tread alone. Without a speed it does nothing.",
    .parameters = parameters,
    .plausible = plausible,
    .confounded = confounded,
    .trials = trials,
    .reads = reads,
    .needs_tire = true,
    .model =
        PropertyModifier{
            .place = place,
            .modify_laws = modify_laws,
        },
};

}  // namespace tiretherm::physics::effects
