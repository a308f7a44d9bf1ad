// SPDX-License-Identifier: BSD-3-Clause
// Heat of sliding in the contact: q = partition (lambda_x |Fx v_sx| + lambda_y |Fy| |V| tan|alpha|), v_sx = V - R_R
// Omega (thesis (31)); even around the tire, by a field, or in a travelling contact. The partition is a number, or follows
// the effusivities of tread and road (Charron 1943). Where the contact with the road is resolved, what the road takes of it
// back in the contact is booked there.

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>

#include "physics/contact/across_tread.hpp"
#include "physics/contact/contact_in_revolutions.hpp"
#include "physics/contact/heat_of_sliding.hpp"
#include "physics/contact/heated_road.hpp"
#include "physics/contact/rolling_contact.hpp"
#include "physics/contact/travelling.hpp"
#include "physics/contact/tread_effusivity.hpp"
#include "physics/spread.hpp"

namespace tiretherm::physics {
namespace effects {

namespace {

enum : std::size_t { partition, lambda_x, lambda_y, road_conductivity, road_capacity };
enum : std::size_t { longitudinal, lateral, around, shared };
enum : std::size_t { profile };
enum : int { by_number, charm };
/// Coefficients, a block for each effusivity: what the road takes back [W]; all that is made, where a drum takes what the
/// tread does not [W]; then the heat that stays, of each frame or of each sector. Behind the blocks skew and crown, times what
/// the first gives.
enum : std::size_t { taken_back, made, first_heat };

std::size_t block_size(std::size_t coefficients) { return (coefficients - across_coefficients) / most_effusivities; }

/// What stays of the heat in a block. W
double kept_of(std::span<const double> block) { return std::accumulate(block.begin() + first_heat, block.end(), 0.0); }
/// The same with what the road has taken back.
double given_of(std::span<const double> block) { return block[taken_back] + kept_of(block); }

constexpr std::array parameters{
    ParameterSpec{"partition", "1", 0.6, 0.0, 1.0, "share of the friction power that enters the tire, or \"charm\""},
    ParameterSpec{"lambda_x", "1", 1.0, 0.0, 10.0, "scale of the longitudinal friction power"},
    ParameterSpec{"lambda_y", "1", 1.0, 0.0, 10.0, "scale of the lateral friction power"},
    rolling_contact::road_conductivity_spec,
    rolling_contact::road_capacity_spec,
};
constexpr std::array confounded{ConfoundedGroup{
    {"sliding_friction.partition", "sliding_friction.lambda_x", "sliding_friction.lambda_y", "slip_input_gain"},
    "a second measurement of the slip, or of the forces: temperatures see only the product"}};
constexpr std::string_view above =
    "more heat of sliding than the logged slip makes: slip may be logged too small or another heat follows it; compare "
    "slip_input_gain and partition_speed";
constexpr std::string_view below =
    "less heat of sliding than the logged slip makes: slip may be logged too large or late; compare slip_input_gain";
constexpr std::array plausible{
    PlausibleRange{"partition", 0.3, 0.85,
                   "effusivities of tread and asphalt 0.30 to 0.33; the thesis 0.6; up to 0.85 where the rubber itself "
                   "makes the heat, recalled",
                   "more than that cannot enter the tread, less is what two cold half-spaces share: slip, force or a "
                   "sensor is off",
                   SensorKind::any, above, below},
    PlausibleRange{"lambda_x", 0.7, 1.4, "forces are known to some per cent, sliding speeds to 10 to 30 %; recalled",
                   "slip or force is logged wrong or late, or a slow sensor flattens what sliding makes",
                   SensorKind::any, above, below},
    PlausibleRange{"lambda_y", 0.7, 1.4, "forces are known to some per cent, slip angles to 10 to 30 %; recalled",
                   "slip or force is logged wrong or late, or a slow sensor flattens what sliding makes",
                   SensorKind::any, above, below},
};
constexpr std::array<std::string_view, 2> on_off{"on", "off"};
constexpr std::array<std::string_view, 2> ways_around{"evenly", "in_contact"};
constexpr std::array<std::string_view, 2> partitions{"number", "charm"};
constexpr std::array choices{
    Choice{"longitudinal", on_off, "whether longitudinal sliding makes heat (a switch of the thesis)"},
    Choice{"lateral", on_off, "whether lateral sliding makes heat (a switch of the thesis)"},
    Choice{around_key, ways_around, "evenly around the tire, or in the contact as it goes round (travelling_contact)"},
    Choice{"partition", partitions,
           "a number; or \"charm\": heat made between two half-spaces enters both by their effusivities, "
           "e_tread/(e_tread + e_road); of the road, those of the contact that is resolved, or road_conductivity and "
           "road_capacity"},
};
constexpr std::array tables{contact_profile};
constexpr std::array<std::string_view, 1> reads{"speed"};
constexpr std::array<std::string_view, 7> may_read{"vertical_load", "slip_angle",         "slip_ratio", "slip_speed",
                                                   "lateral_force", "longitudinal_force", "wheel_angle"};
constexpr std::array<std::string_view, 1> patches{"outside"};

void place(const PlacementContext& context, ActiveEffect& active) {
    place_contact(context, active, active.tables[profile]);
    active.groups = active.choices[around] == in_contact ? sectors_of(context.mesh, active.nodes) : std::vector<int>{};
    active.road = active.groups.empty() ? -1 : context.index_of("travelling_contact");
    active.road = active.road < 0 ? context.index_of("resolved_contact") : active.road;
    const double of_road =
        active.road >= 0 ? rolling_contact::effusivity_of_road(context.effects[static_cast<std::size_t>(active.road)])
                         : std::sqrt(active[road_conductivity] * active[road_capacity]);
    place_effusivities(context, of_road, active);
    if (active.road < 0 && active.choices[shared] == by_number) {
        active.effusivities.resize(1);  // nothing follows it
    }
}

SlidingHeat enters(const ActiveEffect& active) {
    return active.choices[shared] == charm ? SlidingHeat::between : SlidingHeat::in_tread;
}

/// Fills the block of one effusivity, whose heat holds the friction power, even or by frames. W
void share_with_road(const ActiveEffect& active, const OperatingPoint& point, double effusivity,
                     std::span<double> block) {
    const std::span<double> heat = block.subspan(first_heat);
    const double of_tread =
        active.choices[shared] == charm ? effusivity / (effusivity + active.effusivity_of_road) : active[partition];
    // A law may take the share beyond 1, where it says that a term is missing; it never turns heat into cold.
    const double factor = of_tread * std::max(0.0, point.laws.partition);
    const ActiveEffect* road = active.road >= 0 ? &point.effects[static_cast<std::size_t>(active.road)] : nullptr;
    const bool road_travels = road != nullptr && travels(*road);
    const bool any = factor > 0.0 && std::ranges::any_of(heat, [](double watts) { return watts != 0.0; });
    const double kept_in_the_mean =
        any && road != nullptr && !road_travels ? kept_heat(*road, effusivity, enters(active), point) : 1.0;
    if (!active.groups.empty()) {
        const double power = factor * heat[0];
        const TravellingContact contact(point.tire, point.inputs);
        const int sectors = active.groups.back() + 1;
        for (int s = 0; s < sectors; ++s) {
            const double all = power * concentration(contact, s, sectors);
            const double kept = all > 0.0 && road_travels
                                    ? kept_heat(*road, effusivity, enters(active), contact, s, sectors)
                                    : kept_in_the_mean;
            heat[static_cast<std::size_t>(s)] = kept * all;
            block[taken_back] += (1.0 - kept) * all / sectors;
        }
        return;
    }
    for (double& watts : heat) {
        block[taken_back] += (1.0 - kept_in_the_mean) * factor * watts;
        watts *= kept_in_the_mean * factor;
    }
}

void evaluate_coefficients(const ActiveEffect& active, const OperatingPoint& point, std::span<double> out) {
    std::ranges::fill(out, 0.0);
    const std::size_t size = block_size(out.size());
    const std::span<double> heat = out.subspan(first_heat, size - first_heat);
    heat[0] = 1.0;
    if (active.field && !active.field->watts.empty()) {
        active.field->watts_at(point.inputs.time, heat);
    } else {
        if (active.field) {
            active.field->shares_at(point.inputs.time, heat);
        }
        const FrictionPower made = friction_power(active, point.tire, point.inputs);
        const double power = made.along + made.across;
        for (double& watts : heat) {
            watts *= power;
        }
    }
    // A law that takes the tread's share beyond 1 makes as much more.
    const double all = active.share_of_drum > 0.0
                           ? std::accumulate(heat.begin(), heat.end(), 0.0) * std::max(1.0, point.laws.partition)
                           : 0.0;
    for (std::size_t e = active.effusivities.size(); e-- > 0;) {  // the first block holds the power until its turn
        const std::span<double> block = out.subspan(e * size, size);
        std::ranges::copy(heat, block.subspan(first_heat).begin());
        share_with_road(active, point, active.effusivities[e], block);
        block[made] = all;
    }
    note_across_tread(point.laws, given_of(out.first(size)), out);
}

/// One coefficient at all effusivities.
std::array<double, most_effusivities> at_effusivities(std::span<const double> coefficients, std::size_t index) {
    const std::size_t size = block_size(coefficients.size());
    std::array<double, most_effusivities> values{};
    for (std::size_t e = 0; e < most_effusivities; ++e) {
        values[e] = coefficients[e * size + index];
    }
    return values;
}

/// What the road has taken back of the heat in a block, over what stays; nothing where nothing stays.
std::array<double, most_effusivities> taken_over_kept(std::span<const double> coefficients) {
    const std::size_t size = block_size(coefficients.size());
    std::array<double, most_effusivities> ratio{};
    for (std::size_t e = 0; e < most_effusivities; ++e) {
        const std::span<const double> block = coefficients.subspan(e * size, size);
        const double kept = kept_of(block);
        ratio[e] = kept > 0.0 ? block[taken_back] / kept : 0.0;
    }
    return ratio;
}

void add_terms(const EvaluationState& m, Terms& terms) {
    const bool by_sectors = !m.active.groups.empty();
    const std::size_t frames = m.active.field && !by_sectors ? m.active.field->frames() : 1;
    std::array<double, most_effusivities> ratio = taken_over_kept(m.coefficients);
    if (by_sectors) {  // each has its own power, a mean over the sectors is taken
        for (double& one : ratio) {
            one *= m.active.groups.back() + 1;
        }
    }
    const double share = m.active.share_of_drum;
    const double given = given_of(m.coefficients.first(block_size(m.coefficients.size())));
    const AcrossTread across(m, given > 0.0 ? given : 1.0);
    for (std::size_t k = 0; k < frames; ++k) {
        for (std::size_t i = 0; i < m.active.nodes.size(); ++i) {
            const int node = m.active.nodes[i];
            const std::size_t of = by_sectors ? static_cast<std::size_t>(m.active.groups[i]) : k;
            const std::array<double, most_effusivities> heat = at_effusivities(m.coefficients, first_heat + of);
            if (heat[0] == 0.0) {
                continue;
            }
            const double weight = m.active.field && !by_sectors ? m.active.field->weights[k][i] : across.weight(i);
            const EffusivityInterpolation tread(m, node);
            const double watts = weight * tread.value(heat);
            const double slope = weight * tread.slope(heat);
            terms.heat(node, (1.0 - share) * watts, (1.0 - share) * slope);
            if (share > 0.0) {
                take_from_drum(m, i, share * watts, share * slope, 0.0, terms);
            }
            if (m.active.road >= 0) {  // booked as made here and taken there
                std::array<double, most_effusivities> taken{};
                std::ranges::transform(heat, ratio, taken.begin(), std::multiplies<>());
                terms.rebook(static_cast<std::size_t>(m.active.road), (share - 1.0) * weight * tread.value(taken));
            }
        }
    }
    if (share > 0.0) {
        terms.heat(drum_of(m), share * m.coefficients[made]);
    }
}

}  // namespace
}  // namespace effects

FrictionPower friction_power(const ActiveEffect& sliding, const Tire& tire, const Inputs& in) {
    if (!tire.touches(in.vertical_load)) {
        return {};
    }
    // Sliding speeds of the contact: v_sx = V - R_R Omega, v_sy = V tan(alpha).
    const double along = std::abs(in.longitudinal_force * longitudinal_slip_speed(in));
    const double across = std::abs(in.lateral_force * in.speed) * std::tan(std::abs(in.slip_angle));
    return {.along = sliding.choices[effects::longitudinal] == 0 ? sliding[effects::lambda_x] * along : 0.0,
            .across = sliding.choices[effects::lateral] == 0 ? sliding[effects::lambda_y] * across : 0.0};
}

EnteredHeat heat_of_sliding(const ActiveEffect& sliding, std::span<const double> coefficients, double effusivity) {
    const EffusivityInterpolation tread(sliding.effusivities, sliding.effusivity_of_road,
                                        {.value = effusivity, .slope = 0.0});
    double watts = 0.0;
    for (std::size_t i = 0; i < effects::block_size(coefficients.size()); ++i) {
        watts += i == effects::made ? 0.0 : tread.value(effects::at_effusivities(coefficients, i));
    }
    return {.watts = watts, .enters = effects::enters(sliding)};
}

namespace effects {

extern const Effect sliding_friction;
const Effect sliding_friction{
    .id = "sliding_friction",
    .kind = EffectKind::source,
    .on = true,
    .equation = "q = partition (lambda_x |Fx v_sx| + lambda_y |Fy| |V| tan|alpha|) >= 0, v_sx = V - R_R Omega",
    .source =
        "thesis (31); charm: Charron, Publ. Sci. Tech. Minist. Air 182, 1943, and Carslaw & Jaeger 1959, sec. 2.8; "
        "asphalt "
        "concrete 1.2 W/mK, 2300 kg/m3, 900 J/kgK (quoted)",
    .valid =
        "0.6 of the partition: the thesis's fits; charm: half-spaces, a dry road, penetration far below the tread's "
        "thickness",
    .meaning =
        "Heat of sliding in the contact, into the outer surface. Either sign convention of Fy and the slip "
        "angle gives the same heat; signals that are not given count as zero. slip_speed in the place of slip_ratio "
        "lets "
        "a wheel that spins on the spot heat up. The thesis's partition of 0.6 is a fitted number and, beside a "
        "contact "
        "that cools the tread, counts the road's share twice; \"charm\" is the share that two half-spaces take (0.3 to "
        "0.5 of rubber on asphalt, more where it is warm) and belongs beside resolved_contact or travelling_contact "
        "(around = "
        "\"in_contact\"). "
        "With a number, the road takes a share of the heat back in such a contact; the heat budget counts that share "
        "with "
        "the contact's effect. "
        "A field of a structural code places it by friction power, or gives its watts; around = \"in_contact\" lets it "
        "go round with travelling_contact.",
    .parameters = parameters,
    .plausible = plausible,
    .confounded = confounded,
    .choices = choices,
    .tables = tables,
    .reads = reads,
    .may_read = may_read,
    .needs_tire = true,
    .patches = patches,
    .model =
        HeatEffect{
            .n_coefficients = 3 * most_effusivities + across_coefficients,
            .field = FieldOf::friction,
            .frame_coefficients = most_effusivities * (most_frames - 1),
            .place = place,
            .evaluate_coefficients = evaluate_coefficients,
            .add_terms = add_terms,
        },
};

}  // namespace effects
}  // namespace tiretherm::physics
