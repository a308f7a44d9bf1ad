// What channels read: temperatures, and what follows from them by the laws of the tire.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "physics/contact/contact_in_revolutions.hpp"
#include "physics/contact/rolling_contact.hpp"
#include "physics/contact/travelling.hpp"
#include "physics/tire_laws/rolling_resistance.hpp"
#include "solver/time_integration/sensor_outputs.hpp"

namespace tiretherm::solver {

namespace {

constexpr double atmosphere = 101325.0;  // Pa

}  // namespace

/// What the channel reads, from what is followed and from the inputs of the moment.
double SensorOutputs::quantity(std::size_t channel, double followed, const physics::Inputs& logged) const {
    const physics::Tire& tire = system_->material_model().tire;
    const physics::Inputs inputs = system_->transformed(logged);
    switch (problem_->channels[channel].quantity) {
        case Quantity::temperature:
            return followed;
        case Quantity::drag_force:
            return physics::rolling_drag(tire, followed, inputs.speed, inputs.vertical_load);
        case Quantity::rolling_moment:
            return physics::rolling_moment(tire, followed, inputs.speed, inputs.vertical_load);
        case Quantity::loaded_radius:
            return tire.loaded_radius(inputs.vertical_load);
        case Quantity::cornering_stiffness:
            return stiffness(tire, inputs, followed);
        case Quantity::bulk_temperature_factor:
        case Quantity::lateral_force:
        case Quantity::reference_lateral_force:
        case Quantity::longitudinal_force:
            return magic_formula(problem_->channels[channel].quantity, tire, inputs, followed);
        case Quantity::surface_at_entry:
        case Quantity::surface_at_exit:
            return flash(problem_->channels[channel].quantity, logged, followed);
        case Quantity::gas_pressure:
            return (inputs.inflation_pressure + atmosphere) * followed / gas_start_ - atmosphere;
    }
    return followed;
}

/// The tread's surface at an edge of the contact, T its mean over the revolution: what the road takes and what sliding
/// puts in, each with the memory of earlier revolutions.
double SensorOutputs::flash(Quantity quantity, const physics::Inputs& logged, double T) const {
    const physics::Inputs inputs = system_->transformed(logged);
    const physics::Tire& tire = system_->material_model().tire;
    const std::span<const physics::ActiveEffect> effects = system_->effects();
    const auto by_id = [&](std::string_view id) {
        return std::ranges::find_if(effects, [&](const auto& active) { return active.effect->id == id; });
    };
    const auto road = by_id("resolved_contact");
    if (road == effects.end()) {
        return T;
    }
    const std::optional<physics::ContactInRevolutions> contact = physics::contact_in_revolutions(*road, tire, inputs);
    if (!contact) {
        return T;
    }
    const bool entry = quantity == Quantity::surface_at_entry;
    double heated = 0.0;  // W/m2
    if (const auto sliding = by_id("sliding_friction"); sliding != effects.end() && !physics::travels(*sliding)) {
        system_->evaluate_coefficients(logged, coefficients_);
        const auto of_sliding =
            system_->coefficients_of(static_cast<std::size_t>(sliding - effects.begin()), coefficients_);
        heated = std::accumulate(of_sliding.begin(), of_sliding.end(), 0.0) / tire.contact_area(inputs.vertical_load);
    }
    const double taken = physics::rolling_contact::scale_of(*road) * (T - inputs.road_temperature);
    return T + taken * (entry ? contact->at_entry() : contact->at_exit()) +
           heated * (entry ? contact->heated_at_entry() : contact->heated_at_exit());
}

double SensorOutputs::stiffness(const physics::Tire& tire, const physics::Inputs& inputs, double T) const {
    const Handling& handling = problem_->handling;
    return handling.lambda_CP * physics::cornering_stiffness(handling.modulus, tire, inputs.vertical_load, T).value;
}

double SensorOutputs::magic_formula(Quantity quantity, const physics::Tire& tire, const physics::Inputs& inputs,
                                    double T) const {
    const physics::MagicFormula& law = *problem_->handling.magic_formula;
    physics::PureSlipState state{.load = inputs.vertical_load,
                                 .slip = inputs.slip_angle,
                                 .camber = inputs.camber,
                                 .speed = inputs.speed,
                                 .sliding_speed = std::abs(inputs.speed * std::tan(inputs.slip_angle))};
    if (quantity == Quantity::longitudinal_force) {
        state.slip = inputs.slip_ratio;
        state.sliding_speed = std::abs(inputs.speed * inputs.slip_ratio);
        return law.longitudinal(state).force;
    }
    if (quantity == Quantity::reference_lateral_force) {
        return law.lateral(state).force;
    }
    const double lambda_Tb = physics::bulk_temperature_factor(
        stiffness(tire, inputs, T), law.cornering_stiffness(inputs.vertical_load, inputs.camber));
    return quantity == Quantity::bulk_temperature_factor ? lambda_Tb : law.lateral(state, lambda_Tb).force;
}

}  // namespace tiretherm::solver
