// SPDX-License-Identifier: BSD-3-Clause
// Computes a tire's inputs anew for other numbers of the car.

#include "input/vehicle/vehicle_input_model.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "input/tire_property_file/tir_keys.hpp"
#include "input/vehicle/at_times.hpp"
#include "solver/field_digest.hpp"

namespace tiretherm::input {

namespace {

using physics::CornerInputs;

/// An input of the case as a history: a log's or a schedule's points, or one point of a constant.
solver::SignalHistory history_of(const solver::InputSignals& signals, const physics::Signal& signal) {
    for (const solver::Series& series : signals.series()) {
        if (series.signal == &signal) {
            return {.time = series.time, .value = series.value};
        }
    }
    return signals.gives(signal) ? solver::SignalHistory{.time = {0.0}, .value = {signals.constants().*signal.member}}
                                 : solver::SignalHistory{};
}

solver::Series series_of(const physics::Signal& signal, double CornerInputs::*member, const MotionHistory& motion,
                         const CornerHistory& corner) {
    std::vector<double> value(corner.inputs.size());
    std::ranges::transform(corner.inputs, value.begin(), [&](const CornerInputs& inputs) {
        return std::clamp(inputs.*member, signal.low, signal.high);
    });
    return {.signal = &signal, .time = motion.time, .value = std::move(value), .logged = true};
}

/// Of the disc at this wheel, from its share of the braking force. @param air K, a history
solver::Series disc_of(const physics::Brake& brake, const MotionHistory& motion, const CornerHistory& corner,
                       const solver::SignalHistory& air) {
    const physics::Signal& signal = *physics::find_signal("brake_temperature");
    std::vector<double> power;
    for (std::size_t i = 0; i < motion.time.size(); ++i) {
        const CornerInputs& inputs = corner.inputs[i];
        const bool brakes = !motion.motion[i].brakes_released;
        power.push_back(brakes ? std::max(0.0, -inputs.longitudinal_force) * std::abs(inputs.speed) : 0.0);
    }
    std::vector<double> disc = physics::brake_temperature(brake, motion.time, power, at_times(air, motion.time));
    std::ranges::for_each(disc, [&](double& kelvin) { kelvin = std::clamp(kelvin, signal.low, signal.high); });
    return {.signal = &signal, .time = motion.time, .value = std::move(disc), .logged = true};
}

/// All of a law: other tires of a car may have another one.
void add_law(solver::Digest& digest, physics::MagicFormula law) {
    digest.add(law.version);
    for (const double number :
         {law.nominal_load, law.reference_speed, law.friction_degression, law.nominal_pressure, law.own_pressure}) {
        digest.add(number);
    }
    for (const tir::Coefficient& one : tir::coefficients) {
        digest.add(one.at(law));
    }
}

}  // namespace

std::span<const ComputedInput> computed_inputs() {
    static const std::array<ComputedInput, 5> all{{
        {physics::find_signal("vertical_load"), &CornerInputs::vertical_load},
        {physics::find_signal("slip_angle"), &CornerInputs::slip_angle},
        {physics::find_signal("slip_ratio"), &CornerInputs::slip_ratio},
        {physics::find_signal("lateral_force"), &CornerInputs::lateral_force},
        {physics::find_signal("longitudinal_force"), &CornerInputs::longitudinal_force},
    }};
    return all;
}

VehicleInputModel::VehicleInputModel(VehicleSettings settings, VehicleLog log, const solver::InputSignals& inputs,
                                     std::vector<ComputedInput> computed, bool has_disc)
    : settings_(std::move(settings)),
      log_(std::move(log)),
      air_(history_of(inputs, *physics::find_signal("air_temperature"))),
      computed_(std::move(computed)),
      has_disc_(has_disc) {
    measured_.camber = history_of(inputs, *physics::find_signal("camber"));
    measured_.vertical_load = history_of(inputs, *physics::find_signal("vertical_load"));
}

AxleHistory VehicleInputModel::axle(const VehicleNumbers& numbers, const MotionHistory& motion) const {
    return axle_history(vehicle_of(numbers, settings_.kind), settings_.corner, motion, measured_);
}

const CornerHistory& VehicleInputModel::own(const AxleHistory& axle) const {
    return axle[physics::is_left(static_cast<std::size_t>(settings_.corner)) ? 0 : 1];
}

solver::Digest::Value VehicleInputModel::axle_origin() const {
    solver::Digest digest;
    const auto corner = static_cast<std::size_t>(settings_.corner);
    digest.add(physics::axle_of(corner));
    // A measured load is that of this tire alone.
    digest.add(measured_.vertical_load.time.empty() ? physics::n_corners : corner);
    solver::add_fields(digest, settings_.numbers);
    solver::add_fields(digest, settings_.kind);
    solver::add_fields(digest, measured_);
    for (const std::optional<physics::MagicFormula>& law : settings_.kind.laws) {
        add_law(digest, law.value_or(physics::MagicFormula{}));
    }
    return digest.value();
}

void VehicleInputModel::put(const VehicleNumbers& numbers, const MotionHistory& motion, const CornerHistory& corner,
                            solver::InputSignals& into) const {
    for (const ComputedInput& one : computed_) {
        into.replace(series_of(*one.signal, one.member, motion, corner));
    }
    into.replace(series_of(*physics::find_signal("speed"), &CornerInputs::speed, motion, corner));
    if (has_disc_) {
        into.replace(disc_of(brake_of(numbers), motion, corner, air_));
    }
}

void VehicleInputModel::apply(std::span<const double> numbers, solver::InputSignals& into) const {
    VehicleSettings moved = settings_;
    moved.numbers = VehicleNumbers(numbers);
    const MotionHistory motion = motion_again(moved, log_);
    put(moved.numbers, motion, own(axle(moved.numbers, motion)), into);
}

std::vector<const physics::Signal*> VehicleInputModel::signals() const {
    std::vector<const physics::Signal*> all{physics::find_signal("speed")};
    std::ranges::transform(computed_, std::back_inserter(all), &ComputedInput::signal);
    if (has_disc_) {
        all.push_back(physics::find_signal("brake_temperature"));
    }
    return all;
}

void VehicleInputModel::add_to(solver::Digest& digest) const {
    const auto& [settings, log, measured, air, computed, has_disc] = *this;
    const auto add = [&](const auto&... member) { (solver::add_fields(digest, member), ...); };
    add(settings, log, measured, air, computed, has_disc);
}

}  // namespace tiretherm::input
