// SPDX-License-Identifier: BSD-3-Clause
// A drum or a belt that the tire heats: C dT/dt = share q_road + cooling (V / 100 km/h)^(2/3) (T_air - T), a node that the
// contacts exchange with in the place of road_temperature.

#include <algorithm>
#include <array>
#include <cmath>

#include "physics/spread.hpp"

namespace tiretherm::physics::effects {

namespace {

enum : std::size_t { share, capacity_of_drum, cooling, still };

// A drum of 1.707 m whose steel shell is 0.5 m wide and 20 mm thick: 2 pi 0.844 * 0.5 * 0.02 m3 * 7850 kg/m3 * 480 J/(kg K)
// = 2.0e5 J/K, 416 kg. Becker (Int. J. Heat Mass Transfer 6, 1963, 1053, recalled) has Nu = 0.133 (V D/nu)^(2/3) Pr^(1/3)
// for a cylinder that turns in still air: 37 W/(m2 K) at 100 km/h (V D/nu = 3.2e6, beyond the 1e5 that were measured),
// 100 W/K on the 2.7 m2 outside and, assumed, half of that inside, where the air turns along. At rest 5 W/(m2 K) of natural
// convection and radiation on 5.4 m2.
//
// The belt of a flat track: 3.5 m of steel, 0.5 m wide and 0.5 mm thick, 6.9 kg and 3.3e3 J/K, runs over two drums of 0.7 m
// with shells of 10 mm, 173 kg and 8.3e4 J/K. Half of each drum lies against the belt, 1.1 m2 of pressed steel: all three
// have one temperature within some kelvins, 8.6e4 J/K. A plate of 1 m in the wind of 100 km/h has 0.037 Re^0.8 Pr^(1/3) k/L
// = 85 W/(m2 K), on 1.75 m2 outside 150 W/K, on 0.7 m2 of free inner face 60 W/K. All lengths are assumed.
constexpr double reference_speed = 100.0 / 3.6;  // m/s

constexpr std::array parameters{
    ParameterSpec{"share", "1", 1.0, 0.0, 1.0,
                  "of what the road takes, the part that heats the drum; the rest leaves at road_temperature", false,
                  0.0},
    ParameterSpec{"capacity", "J K-1", 2.0e5, 10.0, 1e8,
                  "heat capacity of the drum: 480 J/(kg K) times the mass of steel; 2e5 for the shell of a drum of "
                  "1.707 m, 9e4 for a steel belt with its two drums, 3e3 for the belt alone; assumed"},
    ParameterSpec{"cooling", "W K-1", 150.0, 0.0, 1e5,
                  "conductance from the drum to the air at 100 km/h; 150 for a drum of 1.707 m, 210 for a steel belt; "
                  "estimated"},
    ParameterSpec{"still", "W K-1", 25.0, 0.0, 1e4, "the least conductance to the air, at rest; 5 W/(m2 K) on 5 m2"},
};
constexpr std::array plausible{
    PlausibleRange{"share", 0.0, 1.0, "definition: none of the road's heat to all of it",
                   "the road takes no more than it takes"},
    PlausibleRange{"capacity", 2e3, 2e6, "a bare steel belt of 5 kg to a cast wheel of 4 t, 480 J/(kg K); recalled",
                   "no drum is that light or that heavy"},
    PlausibleRange{"cooling", 30.0, 600.0, "10 to 100 W/(m2 K) on 3 to 6 m2; recalled",
                   "no air takes that little or that much: a belt may run on a bearing of water"},
};
constexpr std::array confounded{ConfoundedGroup{
    {"drum_heating", "road_temperature_drift", "resolved_contact"},
    "a thermometer on the drum's surface; or the same test on the drum that the test before has warmed"}};
constexpr std::array trials{TrialValues{.parameter = "share", .trials = {1.0}}};
constexpr std::array<std::string_view, 2> reads{"speed", "air_temperature"};
constexpr std::array<std::string_view, 1> patches{"outside"};

void extend(mesh::Mesh& mesh, ActiveEffect& active) {
    const int drum = mesh.add_lumped_node("drum");
    active.lumped_nodes = {drum};
    active.coupling_faces = couple_patches(mesh, active, drum);
}

double capacity(const ActiveEffect& active, std::size_t /*index*/) { return active[capacity_of_drum]; }

void evaluate_coefficients(const ActiveEffect& active, const OperatingPoint& point, std::span<double> out) {
    const double by_speed = std::pow(std::abs(point.inputs.speed) / reference_speed, 2.0 / 3.0);
    out[0] = std::max(active[still], active[cooling] * by_speed);
    out[1] = out[0] * point.inputs.air_temperature;
}

void add_terms(const EvaluationState& m, Terms& terms) {
    if (const double G = m.coefficients[0]; G > 0.0) {
        terms.exchange(m.active.lumped_nodes.front(), G, m.coefficients[1] / G);
    }
}

}  // namespace

extern const Effect drum_heating;
const Effect drum_heating{
    .id = "drum_heating",
    .kind = EffectKind::loss,
    .equation =
        "C dT_drum/dt = share q_road + max(still, cooling (|V| / 100 km/h)^(2/3)) (T_air - T_drum); the contact "
        "exchanges with road_temperature + share (T_drum - road_temperature)",
    .source =
        "lumped steel; cooling: Becker, Int. J. Heat Mass Transfer 6, 1963, 1053 (recalled), taken beyond its range; "
        "masses and areas are assumed, this file",
    .valid =
        "a dry drum or belt of one temperature, to which its surface returns between two contacts, in the air of a "
        "hall; "
        "what wet_road takes leaves at road_temperature",
    .meaning =
        "A drum or a steel belt that the tire itself heats, a node of its own (drum): it takes what road_contact, "
        "resolved_contact or travelling_contact give to the road, and the road's part of the heat of sliding, and "
        "loses it to the air. It starts at the first road_temperature, or at drum of [initial]; later values of "
        "road_temperature count only for the share that it leaves. A contact that is resolved should have "
        "road_conductivity and road_capacity of steel (50 W/(m K), 3.8e6 J/(m3 K)), or of the abrasive paper where the "
        "surface has one: in the milliseconds of a contact heat enters some hundredths of a millimetre of it. A "
        "diagnosis tries it beside drum_curvature, or where a case lists it.",
    .parameters = parameters,
    .plausible = plausible,
    .confounded = confounded,
    .trials = trials,
    .reads = reads,
    .tried_beside = "drum_curvature",
    .needs_tire = true,
    .patches = patches,
    .model =
        HeatEffect{
            .n_coefficients = 2,
            .extend = extend,
            .capacity = capacity,
            .starts_at = "road_temperature",
            .evaluate_coefficients = evaluate_coefficients,
            .add_terms = add_terms,
        },
};

}  // namespace tiretherm::physics::effects
