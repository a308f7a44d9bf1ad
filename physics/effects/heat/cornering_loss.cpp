// SPDX-License-Identifier: BSD-3-Clause
// Heat of lateral deformation in the bulk: q = coefficient Fy^2 V, coefficient = tan(delta)/cornering stiffness,
// derived in this file. The thesis leaves it out (chapter V).

#include <array>
#include <cmath>

#include "physics/spread.hpp"

namespace tiretherm::physics::effects {

namespace {

enum : std::size_t { coefficient };

// A contact that is pushed sideways by Fy stores Fy^2/(2 C) per contact length, C = Ky/l its lateral stiffness, and
// loses the share 2 tan(delta) of it on each of the V/l lengths a second: tan(delta) Fy^2 V/Ky. With tan(delta) 0.2 and
// Ky 80 kN/rad that is 2.5e-6 Fy^2 V, 270 W at 2 kN and 100 km/h.
constexpr std::array parameters{
    ParameterSpec{"coefficient", "N-1", 2.5e-6, 0.0, 1e-2, "tan(delta) / cornering stiffness; estimated", false, 0.0},
};
constexpr std::array plausible{
    PlausibleRange{"coefficient", 0.0, 1e-5,
                   "tan delta of 0.1 to 0.4 over a cornering stiffness of 50 to 150 kN/rad: up to 8e-6 1/N",
                   "lateral bending makes no more heat than that: friction power or slip is off"},
};
constexpr std::array<std::string_view, 2> reads{"speed", "lateral_force"};

void place(const PlacementContext& context, ActiveEffect& active) { spread_over_bulk(context, active); }

void evaluate_coefficients(const ActiveEffect& active, const OperatingPoint& point, std::span<double> out) {
    const double Fy = point.inputs.lateral_force;
    out[0] = active[coefficient] * Fy * Fy * std::abs(rolling_speed(point.inputs));
}

void add_terms(const EvaluationState& m, Terms& terms) {
    for (std::size_t i = 0; i < m.active.nodes.size(); ++i) {
        terms.heat(m.active.nodes[i], m.coefficients[0] * m.active.weights[i]);
    }
}

}  // namespace

extern const Effect cornering_loss;
const Effect cornering_loss{
    .id = "cornering_loss",
    .kind = EffectKind::source,
    .equation = "q = coefficient Fy^2 V",
    .source = "energy of lateral deformation times the loss tangent, this file; the thesis leaves it out (chapter V)",
    .valid =
        "slip angles of some degrees, where the force still follows the deflection; its one number is an order of "
        "magnitude, to be fitted",
    .meaning =
        "Work of deforming the tire sideways at every pass through the contact: heat in the bulk as soon as there is a "
        "lateral force, before anything slides. Part of what rolling resistance pays for.",
    .parameters = parameters,
    .plausible = plausible,
    .reads = reads,
    .model =
        HeatEffect{
            .by_deformation = true,
            .n_coefficients = 1,
            .place = place,
            .evaluate_coefficients = evaluate_coefficients,
            .add_terms = add_terms,
        },
};

}  // namespace tiretherm::physics::effects
