// SPDX-License-Identifier: BSD-3-Clause
// Corrects road_contact for a coefficient that grows with pressure as p^0.95 (Cooper, Mikic & Yovanovich 1969): q =
// lambda_Hc Hc S_cont ((Fz/reference)^exponent - 1) (T_road - T_surf).

#include <array>
#include <cmath>

#include "physics/contact/across_tread.hpp"
#include "physics/contact/heated_road.hpp"
#include "physics/spread.hpp"

namespace tiretherm::physics::effects {

namespace {

enum : std::size_t { exponent, reference };

constexpr std::array parameters{
    ParameterSpec{"exponent", "1", 0.95, 0.0, 3.0, "of the pressure", false, 0.0},
    ParameterSpec{"reference", "N", 4500.0, 1.0, 1e6, "load at which Hc holds as it is"},
};
constexpr std::array plausible{
    PlausibleRange{"exponent", 0.0, 1.0, "contact conductance of rough solids: 0.95 of the pressure; recalled",
                   "conductance grows no faster than the pressure"},
};
constexpr std::array<std::string_view, 2> reads{"vertical_load", "road_temperature"};
constexpr std::array<std::string_view, 1> patches{"outside"};

/// Where road_contact acts and with its coefficient: weights in W/(m2 K), none when it is off.
void place(const PlacementContext& context, ActiveEffect& active) {
    const ActiveEffect* road = context.find("road_contact");
    if (road == nullptr) {
        active.nodes.clear();
        active.weights.clear();
        active.skew.clear();
        active.share_of_drum = 0.0;
        return;
    }
    const auto number = [&](std::string_view key) {
        return (*road)[static_cast<std::size_t>(find_parameter(*road->effect, key))];
    };
    active.patches = road->patches;
    active.field = road->field;
    place_contact(context, active, road->tables[static_cast<std::size_t>(find_table(*road->effect, "profile"))]);
    for (double& weight : active.weights) {
        weight *= number("lambda_Hc") * number("Hc");
    }
}

// (35) with A = 0 makes the mean pressure 1/B whatever the load; here it is taken to follow the load, p/p0 = Fz/Fz0.
void evaluate_coefficients(const ActiveEffect& active, const OperatingPoint& point, std::span<double> out) {
    const double Fz = point.inputs.vertical_load;
    const double area = point.tire.contact_area(point.inputs);
    out[0] = area > 0.0 ? area * (std::pow(Fz / active[reference], active[exponent]) - 1.0) : 0.0;
    out[1] = out[0] * point.inputs.road_temperature;
    note_across_tread(point.laws, 1.0, out);
}

/// A correction takes as well as gives: heat, not a conductance, which could not be negative.
void add_terms(const EvaluationState& m, Terms& terms) {
    const AcrossTread across(m, 1.0);
    for (std::size_t i = 0; i < m.active.nodes.size(); ++i) {
        const int node = m.active.nodes[i];
        const double weight = across.weight(i);
        const double G = weight * m.coefficients[0];
        const double T = m.temperature[static_cast<std::size_t>(node)];
        const double share = m.active.share_of_drum;
        terms.heat(node, (1.0 - share) * (weight * m.coefficients[1] - G * T), (share - 1.0) * G);
        if (share > 0.0) {
            const double drop = m.temperature[static_cast<std::size_t>(drum_of(m))] - T;
            take_from_drum(m, i, share * G * drop, -share * G, share * G, terms);
        }
    }
}

}  // namespace

extern const Effect contact_pressure_conductance;
const Effect contact_pressure_conductance{
    .id = "contact_pressure_conductance",
    .kind = EffectKind::loss,
    .equation = "q = lambda_Hc Hc S_cont ((Fz/reference)^exponent - 1) (T_road - T_surf)",
    .source = "conductance of a contact ~ p^0.95: Cooper, Mikic & Yovanovich, Int. J. Heat Mass Transfer 12, 1969",
    .valid =
        "rough surfaces pressed together elastically or plastically, p/H below 0.01; rubber on asphalt lies at its "
        "edge",
    .meaning =
        "Corrects road_contact for a coefficient that grows with the pressure, taken as proportional to the load. "
        "Negative below the reference load, nothing without road_contact or when surface and road are equal.",
    .parameters = parameters,
    .plausible = plausible,
    .reads = reads,
    .needs_tire = true,
    .patches = patches,
    .model =
        HeatEffect{
            .n_coefficients = 2 + across_coefficients,
            .place = place,
            .evaluate_coefficients = evaluate_coefficients,
            .add_terms = add_terms,
        },
};

}  // namespace tiretherm::physics::effects
