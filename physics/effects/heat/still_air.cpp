// SPDX-License-Identifier: BSD-3-Clause
// Heat from named patches to air at rest: q = h A (T_air - T_surf) (Newton's law of cooling; thesis III.1.1).

#include <array>

#include "physics/effect.hpp"

namespace tiretherm::physics::effects {

namespace {

enum : std::size_t { h };

constexpr std::array parameters{
    ParameterSpec{"h", "W m-2 K-1", 10.0, 0.0, 1e6, "coefficient to the air"},
};
constexpr std::array plausible{
    PlausibleRange{"h", 3.0, 25.0, "free air 5 to 10 W/(m2 K) with radiation of 6 to 11 W/(m2 K) beside it",
                   "a draught, or another loss of heat"},
};
constexpr std::array<std::string_view, 1> reads{"air_temperature"};
constexpr std::array<std::string_view, 2> patches{"top", "bottom"};

void evaluate_coefficients(const ActiveEffect& /*active*/, const OperatingPoint& point, std::span<double> out) {
    out[0] = point.inputs.air_temperature;
}

void add_terms(const EvaluationState& m, Terms& terms) {
    for (std::size_t p = 0; p < m.active.patches.size(); ++p) {
        const double coefficient = m.active.on_patch(h, p);
        for (const mesh::PatchFace& face : m.mesh.patches[static_cast<std::size_t>(m.active.patches[p])].faces) {
            terms.exchange(face.node, coefficient * face.area, m.coefficients[0]);
        }
    }
}

}  // namespace

extern const Effect still_air;
const Effect still_air{
    .id = "still_air",
    .kind = EffectKind::loss,
    .equation = "q = h A (T_air - T_surf)",
    .source = "Newton's law of cooling; thesis III.1.1 (specimen at rest)",
    .valid = "a film that does not depend on temperature; 5 to 15 W/m2K for rest",
    .meaning = "Heat to air at rest from named patches, each with its own coefficient if wanted.",
    .parameters = parameters,
    .plausible = plausible,
    .reads = reads,
    .patches = patches,
    .model =
        HeatEffect{
            .n_coefficients = 1,
            .evaluate_coefficients = evaluate_coefficients,
            .add_terms = add_terms,
        },
};

}  // namespace tiretherm::physics::effects
