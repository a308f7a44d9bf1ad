// SPDX-License-Identifier: BSD-3-Clause
// Heat to the road through a contact smeared over the circumference: q = lambda_Hc Hc S_cont(Fz) (T_road - T_surf)
// (thesis (31), (35)).

#include <array>

#include "physics/contact/across_tread.hpp"
#include "physics/contact/heated_road.hpp"
#include "physics/spread.hpp"

namespace tiretherm::physics::effects {

namespace {

enum : std::size_t { Hc, lambda_Hc };
enum : std::size_t { profile };

constexpr std::array parameters{
    ParameterSpec{"Hc", "W m-2 K-1", 500.0, 0.0, 1e6,
                  "coefficient of a tire that does not roll, over the contact area"},
    ParameterSpec{"lambda_Hc", "1", 1.0, 0.0, 10.0, "scale of the coefficient"},
};
constexpr std::string_view above =
    "the averaged contact sheds less than the tread does: use a rolling contact, resolved_contact in the place of "
    "road_contact";
constexpr std::array plausible{
    PlausibleRange{
        "Hc", 250.0, 1500.0,
        "thesis 500 W/(m2 K) for a tire that does not roll; a rolling contact sheds two to three times as much",
        "fresh tread meets fresh road in each revolution: use resolved_contact", SensorKind::any, above},
    PlausibleRange{"lambda_Hc", 0.5, 3.0,
                   "a rolling contact sheds two to three times as much as the thesis's averaged one",
                   "fresh tread meets fresh road in each revolution: use resolved_contact", SensorKind::any, above},
};
constexpr std::array tables{contact_profile};
constexpr std::array<std::string_view, 2> reads{"vertical_load", "road_temperature"};
constexpr std::array<std::string_view, 1> may_read{"inflation_pressure"};
constexpr std::array<std::string_view, 1> patches{"outside"};

void place(const PlacementContext& context, ActiveEffect& active) {
    place_contact(context, active, active.tables[profile]);
}

void evaluate_coefficients(const ActiveEffect& active, const OperatingPoint& point, std::span<double> out) {
    out[0] = active[lambda_Hc] * active[Hc] * point.tire.contact_area(point.inputs);
    out[1] = out[0] * point.inputs.road_temperature;
    note_across_tread(point.laws, out[0], out);
}

void add_terms(const EvaluationState& m, Terms& terms) {
    if (const double G = m.coefficients[0]; G > 0.0) {
        const AcrossTread across(m, G);
        for (std::size_t i = 0; i < m.active.nodes.size(); ++i) {
            exchange_with_road(m, i, G * across.weight(i), m.coefficients[1] / G, 0.0, terms);
        }
    }
}

}  // namespace

extern const Effect road_contact;
const Effect road_contact{
    .id = "road_contact",
    .kind = EffectKind::loss,
    .on = true,
    .equation = "q = lambda_Hc Hc S_cont(Fz) (T_road - T_surf)",
    .source = "thesis (31)(35)",
    .valid =
        "the loads and the one tire of the thesis; an Hc of a tire that does not roll underestimates a rolling contact "
        "by 10 to 20 times",
    .meaning =
        "Heat to the road through a contact that is smeared over the circumference: Hc is a lumped share of "
        "area, not the coefficient inside a rolling contact.",
    .parameters = parameters,
    .plausible = plausible,
    .tables = tables,
    .reads = reads,
    .may_read = may_read,
    .needs_tire = true,
    .patches = patches,
    .model =
        HeatEffect{
            .n_coefficients = 2 + across_coefficients,
            .field = FieldOf::pressure,
            .place = place,
            .evaluate_coefficients = evaluate_coefficients,
            .add_terms = add_terms,
        },
};

}  // namespace tiretherm::physics::effects
