// SPDX-License-Identifier: BSD-3-Clause
// Heat through the beads into a lumped rim: q = bead (T_rim - T), C dT_rim/dt = bead (T - T_rim) + cooling (T_air -
// T_rim). The numbers are assumed.

#include <array>

#include "physics/spread.hpp"

namespace tiretherm::physics::effects {

namespace {

enum : std::size_t { bead, capacity_of_rim, cooling };

constexpr std::array parameters{
    ParameterSpec{"bead", "W K-1", 1.0, 0.0, 1e4, "conductance from the tire through both beads to the rim; assumed",
                  false, 0.0},
    ParameterSpec{"capacity", "J K-1", 7200.0, 1.0, 1e6, "heat capacity of the rim; 8 kg of aluminium, assumed"},
    ParameterSpec{"cooling", "W K-1", 10.0, 0.0, 1e4,
                  "conductance from the rim to the air; 0.5 m2 at 20 W/m2K, assumed"},
};
constexpr std::array<std::string_view, 1> reads{"air_temperature"};
constexpr std::array<std::string_view, 2> patches{"beads", "inside"};

void extend(mesh::Mesh& mesh, ActiveEffect& active) {
    const int rim = mesh.add_lumped_node("rim");
    active.lumped_nodes = {rim};
    active.coupling_faces = couple_patches(mesh, active, rim);
    couple_gas_and_rim(mesh);
}

double capacity(const ActiveEffect& active, std::size_t /*index*/) { return active[capacity_of_rim]; }

void evaluate_coefficients(const ActiveEffect& /*active*/, const OperatingPoint& point, std::span<double> out) {
    out[0] = point.inputs.air_temperature;
}

void add_terms(const EvaluationState& m, Terms& terms) {
    const double area = coupling_area(m.mesh, m.active);
    for (const int face : m.active.coupling_faces) {
        terms.conduct(face, m.active[bead] * m.mesh.faces[static_cast<std::size_t>(face)].area / area);
    }
    terms.exchange(m.active.lumped_nodes.front(), m.active[cooling], m.coefficients[0]);
}

}  // namespace

extern const Effect rim_conduction;
const Effect rim_conduction{
    .id = "rim_conduction",
    .kind = Kind::loss,
    .equation = "q = bead (T_rim - T); C dT_rim/dt = bead (T - T_rim) + cooling (T_air - T_rim)",
    .source = "lumped rim; numbers assumed, their order from rim and brake paths of Meccanica 2021 (abstract only)",
    .meaning =
        "Heat that leaves through the beads into the rim, which is a node of its own and slow. Where inner_gas is on, "
        "the "
        "gas meets this rim. On a mesh without beads it is taken from the inside, on two nodes from the bulk.",
    .parameters = parameters,
    .reads = reads,
    .patches = patches,
    .one_patch = true,
    .model =
        HeatEffect{
            .n_coefficients = 1,
            .extend = extend,
            .capacity = capacity,
            .evaluate_coefficients = evaluate_coefficients,
            .add_terms = add_terms,
        },
};

}  // namespace tiretherm::physics::effects
