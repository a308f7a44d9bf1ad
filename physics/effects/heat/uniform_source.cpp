// SPDX-License-Identifier: BSD-3-Clause
// The same heat per volume in every cell, q = power_density V_cell, for problems with an exact solution.

#include <array>

#include "physics/effect.hpp"

namespace tiretherm::physics::effects {

namespace {

enum : std::size_t { power_density };

constexpr std::array parameters{
    ParameterSpec{"power_density", "W m-3", 0.0, 0.0, 1e12, "heat made in every cell, per volume"},
};

void add_terms(const EvaluationState& m, Terms& terms) {
    for (int cell = 0; cell < m.mesh.n_cells; ++cell) {
        terms.heat(cell, m.active[power_density] * m.mesh.volume[static_cast<std::size_t>(cell)]);
    }
}

}  // namespace

extern const Effect uniform_source;
const Effect uniform_source{
    .id = "uniform_source",
    .kind = EffectKind::source,
    .equation = "q = power_density V_cell",
    .source = "definition; used by reference problems",
    .valid = "everywhere: a definition",
    .meaning = "The same heat per volume everywhere, for problems with an exact solution.",
    .parameters = parameters,
    .model = HeatEffect{.add_terms = add_terms},
};

}  // namespace tiretherm::physics::effects
