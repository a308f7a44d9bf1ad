// SPDX-License-Identifier: BSD-3-Clause
// Property modifier: tan delta' = tan delta exp(slope (T_bulk - reference)), an error in the temperature dependence of
// thesis (49).

#include <array>
#include <cmath>

#include "physics/effect.hpp"

namespace tiretherm::physics::effects {

namespace {

enum : std::size_t { slope, reference };

constexpr std::array parameters{
    ParameterSpec{"slope", "K-1", 0.0, -0.1, 0.1, "error of d ln(tan delta)/dT", false, 0.0},
    ParameterSpec{"reference", "K", 333.15, 200.0, 500.0,
                  "bulk temperature at which the loss tangent is left as it is"},
};
constexpr std::array confounded{
    ConfoundedGroup{{"loss_tangent_slope", "loss_frequency_shift"},
                    "drag force, or the same speed at different bulk temperatures: a slope follows the temperature, "
                    "a shift the frequency"}};
constexpr std::array plausible{
    PlausibleRange{"slope", -0.01, 0.01, "thesis: -1.4 % per K; compounds 0 to -2 % per K, recalled",
                   "the loss would rise with temperature, or fall twice as fast as that of any compound"},
};

LossFactor scale_loss(const EvaluationState& m) {
    const int bulk = m.mesh.find_region("bulk");
    const double above = m.region_mean[static_cast<std::size_t>(bulk)] - m.active[reference];
    const double value = std::exp(m.active[slope] * above);
    return {.value = value, .dvalue_dT_mean = m.active[slope] * value, .region = bulk};
}

}  // namespace

extern const Effect loss_tangent_slope;
const Effect loss_tangent_slope{
    .id = "loss_tangent_slope",
    .kind = EffectKind::source,
    .equation = "tan delta' = tan delta exp(slope (T_bulk - reference))",
    .source = "definition; with the constants of thesis (49) d ln(tan delta)/dT is about -1.4 %/K",
    .valid = "some 50 K about the reference; -0.02 to 0.02 1/K",
    .meaning =
        "A compound whose loss falls faster or slower with temperature than its Gaussian says: more heat on one side "
        "of "
        "the reference, less on the other. Follows the bulk's mean also where the loss tangent is local.",
    .parameters = parameters,
    .plausible = plausible,
    .confounded = confounded,
    .needs_tire = true,
    .model = PropertyModifier{.scale_loss = scale_loss},
};

}  // namespace tiretherm::physics::effects
