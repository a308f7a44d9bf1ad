// SPDX-License-Identifier: BSD-3-Clause
// Heat of sliding in the contact: q = partition (lambda_x |Fx v_sx| + lambda_y |Fy| |V| tan|alpha|), v_sx = V - R_R
// Omega (thesis (31)); even around the tire, by a field, or in a travelling contact. Where the contact with the road is
// resolved, the road takes its share of it back in the contact, which is booked there.

#include <algorithm>
#include <array>
#include <cmath>

#include "physics/contact/contact_in_revolutions.hpp"
#include "physics/contact/travelling.hpp"
#include "physics/spread.hpp"

namespace tiretherm::physics::effects {

namespace {

enum : std::size_t { partition, lambda_x, lambda_y };
enum : std::size_t { longitudinal, lateral, around };
enum : std::size_t { profile };
/// Coefficients: what the road takes back [W]; then the heat that stays, of each frame or of each sector.
enum : std::size_t { taken_back, first_heat };

constexpr std::array parameters{
    ParameterSpec{"partition", "1", 0.6, 0.0, 1.0, "share of the friction power that enters the tire"},
    ParameterSpec{"lambda_x", "1", 1.0, 0.0, 10.0, "scale of the longitudinal friction power"},
    ParameterSpec{"lambda_y", "1", 1.0, 0.0, 10.0, "scale of the lateral friction power"},
};
constexpr std::array<std::string_view, 2> on_off{"on", "off"};
constexpr std::array<std::string_view, 2> ways_around{"evenly", "in_contact"};
constexpr std::array choices{
    Choice{"longitudinal", on_off, "whether longitudinal sliding makes heat (a switch of the thesis)"},
    Choice{"lateral", on_off, "whether lateral sliding makes heat (a switch of the thesis)"},
    Choice{around_key, ways_around, "evenly around the tire, or in the contact as it goes round (travelling_contact)"},
};
constexpr std::array tables{contact_profile};
constexpr std::array<std::string_view, 1> reads{"speed"};
constexpr std::array<std::string_view, 6> may_read{"vertical_load", "slip_angle",         "slip_ratio",
                                                   "lateral_force", "longitudinal_force", "wheel_angle"};
constexpr std::array<std::string_view, 1> patches{"outside"};

void place(const PlacementContext& context, ActiveEffect& active) {
    spread_over_patches(context, active, active.tables[profile]);
    active.groups = active.choices[around] == in_contact ? sectors_of(context.mesh, active.nodes) : std::vector<int>{};
    active.road = active.groups.empty() ? -1 : context.index_of("travelling_contact");
    active.road = active.road < 0 ? context.index_of("resolved_contact") : active.road;
}

/// Power of sliding in the contact by the thesis's law. W
double sliding_power(const ActiveEffect& active, const OperatingPoint& point) {
    const Inputs& in = point.inputs;
    if (!point.tire.touches(in.vertical_load)) {
        return 0.0;
    }
    // Sliding speeds of the contact: v_sx = V - R_R Omega = -V slip_ratio, v_sy = V tan(alpha).
    const double along = std::abs(in.longitudinal_force * in.speed * in.slip_ratio);
    const double across = std::abs(in.lateral_force * in.speed) * std::tan(std::abs(in.slip_angle));
    return (active.choices[longitudinal] == 0 ? active[lambda_x] * along : 0.0) +
           (active.choices[lateral] == 0 ? active[lambda_y] * across : 0.0);
}

void evaluate_coefficients(const ActiveEffect& active, const OperatingPoint& point, std::span<double> out) {
    const std::span<double> heat = out.subspan(first_heat);
    // A law may take the share beyond 1, where it says that a term is missing; it never turns heat into cold.
    double factor = active[partition] * std::max(0.0, point.laws.partition);
    std::ranges::fill(out, 0.0);
    heat[0] = 1.0;
    if (active.field && !active.field->watts.empty()) {
        active.field->watts_at(point.inputs.time, heat);
    } else {
        factor *= sliding_power(active, point);
        if (active.field) {
            active.field->shares_at(point.inputs.time, heat);
        }
    }
    const ActiveEffect* road = active.road >= 0 ? &point.effects[static_cast<std::size_t>(active.road)] : nullptr;
    const bool road_travels = road != nullptr && travels(*road);
    const double kept_in_the_mean = factor > 0.0 && road != nullptr && !road_travels ? kept_heat(*road, point) : 1.0;
    if (!active.groups.empty()) {
        const TravellingContact contact(point.tire, point.inputs);
        const int sectors = active.groups.back() + 1;
        for (int s = 0; s < sectors; ++s) {
            const double all = factor * concentration(contact, s, sectors);
            const double kept = all > 0.0 && road_travels ? kept_heat(*road, contact, s, sectors) : kept_in_the_mean;
            heat[static_cast<std::size_t>(s)] = kept * all;
            out[taken_back] += (1.0 - kept) * all / sectors;
        }
        return;
    }
    for (double& watts : heat) {
        out[taken_back] += (1.0 - kept_in_the_mean) * factor * watts;
        watts *= kept_in_the_mean * factor;
    }
}

/// The heat that stays in the tread; what the road has taken back is booked as made here and taken there.
void add_terms(const EvaluationState& m, Terms& terms) {
    const std::span<const double> heat = m.coefficients.subspan(first_heat);
    if (m.active.road >= 0) {
        terms.rebook(static_cast<std::size_t>(m.active.road), -m.coefficients[taken_back]);
    }
    if (!m.active.groups.empty()) {
        for (std::size_t i = 0; i < m.active.nodes.size(); ++i) {
            if (const double watts = heat[static_cast<std::size_t>(m.active.groups[i])]; watts != 0.0) {
                terms.heat(m.active.nodes[i], watts * m.active.weights[i]);
            }
        }
        return;
    }
    for (std::size_t k = 0; k < heat.size(); ++k) {
        const std::vector<double>& weights = m.active.field ? m.active.field->weights[k] : m.active.weights;
        for (std::size_t i = 0; i < m.active.nodes.size() && heat[k] != 0.0; ++i) {
            terms.heat(m.active.nodes[i], heat[k] * weights[i]);
        }
        if (!m.active.field || k + 1 == m.active.field->frames()) {
            return;
        }
    }
}

}  // namespace

extern const Effect sliding_friction;
const Effect sliding_friction{
    .id = "sliding_friction",
    .kind = Kind::source,
    .on = true,
    .equation = "q = partition (lambda_x |Fx v_sx| + lambda_y |Fy| |V| tan|alpha|) >= 0, v_sx = V - R_R Omega",
    .source = "thesis (31)",
    .meaning =
        "Heat of sliding in the contact, into the outer surface. Either sign convention of Fy and the slip "
        "angle gives the same heat; signals that are not given count as zero. Beside "
        "resolved_contact, and beside travelling_contact with around = \"in_contact\", the road takes a share of the "
        "heat "
        "back in the contact; the heat budget counts that share with the contact's effect. "
        "A field of a structural code places it by friction power, or gives its watts; around = \"in_contact\" lets it "
        "go round with travelling_contact.",
    .parameters = parameters,
    .choices = choices,
    .tables = tables,
    .reads = reads,
    .may_read = may_read,
    .needs_tire = true,
    .patches = patches,
    .model =
        HeatEffect{
            .n_coefficients = 2,
            .field = FieldOf::friction,
            .frame_coefficients = most_frames - 1,
            .place = place,
            .evaluate_coefficients = evaluate_coefficients,
            .add_terms = add_terms,
        },
};

}  // namespace tiretherm::physics::effects
