// SPDX-License-Identifier: BSD-3-Clause
// Lumped gas between inner liner and rim: C dT_gas/dt = liner (T_liner - T_gas) - rim (T_gas - T_rim). The conductances
// are constants, see the estimate in this file, or films of natural convection in the turning gas.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "mesh/index.hpp"
#include "physics/spread.hpp"
#include "physics/tire_laws/cavity_film.hpp"

namespace tiretherm::physics::effects {

namespace {

enum : std::size_t { liner, rim, capacity_of_gas, nusselt, stable };
enum : std::size_t { film };
enum : int { constant, buoyancy };

// 28 l of air at 2.3 bar above the atmosphere and 293 K weigh 0.11 kg, 75 J/K at constant volume. A film of 15 W/m2K on
// 0.6 m2 of liner makes 9 W/K, on 0.27 m2 of rim 4 W/K.
constexpr std::array parameters{
    ParameterSpec{"liner", "W K-1", 9.0, 0.0, 1e4, "conductance from the inner liner to the gas; assumed", false, 0.0},
    ParameterSpec{"rim", "W K-1", 4.0, 0.0, 1e4, "conductance from the gas to the rim; assumed", false, 0.0},
    ParameterSpec{"capacity", "J K-1", 70.0, 1.0, 1e5, "heat capacity of the gas at constant volume"},
    ParameterSpec{"nusselt", "1", 0.15, 0.0, 10.0, "buoyancy: Nu / Ra^(1/3) of each film; 0.13 to 0.17"},
    ParameterSpec{
        "stable", "1", 0.25, 0.0, 1.0,
        "buoyancy: share of the film where the gas is warmer than the liner or cooler than the rim, which the "
        "rotation keeps apart; 0.27 Ra^0.25 over 0.15 Ra^(1/3) at Ra = 1e10"},
};
constexpr std::array<std::string_view, 2> films{"constant", "buoyancy"};
constexpr std::array<std::string_view, 2> turning{"speed", "vertical_load"};
constexpr std::array choices{Choice{
    "film", films,
    "liner and rim at every speed, or natural convection in the field of the rotation on the liner and on a rim as "
    "wide as the tire",
    turning}};
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
constexpr std::array<std::string_view, 3> may_read{"speed", "vertical_load", "inflation_pressure"};
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

enum : std::size_t { air, of_liner, of_rim };  // K; W/(m2 K^(4/3)) and W/K^(4/3)

void evaluate_coefficients(const ActiveEffect& active, const OperatingPoint& point, std::span<double> out) {
    std::ranges::fill(out, 0.0);
    out[air] = point.inputs.air_temperature;
    if (active.choices[film] == buoyancy) {
        const Tire& tire = point.tire;
        const CavityFilm cavity{.nusselt = active[nusselt]};
        const double edge = tire.unloaded_radius - tire.section_height;  // of the rim
        out[of_liner] = cavity.at_one_kelvin(tire, point.inputs, tire.unloaded_radius - tire.tread_thickness);
        out[of_rim] = cavity.at_one_kelvin(tire, point.inputs, edge) * 2.0 * std::numbers::pi * edge * tire.width;
    }
}

struct Conductance {
    double G;        ///< W/K
    double dG_drop;  ///< W/K2, its derivative with `above`
};

/// @param at_one_kelvin W/K^(4/3)  @param above K, outer wall above gas or gas above rim: of that sign it is unstable
Conductance film_at(const ActiveEffect& active, double at_one_kelvin, double above) {
    constexpr double least = 0.01;  // K: below it the film is that of this difference, so that its slope stays finite
    const double share = above >= 0.0 ? 1.0 : active[stable];
    const double G = share * at_one_kelvin * std::cbrt(std::max(std::abs(above), least));
    return {.G = G, .dG_drop = std::abs(above) > least ? G / (3.0 * above) : 0.0};
}

void add_terms(const EvaluationState& m, Terms& terms) {
    const double area = coupling_area(m.mesh, m.active);
    const int gas = m.active.lumped_nodes.front();
    const double T_gas = m.temperature[at(gas)];
    const int to_rim = m.active.nodes.front();
    const bool by_buoyancy = m.active.choices[film] == buoyancy;
    for (const int index : m.active.coupling_faces) {
        const mesh::Face& face = m.mesh.faces[at(index)];
        if (by_buoyancy) {
            const bool gas_is_b = face.b == gas;
            const double above = m.temperature[at(gas_is_b ? face.a : face.b)] - T_gas;
            const Conductance wall = film_at(m.active, m.coefficients[of_liner] * face.area, above);
            const double slope = gas_is_b ? wall.dG_drop : -wall.dG_drop;
            terms.conduct(index, wall.G, slope, -slope);
        } else {
            terms.conduct(index, m.active[liner] * face.area / area);
        }
    }
    if (!by_buoyancy && to_rim >= 0) {
        terms.conduct(to_rim, m.active[rim]);
    } else if (!by_buoyancy) {
        terms.exchange(gas, m.active[rim], m.coefficients[air]);
    } else if (to_rim >= 0) {
        const mesh::Face& face = m.mesh.faces[at(to_rim)];
        const bool gas_is_a = face.a == gas;
        const Conductance wall =
            film_at(m.active, m.coefficients[of_rim], T_gas - m.temperature[at(gas_is_a ? face.b : face.a)]);
        const double slope = gas_is_a ? wall.dG_drop : -wall.dG_drop;
        terms.conduct(to_rim, wall.G, slope, -slope);
    } else {
        const Conductance wall = film_at(m.active, m.coefficients[of_rim], T_gas - m.coefficients[air]);
        terms.exchange(gas, wall.G, m.coefficients[air], wall.dG_drop);
    }
}

}  // namespace

extern const Effect inner_gas;
const Effect inner_gas{
    .id = "inner_gas",
    .kind = EffectKind::loss,
    .equation =
        "C dT_gas/dt = liner (T_liner - T_gas) - rim (T_gas - T_rim); the tire loses liner (T_liner - T_gas); of "
        "buoyancy: "
        "h = nusselt k Ra^(1/3) in w^2 r, on liner and rim",
    .source =
        "lumped gas, ideal and at constant volume; the constants are assumed, this file; buoyancy: McAdams 1954 and "
        "Globe & Dropkin, J. Heat Transfer 81, 1959, 24 (recalled)",
    .valid =
        "a gas that is mixed by the rolling, of one temperature; the constants are of a car tire at road speeds, to be "
        "fitted; buoyancy: Ra^(1/3) to 1e11, a tire's goes to 1e12; no mixing by the contact",
    .meaning =
        "Heat that crosses the cavity from the inner liner to the rim through the gas, a node of its own. The rim "
        "stands "
        "at the air's temperature, or is the node of rim_conduction where that is on. With film = \"buoyancy\" liner "
        "and rim do "
        "not count: the films follow speed, pressure and temperatures, 52 W/(m2 K) at 100 km/h, 220 kPa and 10 K "
        "between "
        "liner and gas, 8 at rest.",
    .parameters = parameters,
    .plausible = plausible,
    .trials = trials,
    .choices = choices,
    .reads = reads,
    .may_read = may_read,
    .patches = patches,
    .model =
        HeatEffect{
            .n_coefficients = 3,
            .extend = extend,
            .capacity = capacity,
            .place = place,
            .evaluate_coefficients = evaluate_coefficients,
            .add_terms = add_terms,
        },
};

}  // namespace tiretherm::physics::effects
