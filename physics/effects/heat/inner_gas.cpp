// SPDX-License-Identifier: BSD-3-Clause
// Lumped gas between inner liner and rim: C dT_gas/dt = liner (T_liner - T_gas) - rim (T_gas - T_rim). The conductances
// are assumed, see the estimate in this file.

#include <array>

#include "physics/spread.hpp"

namespace tiretherm::physics::effects {

namespace {

enum : std::size_t { liner, rim, capacity_of_gas };

// 28 l of air at 2.3 bar above the atmosphere and 293 K weigh 0.11 kg, 75 J/K at constant volume. A film of 15 W/m2K on
// 0.6 m2 of liner makes 9 W/K, on 0.27 m2 of rim 4 W/K.
constexpr std::array parameters{
    ParameterSpec{"liner", "W K-1", 9.0, 0.0, 1e4, "conductance from the inner liner to the gas; assumed", false, 0.0},
    ParameterSpec{"rim", "W K-1", 4.0, 0.0, 1e4, "conductance from the gas to the rim; assumed", false, 0.0},
    ParameterSpec{"capacity", "J K-1", 70.0, 1.0, 1e5, "heat capacity of the gas at constant volume"},
};
/// A little conductance is slow, much of it is quick: four signatures.
constexpr std::array trials{
    TrialValues{.parameter = "liner", .other = "rim", .factor = 4.0 / 9.0, .trials = {0.3, 1.0, 3.0, 9.0}},
    TrialValues{.parameter = "rim", .left_out = true},
};
constexpr std::array plausible{
    PlausibleRange{"liner", 0.0, 30.0, "films of 10 to 30 W/(m2 K) on 0.6 to 0.9 m2; 9 W/K used by others",
                   "gas takes no more from the liner than that"},
    PlausibleRange{"rim", 0.0, 20.0, "films of 10 to 30 W/(m2 K) on 0.3 to 0.5 m2; 4 W/K used by others",
                   "gas gives no more to the rim than that"},
    PlausibleRange{"capacity", 30.0, 200.0, "definition: 30 to 80 litres at 2 to 4 bar, 0.72 J/(g K)",
                   "the cavity holds no such mass of gas"},
};
constexpr std::array<std::string_view, 1> reads{"air_temperature"};
constexpr std::array<std::string_view, 1> patches{"inside"};

void extend(mesh::Mesh& mesh, ActiveEffect& active) {
    const int gas = mesh.add_lumped_node("gas");
    active.lumped_nodes = {gas};
    active.coupling_faces = couple_patches(mesh, active, gas);
    couple_gas_and_rim(mesh);
}

double capacity(const ActiveEffect& active, std::size_t /*index*/) { return active[capacity_of_gas]; }

/// Keeps the face between gas and rim, whichever of the two effects made it, or -1.
void place(const PlacementContext& context, ActiveEffect& active) {
    active.nodes = {face_between_gas_and_rim(context.mesh)};
}

void evaluate_coefficients(const ActiveEffect& /*active*/, const OperatingPoint& point, std::span<double> out) {
    out[0] = point.inputs.air_temperature;
}

void add_terms(const EvaluationState& m, Terms& terms) {
    const double area = coupling_area(m.mesh, m.active);
    for (const int face : m.active.coupling_faces) {
        terms.conduct(face, m.active[liner] * m.mesh.faces[static_cast<std::size_t>(face)].area / area);
    }
    if (const int to_rim = m.active.nodes.front(); to_rim >= 0) {
        terms.conduct(to_rim, m.active[rim]);
    } else {
        terms.exchange(m.active.lumped_nodes.front(), m.active[rim], m.coefficients[0]);
    }
}

}  // namespace

extern const Effect inner_gas;
const Effect inner_gas{
    .id = "inner_gas",
    .kind = Kind::loss,
    .equation = "C dT_gas/dt = liner (T_liner - T_gas) - rim (T_gas - T_rim); the tire loses liner (T_liner - T_gas)",
    .source = "lumped gas, ideal and at constant volume; the conductances are assumed, this file",
    .valid =
        "a gas that is mixed by the rolling, of one temperature; the conductances are of a car tire at road speeds, to "
        "be fitted",
    .meaning =
        "Heat that crosses the cavity from the inner liner to the rim through the gas, a node of its own. The rim "
        "stands "
        "at the air's temperature, or is the node of rim_conduction where that is on.",
    .parameters = parameters,
    .plausible = plausible,
    .trials = trials,
    .reads = reads,
    .patches = patches,
    .model =
        HeatEffect{
            .n_coefficients = 1,
            .extend = extend,
            .capacity = capacity,
            .place = place,
            .evaluate_coefficients = evaluate_coefficients,
            .add_terms = add_terms,
        },
};

}  // namespace tiretherm::physics::effects
