// SPDX-License-Identifier: BSD-3-Clause
// Heat to the road, revolution by revolution: q = scale h(t) S (T_road - T_surf) while in contact, t since entry, h of
// two half-spaces of which the cells are one (Carslaw & Jaeger 1959, sec. 2.8, 2.9).

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "physics/contact/across_tread.hpp"
#include "physics/contact/heated_road.hpp"
#include "physics/contact/rolling_contact.hpp"
#include "physics/contact/travelling.hpp"
#include "physics/contact/tread_effusivity.hpp"
#include "physics/spread.hpp"

namespace tiretherm::physics {
namespace effects {

namespace {

enum : std::size_t { profile };

/// Coefficients: the road's temperature [K], then what each sector exchanges, per weight [W/K], at each effusivity.
enum : std::size_t { road, first_sector };

std::size_t first_of(int sector) { return first_sector + static_cast<std::size_t>(sector) * most_effusivities; }

constexpr std::array tables{contact_profile};
constexpr std::array<std::string_view, 4> may_read{"wheel_angle", "inflation_pressure", "slip_ratio", "slip_speed"};
constexpr std::array<std::string_view, 1> patches{"outside"};

/// Gauss and Legendre's rule of six points on (0, 1). Abramowitz & Stegun 1964, table 25.4.
struct GaussPoint {
    double place;
    double weight;
};
constexpr std::array rule{
    GaussPoint{0.033765242898423986, 0.085662246189585173}, GaussPoint{0.169395306766867743, 0.180380786524069304},
    GaussPoint{0.380690406958401546, 0.233956967286345524}, GaussPoint{0.619309593041598454, 0.233956967286345524},
    GaussPoint{0.830604693233132257, 0.180380786524069304}, GaussPoint{0.966234757101576014, 0.085662246189585173}};

void place(const PlacementContext& context, ActiveEffect& active) {
    place_contact(context, active, active.tables[profile]);
    active.groups = sectors_of(context.mesh, active.nodes);
    place_effusivities(context, rolling_contact::effusivity_of_road(active), active);
}

/// What follows the time since entry, integrated over the angle of a part of the contact in the root of the time, in which
/// it is smooth. @param of s since entry  @returns its unit, times rad
template <class Function>
double integral(const TravellingContact& contact, const TravellingContact::Part& part, const Function& of) {
    const double from = std::sqrt(part.from);
    const double width = std::sqrt(part.to) - from;
    double sum = 0.0;
    for (const GaussPoint& point : rule) {
        const double root = from + point.place * width;
        sum += point.weight * 2.0 * root * of(root * root / contact.angular_speed());
    }
    return sum * width;
}

void evaluate_coefficients(const ActiveEffect& active, const OperatingPoint& point, std::span<double> out) {
    const Inputs& in = point.inputs;
    std::ranges::fill(out, 0.0);
    out[road] = in.road_temperature;
    note_across_tread(point.laws, 1.0, out);
    const TravellingContact contact(point.tire, in);
    if (!contact.touches()) {
        return;
    }
    // The contact's area is that share of the tread's strip that its length is of the circumference.
    const double strip = active[rolling_contact::scale] * point.tire.contact_area(in) / contact.length();
    const int sectors = active.groups.empty() ? 1 : active.groups.back() + 1;
    for (int s = 0; s < sectors; ++s) {
        const TravellingContact::Part part = contact.part(s, sectors);
        for (std::size_t e = 0; e < active.effusivities.size() && part.inside; ++e) {
            const ContactOfHalfSpaces surfaces = rolling_contact::half_spaces(active, active.effusivities[e]);
            out[first_of(s) + e] =
                sectors == 1
                    ? strip * 2.0 * std::numbers::pi * surfaces.conductance_at(part.from / contact.angular_speed())
                    : strip * sectors *
                          integral(contact, part, [&](double since) { return surfaces.conductance_at(since); });
        }
    }
}

void add_terms(const EvaluationState& m, Terms& terms) {
    const AcrossTread across(m, 1.0, FollowsPressure::by_root);
    for (std::size_t i = 0; i < m.active.nodes.size(); ++i) {
        std::array<double, most_effusivities> G{};
        std::ranges::copy(m.coefficients.subspan(first_of(m.active.groups[i]), most_effusivities), G.begin());
        if (G[0] > 0.0) {
            const EffusivityInterpolation tread(m, m.active.nodes[i]);
            const double weight = across.weight(i);
            exchange_with_road(m, i, tread.value(G) * weight, m.coefficients[road], tread.slope(G) * weight, terms);
        }
    }
}

}  // namespace
}  // namespace effects

double kept_heat(const ActiveEffect& active, double effusivity, SlidingHeat enters, const TravellingContact& contact,
                 int sector, int sectors) {
    const ContactOfHalfSpaces surfaces = rolling_contact::half_spaces(active, effusivity);
    const TravellingContact::Part part = contact.part(sector, sectors);
    const double kept = sectors == 1 ? surfaces.kept_heat_at(part.from / contact.angular_speed(), enters)
                                     : effects::integral(contact, part, [&](double since) {
                                           return surfaces.kept_heat_at(since, enters);
                                       }) / (part.to - part.from);
    return 1.0 + rolling_contact::scale_of(active) * (kept - 1.0);
}

namespace effects {

extern const Effect travelling_contact;
const Effect travelling_contact{
    .id = "travelling_contact",
    .kind = EffectKind::loss,
    .equation =
        "q = scale h(t) S (T_road - T_surf) while in contact, t since entry, h of two half-spaces joined by "
        "interface_h "
        "of which the cells are one",
    .source = "Carslaw & Jaeger 1959, sec. 2.8 and 2.9; numbers as of resolved_contact",
    .valid = "as resolved_contact; outer cells below 0.02 mm at 100 km/h",
    .meaning =
        "Heat to the road, revolution by revolution: every sector of a ring, or a column of layers or a section as the "
        "rubber at one angle, meets fresh road once a turn. Needs outer cells of some hundredths of a millimetre and "
        "steps of milliseconds; resolved_contact gives the same mean without them. A case that switches it on "
        "switches road_contact off.",
    .parameters = rolling_contact::parameters,
    .plausible = rolling_contact::plausible,
    .tables = tables,
    .reads = rolling_contact::reads,
    .may_read = may_read,
    .instead_of = "road_contact",
    .needs_tire = true,
    .needs_grid = true,
    .patches = patches,
    .model =
        HeatEffect{
            .travels = true,
            .n_coefficients = 1 + most_effusivities + across_coefficients,
            .frame_coefficients = most_effusivities * (most_sectors - 1),
            .place = place,
            .evaluate_coefficients = evaluate_coefficients,
            .add_terms = add_terms,
        },
};

}  // namespace effects
}  // namespace tiretherm::physics
