// SPDX-License-Identifier: BSD-3-Clause
// Heat radiated to surroundings at air temperature: q = eps sigma A (T_air^4 - T_surf^4) (Stefan-Boltzmann law, grey
// surface).

#include <array>

#include "physics/effect.hpp"

namespace tiretherm::physics::effects {

namespace {

enum : std::size_t { emissivity };

constexpr std::array parameters{
    ParameterSpec{"emissivity", "1", 0.95, 0.0, 1.0, "emissivity of rubber, 0.90 to 0.95", false, 0.0},
};
constexpr std::array plausible{
    PlausibleRange{"emissivity", 0.0, 1.0,
                   "definition; rubber 0.85 to 0.98, less where a surface sees warm parts; recalled",
                   "no surface radiates more than a black one"},
};
constexpr std::array<std::string_view, 1> reads{"air_temperature"};
constexpr std::array<std::string_view, 2> patches{"outside", "top"};
constexpr double stefan_boltzmann = 5.670374419e-8;  // W/(m2 K4), CODATA 2018

void evaluate_coefficients(const ActiveEffect& /*active*/, const OperatingPoint& point, std::span<double> out) {
    out[0] = point.inputs.air_temperature;
}

void add_terms(const EvaluationState& m, Terms& terms) {
    const double T_air = m.coefficients[0];
    for (std::size_t p = 0; p < m.active.patches.size(); ++p) {
        const double factor = m.active.on_patch(emissivity, p) * stefan_boltzmann;
        for (const mesh::PatchFace& face : m.mesh.patches[static_cast<std::size_t>(m.active.patches[p])].faces) {
            const double T = m.temperature[static_cast<std::size_t>(face.node)];
            // T_air^4 - T^4 = (T_air - T) (T^2 + T_air^2) (T + T_air)
            const double G = factor * face.area * (T * T + T_air * T_air) * (T + T_air);
            const double dG_dT = factor * face.area * (3.0 * T * T + 2.0 * T * T_air + T_air * T_air);
            terms.exchange(face.node, G, T_air, dG_dT);
        }
    }
}

}  // namespace

extern const Effect radiation;
const Effect radiation{
    .id = "radiation",
    .kind = EffectKind::loss,
    .equation = "q = eps sigma A (T_air^4 - T_surf^4)",
    .source = "Stefan-Boltzmann law, grey surface in large surroundings at air temperature",
    .valid =
        "opaque grey surfaces, emissivity 0.9 to 0.95 for rubber (recalled), in surroundings that are large and as "
        "warm as the air",
    .meaning = "Heat radiated to surroundings at the temperature of the air; counts where convection is weak.",
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
