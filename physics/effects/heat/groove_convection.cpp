// SPDX-License-Identifier: BSD-3-Clause
// Forced convection from the walls of the grooves: q = area_share eta h_forced (S_tot - S_cont) (T_air - T_surf), eta =
// tanh(mL)/(mL) (straight fin, Incropera & DeWitt; thesis (32), (35)).

#include <array>
#include <cmath>

#include "physics/convection.hpp"
#include "physics/effect.hpp"

namespace tiretherm::physics::effects {

namespace {

enum : std::size_t { area_share, depth, block_width, block_conductivity };

constexpr std::array parameters{
    ParameterSpec{"area_share", "1", 0.25, 0.0, 3.0,
                  "area of the grooves' walls over that of the tread; 0.1 to 0.4, assumed", false, 0.0},
    ParameterSpec{"depth", "m", 0.008, 1e-4, 0.1, "depth of the grooves"},
    ParameterSpec{"block_width", "m", 0.020, 1e-4, 0.5, "width of the blocks between them"},
    ParameterSpec{"block_conductivity", "W m-1 K-1", 0.29, 1e-3, 100.0, "conductivity of the blocks"},
};
constexpr std::array plausible{
    PlausibleRange{"area_share", 0.0, 0.6, "treads of cars add 10 to 40 % of area; assumed",
                   "grooves have no such area: the film itself is off (lambda_h)"},
};
constexpr std::array<std::string_view, 3> reads{"speed", "vertical_load", "air_temperature"};
constexpr std::array<std::string_view, 1> patches{"outside"};

/// Keeps the numbers of air_convection's forced law in the order of ForcedConvection.
void place(const PlacementContext& context, ActiveEffect& active) {
    const ForcedConvection law = forced_convection(context);
    active.weights = {law.coefficient, law.exponent, law.air_conductivity, law.air_viscosity};
}

/// A block is a fin that is cooled on both sides: efficiency tanh(mL)/(mL) with m^2 = 2 h/(k width).
double efficiency(const ActiveEffect& active, double h) {
    const double mL = active[depth] * std::sqrt(2.0 * h / (active[block_conductivity] * active[block_width]));
    return mL > 0.0 ? std::tanh(mL) / mL : 1.0;
}

void evaluate_coefficients(const ActiveEffect& active, const OperatingPoint& point, std::span<double> out) {
    const ForcedConvection forced{.coefficient = active.weights[0],
                                  .exponent = active.weights[1],
                                  .air_conductivity = active.weights[2],
                                  .air_viscosity = active.weights[3]};
    const double h = point.laws.forced * forced(point.tire, point.inputs.speed);
    const double area = point.tire.outer_area() - point.tire.contact_area(point.inputs);
    out[0] = active[area_share] * efficiency(active, h) * h * area;
    out[1] = out[0] * point.inputs.air_temperature;
}

void add_terms(const EvaluationState& m, Terms& terms) {
    const double G = m.coefficients[0];
    if (G <= 0.0) {
        return;
    }
    const double T_air = m.coefficients[1] / G;
    double area = 0.0;
    for (const int patch : m.active.patches) {
        area += m.mesh.patches[static_cast<std::size_t>(patch)].area();
    }
    for (const int patch : m.active.patches) {
        for (const mesh::PatchFace& face : m.mesh.patches[static_cast<std::size_t>(patch)].faces) {
            terms.exchange(face.node, G * face.area / area, T_air);
        }
    }
}

}  // namespace

extern const Effect groove_convection;
const Effect groove_convection{
    .id = "groove_convection",
    .kind = EffectKind::loss,
    .equation = "q = area_share eta h_forced (S_tot - S_cont) (T_air - T_surf), eta = tanh(mL)/(mL), m^2 = 2 h/(k b)",
    .source = "straight fin: Incropera & DeWitt, Fundamentals of Heat and Mass Transfer, ch. 3; thesis (32), (35)",
    .valid =
        "straight blocks whose tops are as warm as the tread's surface, film and conductivity even over them; the "
        "sizes are those of a car tire's blocks, assumed",
    .meaning =
        "The walls of the grooves, which the thesis leaves out: more area for the forced part of the convection, less "
        "effective as the blocks cool towards their tops. Nothing at rest.",
    .parameters = parameters,
    .plausible = plausible,
    .reads = reads,
    .needs_tire = true,
    .patches = patches,
    .model =
        HeatEffect{
            .n_coefficients = 2,
            .place = place,
            .evaluate_coefficients = evaluate_coefficients,
            .add_terms = add_terms,
        },
};

}  // namespace tiretherm::physics::effects
