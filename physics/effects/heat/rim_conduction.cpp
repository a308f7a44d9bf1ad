#include <array>

#include "physics/spread.hpp"

namespace tiretherm::physics::effects {

namespace {

enum : std::size_t { bead, capacity_of_rim, cooling };

constexpr std::array parameters{
    Parameter{"bead", "W K-1", 1.0, 0.0, 1e4, "conductance from the tire through both beads to the rim; assumed", false,
              0.0},
    Parameter{"capacity", "J K-1", 7200.0, 1.0, 1e6, "heat capacity of the rim; 8 kg of aluminium, assumed"},
    Parameter{"cooling", "W K-1", 10.0, 0.0, 1e4, "conductance from the rim to the air; 0.5 m2 at 20 W/m2K, assumed"},
};
constexpr std::array<std::string_view, 1> reads{"air_temperature"};
constexpr std::array<std::string_view, 2> patches{"beads", "inside"};

void extend(mesh::Mesh& mesh, ActiveEffect& active) {
    const int rim = mesh.append("rim");
    active.appended = {rim};
    active.joints = join_patches(mesh, active, rim);
    join_gas_and_rim(mesh);
}

double capacity(const ActiveEffect& active, std::size_t /*index*/) { return active[capacity_of_rim]; }

void drive(const ActiveEffect& /*active*/, const Driving& driving, std::span<double> out) {
    out[0] = driving.inputs.air_temperature;
}

void speak(const Moment& m, Terms& terms) {
    const double area = joined_area(m.mesh, m.active);
    for (const int joint : m.active.joints) {
        terms.conduct(joint, m.active[bead] * m.mesh.faces[static_cast<std::size_t>(joint)].area / area);
    }
    terms.exchange(m.active.appended.front(), m.active[cooling], m.intensities[0]);
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
    .n_intensities = 1,
    .extend = extend,
    .capacity = capacity,
    .drive = drive,
    .speak = speak,
};

}  // namespace tiretherm::physics::effects
