// SPDX-License-Identifier: BSD-3-Clause
// Heat from the sidewalls to the air: q = (conductance + h A) (T_air - T) (Newton's law of cooling). The thesis's tire
// has no sidewalls (erratum E16).

#include <array>

#include "physics/spread.hpp"

namespace tiretherm::physics::effects {

namespace {

enum : std::size_t { conductance, h };

constexpr std::array parameters{
    ParameterSpec{"conductance", "W K-1", 15.0, 0.0, 1e4,
                  "of both sidewalls together; 0.3 to 0.4 m2 at 30 to 60 W/m2K make 10 to 25 W/K", false, 0.0},
    ParameterSpec{"h", "W m-2 K-1", 0.0, 0.0, 1e4, "coefficient on the patch's area, in addition", false, 0.0},
};
constexpr std::array<std::string_view, 1> reads{"air_temperature"};
constexpr std::array<std::string_view, 2> patches{"sidewalls", "inside"};

void place(const PlacementContext& context, ActiveEffect& active) { spread_over_patches(context, active); }

void evaluate_coefficients(const ActiveEffect& /*active*/, const OperatingPoint& point, std::span<double> out) {
    out[0] = point.inputs.air_temperature;
}

void add_terms(const EvaluationState& m, Terms& terms) {
    double area = 0.0;
    for (const int patch : m.active.patches) {
        area += m.mesh.patches[static_cast<std::size_t>(patch)].area();
    }
    const double G = m.active[conductance] + m.active[h] * area;
    for (std::size_t i = 0; i < m.active.nodes.size(); ++i) {
        terms.exchange(m.active.nodes[i], G * m.active.weights[i], m.coefficients[0]);
    }
}

}  // namespace

extern const Effect sidewall_convection;
const Effect sidewall_convection{
    .id = "sidewall_convection",
    .kind = Kind::loss,
    .equation = "q = (conductance + h A) (T_air - T)",
    .source =
        "Newton's law of cooling; the level from a rotating disk, Nu = 0.0195 Re^0.8 in turbulent flow (recalled), at "
        "100 km/h",
    .meaning =
        "Heat that leaves through the sidewalls, which the thesis's tire does not have (erratum E16). Spread by area "
        "over the sidewalls; on a mesh without them it is taken from the inside, on two nodes from the bulk.",
    .parameters = parameters,
    .reads = reads,
    .patches = patches,
    .one_patch = true,
    .model =
        HeatEffect{
            .n_coefficients = 1,
            .place = place,
            .evaluate_coefficients = evaluate_coefficients,
            .add_terms = add_terms,
        },
};

}  // namespace tiretherm::physics::effects
