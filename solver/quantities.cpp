// SPDX-License-Identifier: BSD-3-Clause
// The table of what channels read: temperatures, and what follows from them by the laws of the tire.
#include "physics/celsius.hpp"
#include "solver/quantity.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "physics/contact/across_tread.hpp"
#include "physics/contact/contact_in_revolutions.hpp"
#include "physics/contact/heat_of_sliding.hpp"
#include "physics/contact/rolling_contact.hpp"
#include "physics/contact/travelling.hpp"
#include "physics/contact/tread_effusivity.hpp"
#include "physics/tire_laws/compound.hpp"
#include "physics/tire_laws/rolling_resistance.hpp"
#include "solver/problem.hpp"
#include "solver/system.hpp"

namespace tiretherm::solver {

namespace {

constexpr double atmosphere = 101325.0;  // Pa

const physics::Tire& tire_of(const SensorMoment& now) { return now.system.material_model().tire; }

/// The power that deformation loses.
double deformation_loss(const FollowedState& state) {
    double lost = 0.0;
    const std::span<const physics::ActiveEffect> effects = state.system.effects();
    for (std::size_t e = 0; e < effects.size(); ++e) {
        const physics::HeatEffect* heat = effects[e].effect->heat_effect();
        lost += heat != nullptr && heat->by_deformation ? state.watts[e] : 0.0;
    }
    return lost;
}

/// What conduction brings to the surface nodes. They hold no heat: it is what all effects together take from the
/// surface, less the heat that they give it.
double conducted_to_surface(const FollowedState& state) {
    const std::span<const physics::ActiveEffect> effects = state.system.effects();
    const auto conduction = std::ranges::find_if(effects, [](const auto& e) { return e.effect->id == "conduction"; });
    if (conduction == effects.end()) {
        return 0.0;
    }
    const auto which = static_cast<std::size_t>(conduction - effects.begin());
    state.system.find_means(state.temperature, state.means);
    state.system.find_flow_of({&which, 1}, state.temperature, state.means, {}, state.flow);
    return state.where(state.flow);
}

double drag_force(const SensorMoment& now) {
    return physics::rolling_drag(tire_of(now), now.followed, physics::rolling_speed(now.inputs),
                                 tire_of(now).reference_load(now.inputs));
}

double rolling_moment(const SensorMoment& now) {
    return physics::rolling_moment(tire_of(now), now.followed, physics::rolling_speed(now.inputs),
                                   tire_of(now).reference_load(now.inputs));
}

double loaded_radius(const SensorMoment& now) { return tire_of(now).loaded_radius(now.inputs); }

double cornering_stiffness(const SensorMoment& now) {
    return now.problem.handling.cornering_stiffness(tire_of(now), now.inputs, now.followed);
}

double lambda_Tb(const SensorMoment& now) {
    return physics::bulk_temperature_factor(cornering_stiffness(now),
                                            now.problem.handling.stiffness_of_file(now.inputs));
}

/// At a temperature of the tread's surface, 1 where friction does not follow it. The tread's loss tangent is that of the
/// loss, or the thesis's where the loss is off.
double grip_at(const SensorMoment& now, double T_surface) {
    const std::optional<physics::Grip>& law = now.problem.handling.grip;
    if (!law) {
        return 1.0;
    }
    const std::span<const physics::ActiveEffect> effects = now.system.effects();
    const auto loss = std::ranges::find_if(effects, [](const auto& e) { return e.effect->id == "strain_energy_loss"; });
    return law->value(T_surface, [&](double T) {
        const physics::LossTangent standard;
        return loss != effects.end() ? physics::tan_delta_of(*loss, 0, T, law->frequency)
                                     : standard.value(T + standard.shift(law->frequency));
    });
}

double grip(const SensorMoment& now) { return grip_at(now, now.followed); }

double lateral_force(const SensorMoment& now) {
    const double friction = grip_at(now, now.surface);
    return now.problem.handling.lateral(tire_of(now), now.inputs, now.followed, friction).force;
}

/// The stiffness has no part in the peak, and with it the bulk's temperature; neither has the slip of the moment.
double peak_lateral_force(const SensorMoment& now) {
    physics::Inputs inputs = now.inputs;
    inputs.slip_angle = 0.0;
    return now.problem.handling.lateral(tire_of(now), inputs, now.followed, grip(now)).peak;
}

double reference_lateral_force(const SensorMoment& now) {
    return now.problem.handling.magic_formula->lateral(physics::side_slip(now.inputs)).force;
}

double longitudinal_force(const SensorMoment& now) {
    physics::PureSlipState state = physics::side_slip(now.inputs);
    constexpr double least_speed = 0.1;  // m/s: below it a slip ratio is beyond any law
    state.slip = now.inputs.slip_ratio + now.inputs.slip_speed / std::max(std::abs(now.inputs.speed), least_speed);
    state.sliding_speed = std::abs(physics::longitudinal_slip_speed(now.inputs));
    return now.problem.handling.magic_formula->longitudinal(state).force;
}

/// The tread's surface at an edge of the contact, T its mean over the revolution: what the road takes and what sliding
/// puts in, each with the memory of earlier revolutions.
double flash(const SensorMoment& now) {
    const double T = now.followed;
    const physics::Inputs& inputs = now.inputs;
    const physics::Tire& tire = tire_of(now);
    const std::span<const physics::ActiveEffect> effects = now.system.effects();
    const auto by_id = [&](std::string_view id) {
        return std::ranges::find_if(effects, [&](const auto& active) { return active.effect->id == id; });
    };
    const auto road = by_id("resolved_contact");
    if (road == effects.end()) {
        return T;
    }
    const mesh::Mesh& mesh = now.problem.mesh;
    const int node = mesh.patches[static_cast<std::size_t>(road->patches.front())].faces.front().node;
    const auto layer = static_cast<std::size_t>(mesh.layer[static_cast<std::size_t>(node)]);
    const double e = physics::effusivity(now.system.material_model().materials[layer], T).value;
    const std::optional<physics::ContactInRevolutions> contact =
        physics::contact_in_revolutions(*road, e, tire, inputs);
    if (!contact) {
        return T;
    }
    const bool entry = now.quantity == Quantity::surface_at_entry;
    const double scale = physics::rolling_contact::scale_of(*road);
    double heated = 0.0;
    if (const auto sliding = by_id("sliding_friction"); sliding != effects.end() && !physics::travels(*sliding)) {
        now.system.evaluate_coefficients(now.logged, now.coefficients);
        const auto of_sliding =
            now.system.coefficients_of(static_cast<std::size_t>(sliding - effects.begin()), now.coefficients);
        const auto [watts, enters] = physics::heat_of_sliding(*sliding, of_sliding, e);
        heated = watts / tire.contact_area(inputs) *
                 (entry ? contact->heated_at_entry(scale, enters) : contact->heated_at_exit(scale, enters));
    }
    return T + scale * (T - inputs.road_temperature) * (entry ? contact->at_entry() : contact->at_exit()) + heated;
}

double contact_pressure(const SensorMoment& now) {
    const std::string_view zone = now.quantity == Quantity::contact_pressure_outside  ? "outside_shoulder"
                                  : now.quantity == Quantity::contact_pressure_inside ? "inside_shoulder"
                                                                                      : "crown";
    return physics::relative_contact_pressure(now.problem.mesh, now.system.effects(), now.system.laws(now.inputs),
                                              zone);
}

double gas_pressure(const SensorMoment& now) {
    return (now.inputs.inflation_pressure + atmosphere) * now.followed / now.gas_start - atmosphere;
}

constexpr std::array<std::string_view, 2> rolling{"speed", "vertical_load"};
constexpr std::array<std::string_view, 3> contact{"speed", "vertical_load", "road_temperature"};
constexpr std::array<std::string_view, 1> load{"vertical_load"};
constexpr std::array<std::string_view, 3> cornering{"speed", "vertical_load", "slip_angle"};
constexpr std::array<std::string_view, 3> braking{"speed", "vertical_load", "slip_ratio"};
constexpr std::array<std::string_view, 1> pressure{"inflation_pressure"};

constexpr ShownUnit celsius{.name = "degC", .zero = zero_celsius};
constexpr ShownUnit newton{.name = "N"};

constexpr std::array table{
    QuantityDescription{.quantity = Quantity::temperature,
                        .kind = "",
                        .meaning = "",
                        .unit = "K",
                        .shown = celsius,
                        .needs_tire = false},
    QuantityDescription{.quantity = Quantity::drag_force,
                        .kind = "drag_force",
                        .meaning = "rolling resistance, as a force at the axle",
                        .unit = "N",
                        .shown = newton,
                        .signals = rolling,
                        .follows_watts = true,
                        .follow = deformation_loss,
                        .evaluate = drag_force},
    QuantityDescription{.quantity = Quantity::rolling_moment,
                        .kind = "rolling_moment",
                        .meaning = "rolling resistance, as a moment about the axle",
                        .unit = "N m",
                        .shown = {.name = "N m"},
                        .signals = rolling,
                        .follows_watts = true,
                        .follow = deformation_loss,
                        .evaluate = rolling_moment},
    QuantityDescription{.quantity = Quantity::loaded_radius,
                        .kind = "loaded_radius",
                        .meaning = "radius under load",
                        .unit = "m",
                        .shown = {.name = "mm", .factor = 1e3},
                        .signals = load,
                        .evaluate = loaded_radius},
    QuantityDescription{.quantity = Quantity::cornering_stiffness,
                        .kind = "cornering_stiffness",
                        .meaning = "cornering stiffness",
                        .unit = "N rad-1",
                        .shown = {.name = "N/rad"},
                        .signals = load,
                        .region = "bulk",
                        .evaluate = cornering_stiffness},
    QuantityDescription{.quantity = Quantity::bulk_temperature_factor,
                        .kind = "bulk_temperature_factor",
                        .meaning = "cornering stiffness over that of the Magic Formula, lambda_Tb",
                        .unit = "1",
                        .shown = {.name = "-"},
                        .signals = load,
                        .region = "bulk",
                        .needs_magic_formula = true,
                        .evaluate = lambda_Tb},
    QuantityDescription{
        .quantity = Quantity::lateral_force,
        .kind = "lateral_force",
        .meaning = "lateral force in pure slip, Magic Formula with the cornering stiffness at the temperature",
        .unit = "N",
        .shown = newton,
        .signals = cornering,
        .region = "bulk",
        .needs_peak = true,
        .evaluate = lateral_force},
    QuantityDescription{.quantity = Quantity::reference_lateral_force,
                        .kind = "reference_lateral_force",
                        .meaning = "lateral force in pure slip, Magic Formula without temperature",
                        .unit = "N",
                        .shown = newton,
                        .signals = cornering,
                        .needs_magic_formula = true,
                        .evaluate = reference_lateral_force},
    QuantityDescription{.quantity = Quantity::longitudinal_force,
                        .kind = "longitudinal_force",
                        .meaning = "longitudinal force in pure slip, Magic Formula without temperature",
                        .unit = "N",
                        .shown = newton,
                        .signals = braking,
                        .needs_magic_formula = true,
                        .evaluate = longitudinal_force},
    QuantityDescription{.quantity = Quantity::surface_at_entry,
                        .kind = "surface_at_entry",
                        .meaning = "outer surface where it meets the road, in each revolution",
                        .unit = "K",
                        .shown = celsius,
                        .signals = contact,
                        .region = "surface",
                        .needs_effect = "resolved_contact",
                        .evaluate = flash},
    QuantityDescription{.quantity = Quantity::surface_at_exit,
                        .kind = "surface_at_exit",
                        .meaning = "outer surface where it leaves the road, in each revolution",
                        .unit = "K",
                        .shown = celsius,
                        .signals = contact,
                        .region = "surface",
                        .needs_effect = "resolved_contact",
                        .evaluate = flash},
    QuantityDescription{.quantity = Quantity::gas_pressure,
                        .kind = "gas_pressure",
                        .meaning = "inflation pressure above the atmosphere",
                        .unit = "Pa",
                        .shown = {.name = "kPa", .factor = 1e-3},
                        .signals = pressure,
                        .region = "gas",
                        .needs_tire = false,
                        .evaluate = gas_pressure},
    QuantityDescription{.quantity = Quantity::contact_pressure_outside,
                        .kind = "contact_pressure_outside",
                        .meaning = "contact pressure of the outside shoulder over the tread's mean",
                        .unit = "1",
                        .shown = {.name = "-"},
                        .signals = load,
                        .needs_effect = "pressure_across_tread",
                        .evaluate = contact_pressure},
    QuantityDescription{.quantity = Quantity::contact_pressure_middle,
                        .kind = "contact_pressure_middle",
                        .meaning = "contact pressure of the crown over the tread's mean",
                        .unit = "1",
                        .shown = {.name = "-"},
                        .signals = load,
                        .needs_effect = "pressure_across_tread",
                        .evaluate = contact_pressure},
    QuantityDescription{.quantity = Quantity::contact_pressure_inside,
                        .kind = "contact_pressure_inside",
                        .meaning = "contact pressure of the inside shoulder over the tread's mean",
                        .unit = "1",
                        .shown = {.name = "-"},
                        .signals = load,
                        .needs_effect = "pressure_across_tread",
                        .evaluate = contact_pressure},
    QuantityDescription{.quantity = Quantity::heat_flux,
                        .kind = "heat_flux",
                        .meaning = "heat flux out of the rubber",
                        .unit = "W m-2",
                        .shown = {.name = "W/m2"},
                        .through_patch = true,
                        .needs_tire = false,
                        .needs_effect = "conduction",
                        .follow = conducted_to_surface},
    QuantityDescription{.quantity = Quantity::grip,
                        .kind = "grip",
                        .meaning = "friction over that at its reference temperature",
                        .unit = "1",
                        .shown = {.name = "-"},
                        .region = "surface",
                        .needs_grip = true,
                        .evaluate = grip},
    QuantityDescription{.quantity = Quantity::peak_lateral_force,
                        .kind = "peak_lateral_force",
                        .meaning = "largest lateral force in pure slip",
                        .unit = "N",
                        .shown = newton,
                        .signals = load,
                        .region = "surface",
                        .needs_peak = true,
                        .needs_grip = true,
                        .evaluate = peak_lateral_force},
};

constexpr bool is_in_order() {
    for (std::size_t i = 0; i < table.size(); ++i) {
        if (static_cast<std::size_t>(table[i].quantity) != i) {
            return false;
        }
    }
    return true;
}
static_assert(is_in_order(), "the rows stand in the order of the enumeration");

}  // namespace

std::span<const QuantityDescription> quantities() { return table; }

const QuantityDescription& description_of(Quantity quantity) { return table[static_cast<std::size_t>(quantity)]; }

std::string_view unit_of(Quantity quantity) { return description_of(quantity).unit; }

ShownUnit shown_unit(Quantity quantity) { return description_of(quantity).shown; }

}  // namespace tiretherm::solver
