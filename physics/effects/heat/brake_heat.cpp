// SPDX-License-Identifier: BSD-3-Clause
// Heat of the brake that reaches the tire through hub and rim: q = conductance (T_brake - T_rim). The number is assumed, see the
// estimate in this file.

#include <array>

#include "physics/spread.hpp"

namespace tiretherm::physics::effects {

namespace {

enum : std::size_t { conductance };

// Bell and hub of 10 cm2 of steel (45 W/mK) over 5 cm conduct 1 W/K; air and radiation between disc and rim add as much again.
constexpr std::array parameters{
    ParameterSpec{"conductance", "W K-1", 1.0, 0.0, 1e3, "from the brake disc to the rim; estimated", false, 0.0},
};
constexpr std::array plausible{
    PlausibleRange{
        "conductance", 0.0, 10.0,
        "5 to 20 cm2 of steel over some cm of bell and hub, as much again by air and radiation; estimated",
        "hub and rim do not conduct that much: heat of sliding or of the loss is missing on the braked axle"},
};
constexpr std::array<std::string_view, 1> reads{"brake_temperature"};
constexpr std::array<std::string_view, 2> patches{"beads", "inside"};

/// The rim's node where there is one, otherwise the faces of the beads, or of the inside.
void place(const PlacementContext& context, ActiveEffect& active) {
    if (const int rim = context.mesh.find_lumped_node("rim"); rim >= 0) {
        active.nodes = {rim};
        active.weights = {1.0};
    } else {
        spread_over_patches(context, active);
    }
}

void evaluate_coefficients(const ActiveEffect& active, const OperatingPoint& point, std::span<double> out) {
    out[0] = active[conductance];
    out[1] = active[conductance] * point.inputs.brake_temperature;
}

}  // namespace

extern const Effect brake_heat;
const Effect brake_heat{
    .id = "brake_heat",
    .kind = EffectKind::source,
    .equation = "q = conductance (T_brake - T_rim); without a rim T of the beads, of the inside or of the bulk",
    .source =
        "conduction through bell and hub, this file; that brakes heat rim and tire: rim and brake paths of Meccanica "
        "2021 (abstract only)",
    .valid = "a disc and a rim of one temperature each; its one number is an order of magnitude, to be fitted",
    .meaning =
        "Heat of the brake that reaches the tire through hub and rim: into the rim of rim_conduction where that is on, "
        "otherwise through the beads, on a mesh without them into the inside, on two nodes into the bulk. T_brake is "
        "that of the disc as logged, or as [vehicle] computes it from the power of braking. Part of what looks like a "
        "film of air that is too weak on the front axle.",
    .parameters = parameters,
    .plausible = plausible,
    .reads = reads,
    .patches = patches,
    .one_patch = true,
    .model =
        HeatEffect{
            .n_coefficients = 2,
            .place = place,
            .evaluate_coefficients = evaluate_coefficients,
            .add_terms = exchange_by_weights,
        },
};

}  // namespace tiretherm::physics::effects
