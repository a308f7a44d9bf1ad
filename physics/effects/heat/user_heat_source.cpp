// SPDX-License-Identifier: BSD-3-Clause
// Heat source that a user writes in a case: q = watts s(t) in named parts of the mesh, s any logged signal.

#include <array>

#include "physics/user_effect_place.hpp"

namespace tiretherm::physics::effects {

namespace {

enum : std::size_t { watts };
enum : std::size_t { signal };

constexpr std::array parameters{
    ParameterSpec{"watts", "W", 0.0, -1e9, 1e9, "heat at a signal of 1; below 0 it is taken away", false, 0.0},
};
constexpr std::array plausible{
    PlausibleRange{"watts", -1e9, 1e9, "definition: per unit of the user's own signal, of which nothing is known",
                   "only the user can judge it"},
};
constexpr std::array tables{
    Table{"course", "s", "1", "the signal against the time since the run's start, held beyond its ends"},
};

void evaluate_coefficients(const ActiveEffect& active, const OperatingPoint& point, std::span<double> out) {
    out[0] = active.tables[signal] ? active[watts] * active.tables[signal]->value(point.inputs.time) : 0.0;
}

void add_terms(const EvaluationState& m, Terms& terms) {
    if (m.active.law) {
        m.active.law->add_terms(m, terms);
        return;
    }
    for (std::size_t i = 0; i < m.active.nodes.size(); ++i) {
        terms.heat(m.active.nodes[i], m.coefficients[0] * m.active.weights[i]);
    }
}

}  // namespace

extern const Effect user_heat_source;
const Effect user_heat_source{
    .id = "own_source",
    .kind = EffectKind::source,
    .equation = "q = watts s(t), s the signal that it follows",
    .source = "definition: what the user, or a diagnosis, found",
    .valid = "what its user knows of it",
    .meaning =
        "Heat of the user's own, written [[source]] in a case: in named parts of the mesh, following any logged "
        "signal. "
        "Cells share it by heat capacity, surfaces by area. All of it goes into the mesh, also where that is a "
        "quarter.",
    .parameters = parameters,
    .plausible = plausible,
    .tables = tables,
    .invalid_on_mesh = user_effect_invalid_on_mesh,
    .model =
        HeatEffect{
            .n_coefficients = 1,
            .place = place_user_effect,
            .evaluate_coefficients = evaluate_coefficients,
            .add_terms = add_terms,
        },
};

}  // namespace tiretherm::physics::effects
