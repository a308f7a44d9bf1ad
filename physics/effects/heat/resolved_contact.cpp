// SPDX-License-Identifier: BSD-3-Clause
// Heat to the road as a mean over revolutions: q = scale h_mean S_cont (T_road - T_surf), h_mean of two half-spaces
// that meet once a revolution (Carslaw & Jaeger 1959, sec. 2.8, 2.9; DLMF 25.11).

#include <algorithm>
#include <array>
#include <cmath>

#include "physics/contact/across_tread.hpp"
#include "physics/contact/contact_in_revolutions.hpp"
#include "physics/contact/heated_road.hpp"
#include "physics/contact/rolling_contact.hpp"
#include "physics/contact/tread_effusivity.hpp"
#include "physics/spread.hpp"

namespace tiretherm::physics {
namespace effects {

namespace {

using rolling_contact::scale;
enum : std::size_t { profile };

constexpr std::array tables{contact_profile};
constexpr std::array<std::string_view, 1> may_read{"inflation_pressure"};
constexpr std::array<std::string_view, 1> patches{"outside"};

/// Coefficients: the conductance at each effusivity [W/K], and the first of them times the road's temperature [W].
constexpr std::size_t with_road = most_effusivities;

void place(const PlacementContext& context, ActiveEffect& active) {
    place_contact(context, active, active.tables[profile]);
    place_effusivities(context, rolling_contact::effusivity_of_road(active), active);
}

void evaluate_coefficients(const ActiveEffect& active, const OperatingPoint& point, std::span<double> out) {
    const Inputs& in = point.inputs;
    std::ranges::fill(out, 0.0);
    for (std::size_t i = 0; i < active.effusivities.size(); ++i) {
        const std::optional<ContactInRevolutions> contact =
            contact_in_revolutions(active, active.effusivities[i], point.tire, in);
        out[i] = contact ? active[scale] * contact->mean_conductance() * point.tire.contact_area(in) : 0.0;
    }
    out[with_road] = out[0] * in.road_temperature;
    note_across_tread(point.laws, out[0], out);
}

void add_terms(const EvaluationState& m, Terms& terms) {
    std::array<double, most_effusivities> G{};
    std::ranges::copy(m.coefficients.first(most_effusivities), G.begin());
    if (G[0] == 0.0) {
        return;
    }
    // Along a logged series both are averages: this is the road that the conductance saw.
    const double T_road = m.coefficients[with_road] / G[0];
    const AcrossTread across(m, G[0], FollowsPressure::by_root);
    for (std::size_t i = 0; i < m.active.nodes.size(); ++i) {
        const EffusivityInterpolation tread(m, m.active.nodes[i]);
        const double weight = across.weight(i);
        exchange_with_road(m, i, tread.value(G) * weight, T_road, tread.slope(G) * weight, terms);
    }
}

}  // namespace
}  // namespace effects

std::optional<ContactInRevolutions> contact_in_revolutions(const ActiveEffect& active, double effusivity,
                                                           const Tire& tire, const Inputs& in) {
    if (!tire.touches(in.vertical_load) || in.speed == 0.0) {
        return std::nullopt;
    }
    const double speed = std::abs(in.speed);
    return ContactInRevolutions(rolling_contact::half_spaces(active, effusivity), tire.contact_length(in) / speed,
                                1.0 / tire.revolutions(speed, tire.reference_load(in)));
}

double kept_heat(const ActiveEffect& active, double effusivity, SlidingHeat enters, const OperatingPoint& point) {
    const std::optional<ContactInRevolutions> contact =
        contact_in_revolutions(active, effusivity, point.tire, point.inputs);
    return contact ? std::max(0.0, 1.0 - rolling_contact::scale_of(active) * contact->road_share(enters)) : 1.0;
}

namespace effects {

extern const Effect resolved_contact;
const Effect resolved_contact{
    .id = "resolved_contact",
    .kind = EffectKind::loss,
    .equation =
        "q = scale h_mean(l/V, revolution) S_cont (T_road - T_surf), h_mean of two half-spaces joined by "
        "interface_h, of which the tread's comes back once a revolution; and the road's share of the heat of sliding",
    .source =
        "Carslaw & Jaeger 1959, sec. 2.8 and 2.9, summed over the revolutions (DLMF 25.11); interface: Miller, NASA TN "
        "D-8161, 1976 (quoted by others, a lower limit); "
        "asphalt concrete 1.2 W/mK, 2300 kg/m3, 900 J/kgK (quoted)",
    .valid =
        "l/V below 0.3 of a revolution, penetration far below the tread's thickness: from some 5 km/h on; a dry road "
        "of which the tire meets fresh places",
    .meaning =
        "Heat to the road as a rolling tread gives it: each place meets fresh road for l/V in every revolution, of "
        "which T_surf is the mean. Of the heat of sliding that enters the tread in the contact it takes a share back "
        "before the contact ends. The tread's effusivity is that of its own k(T) and c(T) at the surface. 76 W/K at 4 "
        "kN and 100 km/h, where the lumped Hc gives 5; nothing at rest. Sensors "
        "of the kinds surface_at_entry and surface_at_exit read the flash. A case that switches it on switches "
        "road_contact off.",
    .parameters = rolling_contact::parameters,
    .plausible = rolling_contact::plausible,
    .tables = tables,
    .reads = rolling_contact::reads,
    .may_read = may_read,
    .instead_of = "road_contact",
    .needs_tire = true,
    .patches = patches,
    .model =
        HeatEffect{
            .n_coefficients = with_road + 1 + across_coefficients,
            .field = FieldOf::pressure,
            .place = place,
            .evaluate_coefficients = evaluate_coefficients,
            .add_terms = add_terms,
        },
};

}  // namespace effects
}  // namespace tiretherm::physics
