// SPDX-License-Identifier: BSD-3-Clause
// Heat transfer that a user writes in a case: q = conductance s(t) (T_surroundings(t) - T), s any logged signal that is
// not negative.

#include <array>

#include "physics/user_effect_place.hpp"

namespace tiretherm::physics::effects {

namespace {

enum : std::size_t { conductance };
enum : std::size_t { signal, surroundings };

constexpr std::array parameters{
    ParameterSpec{"conductance", "W K-1", 0.0, 0.0, 1e9, "at a signal of 1", false, 0.0},
};
constexpr std::array plausible{
    PlausibleRange{"conductance", 0.0, 1e9, "definition: per unit of the user's own signal, of which nothing is known",
                   "only the user can judge it"},
};
constexpr std::array tables{
    Table{"course", "s", "1", "the signal against the time since the run's start, held beyond its ends"},
    Table{"surroundings", "s", "K", "their temperature against the same time; without it the air's"},
};
constexpr std::array<std::string_view, 1> may_read{"air_temperature"};

void evaluate_coefficients(const ActiveEffect& active, const OperatingPoint& point, std::span<double> out) {
    const double t = point.inputs.time;
    out[0] = active.tables[signal] ? active[conductance] * active.tables[signal]->value(t) : 0.0;
    out[1] =
        out[0] * (active.tables[surroundings] ? active.tables[surroundings]->value(t) : point.inputs.air_temperature);
}

void add_terms(const EvaluationState& m, Terms& terms) {
    const double G = m.coefficients[0];
    if (G == 0.0) {
        return;
    }
    for (std::size_t i = 0; i < m.active.nodes.size(); ++i) {
        terms.exchange(m.active.nodes[i], G * m.active.weights[i], m.coefficients[1] / G);
    }
}

}  // namespace

extern const Effect user_heat_transfer;
const Effect user_heat_transfer{
    .id = "own_exchange",
    .kind = EffectKind::loss,
    .equation = "q = conductance s(t) (T_surroundings(t) - T), s the signal that it follows",
    .source = "definition: what the user, or a diagnosis, found",
    .valid = "what its user knows of it",
    .meaning =
        "An exchange of heat of the user's own, written [[exchange]] in a case: of named parts of the mesh with the "
        "air "
        "or with a logged temperature, following any logged signal that is not negative. Cells share it by heat "
        "capacity, surfaces by area.",
    .parameters = parameters,
    .plausible = plausible,
    .tables = tables,
    .may_read = may_read,
    .invalid_on_mesh = user_effect_invalid_on_mesh,
    .model =
        HeatEffect{
            .n_coefficients = 2,
            .place = place_user_effect,
            .evaluate_coefficients = evaluate_coefficients,
            .add_terms = add_terms,
        },
};

}  // namespace tiretherm::physics::effects
