// SPDX-License-Identifier: BSD-3-Clause
// Heat through the beads into a lumped rim: q = bead (T_rim - T), C dT_rim/dt = bead (T - T_rim) + cooling (T_air -
// T_rim), or cooled by the film of a rotating disk (Cobb & Saunders 1956). The numbers are assumed.

#include <algorithm>
#include <array>

#include "physics/spread.hpp"
#include "physics/tire_laws/disk_film.hpp"

namespace tiretherm::physics::effects {

namespace {

enum : std::size_t { bead, capacity_of_rim, cooling, area_of_rim };

constexpr std::array parameters{
    ParameterSpec{"bead", "W K-1", 1.0, 0.0, 1e4, "conductance from the tire through both beads to the rim; assumed",
                  false, 0.0},
    ParameterSpec{"capacity", "J K-1", 7200.0, 1.0, 1e6, "heat capacity of the rim; 8 kg of aluminium, assumed"},
    ParameterSpec{"cooling", "W K-1", 10.0, 0.0, 1e4,
                  "conductance from the rim to the air; 0.5 m2 at 20 W/m2K, assumed"},
    ParameterSpec{"area", "m2", 0.5, 0.0, 10.0,
                  "rotating_disk: surface of the rim that meets the air; 0.3 m2 for the two faces of a disk of 17 "
                  "inches to 0.8 m2 with spokes, assumed"},
    disk_film::scale,
    disk_film::laminar,
    disk_film::turbulent,
    disk_film::transition,
    disk_film::natural,
};
constexpr std::array plausible{
    PlausibleRange{"bead", 0.0, 5.0, "bead seats of 20 mm width on 10 to 15 mm of rubber, 0.5 to 3 W/K; recalled",
                   "rubber at the beads conducts no more than that: the gas carries heat to the rim, too"},
    PlausibleRange{"cooling", 2.0, 40.0, "0.3 to 0.8 m2 of rim at 5 to 50 W/(m2 K); recalled",
                   "no rim sheds that much or that little, unless a brake heats it"},
    PlausibleRange{"disk_scale", 0.5, 2.0, "half behind a closed wheel house to twice in the travel wind; assumed",
                   "no rim is that far from a rotating disk"},
};
constexpr std::array choices{Choice{disk_film::key, disk_film::films,
                                    "cooling at every speed, or the film of a rotating disk on area",
                                    disk_film::reads}};
constexpr std::array<std::string_view, 1> reads{"air_temperature"};
constexpr std::array<std::string_view, 2> patches{"beads", "inside"};

void extend(mesh::Mesh& mesh, ActiveEffect& active) {
    const int rim = mesh.add_lumped_node("rim");
    active.lumped_nodes = {rim};
    active.coupling_faces = couple_patches(mesh, active, rim);
    couple_gas_and_rim(mesh);
}

double capacity(const ActiveEffect& active, std::size_t /*index*/) { return active[capacity_of_rim]; }

void evaluate_coefficients(const ActiveEffect& active, const OperatingPoint& point, std::span<double> out) {
    std::ranges::fill(out, 0.0);
    out[0] = point.inputs.air_temperature;
    if (disk_film::is_chosen(active)) {
        disk_film::evaluate(active, disk_film::rim_of(point.tire), point, out);
    }
}

void add_terms(const EvaluationState& m, Terms& terms) {
    const double area = coupling_area(m.mesh, m.active);
    for (const int face : m.active.coupling_faces) {
        terms.conduct(face, m.active[bead] * m.mesh.faces[static_cast<std::size_t>(face)].area / area);
    }
    const int rim = m.active.lumped_nodes.front();
    if (disk_film::is_chosen(m.active)) {
        const disk_film::Film film =
            disk_film::at(m.active, m.coefficients, m.temperature[static_cast<std::size_t>(rim)]);
        terms.exchange(rim, m.active[area_of_rim] * film.h, m.coefficients[0], m.active[area_of_rim] * film.dh_dT);
    } else {
        terms.exchange(rim, m.active[cooling], m.coefficients[0]);
    }
}

double reynolds_in_millions(const ActiveEffect& active, const Tire& tire, const Inputs& inputs) {
    return disk_film::reynolds_in_millions(active, disk_film::rim_of(tire), tire, inputs);
}

constexpr std::array compared{ComparedRange{"", 0.0, disk_film::measured_up_to, "measured",
                                            "million (Reynolds number of the disk)", reynolds_in_millions}};

}  // namespace

extern const Effect rim_conduction;
const Effect rim_conduction{
    .id = "rim_conduction",
    .kind = EffectKind::loss,
    .equation =
        "q = bead (T_rim - T); C dT_rim/dt = bead (T - T_rim) + cooling (T_air - T_rim); of a rotating disk: cooling = "
        "disk_scale h_disk area, h_disk as of sidewall_convection over 0 < r < R0 - H",
    .source =
        "lumped rim; numbers assumed, their order from rim and brake paths of Meccanica 2021 (abstract only); rotating "
        "disk: Cobb & Saunders, Proc. R. Soc. A 236, 1956, 343 (recalled)",
    .valid =
        "a rim of one temperature; bead conductance, capacity and cooling are orders of magnitude for a car wheel, to "
        "be fitted; the disk: Re up to 7e5 (recalled), air at the mean of T_rim and T_air",
    .meaning =
        "Heat that leaves through the beads into the rim, which is a node of its own and slow. Where inner_gas is on, "
        "the gas meets this rim. On a mesh without beads it is taken from the inside, on two nodes from the bulk. "
        "With film = \"rotating_disk\" the rim's cooling follows the speed and cooling does not count; it needs a "
        "tire, "
        "its speed and its load. 10 K above the air 0.5 m2 on 17 inches have 2 W/K at rest, 12 W/K at 100 km/h and 29 "
        "W/K at 200 km/h. A smooth disk of that size becomes turbulent at 91 km/h; spokes and a brake do that earlier, "
        "for which transition is lowered, and wind through the wheel is left to disk_scale.",
    .compared = compared,
    .parameters = parameters,
    .plausible = plausible,
    .choices = choices,
    .reads = reads,
    .may_read = disk_film::reads,
    .patches = patches,
    .one_patch = true,
    .model =
        HeatEffect{
            .n_coefficients = disk_film::n_coefficients,
            .extend = extend,
            .capacity = capacity,
            .evaluate_coefficients = evaluate_coefficients,
            .add_terms = add_terms,
        },
};

}  // namespace tiretherm::physics::effects
