// SPDX-License-Identifier: BSD-3-Clause
// Gives a case's tire the inputs of its corner: what the case or its run gives wins, the rest is computed; warnings say
// what was computed from what.

#include "input/vehicle/read_vehicle.hpp"

#include <limits>

#include <fmt/format.h>

#include "input/text/word_lists.hpp"
#include "input/vehicle/vehicle_input_model.hpp"

namespace tiretherm::input {

namespace {

std::string percent(double share) {
    return share < 0.1 ? fmt::format("{:.2g} %", 100.0 * share) : fmt::format("{:.0f} %", 100.0 * share);
}

/// What the model could not follow.
void warn_of_limits(const CornerHistory& corner, const VehicleSettings& settings, InputErrors& errors) {
    const std::string_view name = physics::corner_names[static_cast<std::size_t>(settings.corner)];
    if (corner.exceeds > 0.0) {
        errors.warn_of_corner(settings.place, name,
                              "the forces exceed what the tire can give in {} of the time: the slips are then "
                              "those of the highest force",
                              percent(corner.exceeds));
    }
    if (corner.lifted > 0.0) {
        errors.warn_of_corner(settings.place, name,
                              "the computed wheel load is zero in {} of the time: the other wheels carry its load",
                              percent(corner.lifted));
    }
    if (corner.rolls_over > 0.0) {
        errors.warn(settings.place,
                    "the car would roll over in {} of the time: check the height of its "
                    "centre of gravity, its tracks and the lateral acceleration",
                    percent(corner.rolls_over));
    }
}

/// The car. The tires of all its wheels have the pressure with which this one begins, where the case gives it.
std::optional<VehicleSettings> settings_of(TomlTable& root, const std::optional<physics::MagicFormula>& law,
                                           const solver::InputSignals& inputs) {
    std::optional<VehicleSettings> settings = read_vehicle_settings(root, law);
    const double begin = std::numeric_limits<double>::lowest();
    const double pressure = inputs.at(begin, solver::JumpSide::after).inflation_pressure;
    if (settings && pressure > 0.0) {
        for (std::optional<physics::MagicFormula>& of_axle : settings->kind.laws) {
            if (of_axle) {
                of_axle->own_pressure = pressure;
            }
        }
    }
    return settings;
}

/// @param known as another tire of the car has found it; null: nothing  @returns without a history after an error
CarMotion motion_by(const VehicleSettings& settings, const VehicleLog& log, const CarMotion* known,
                    InputErrors& errors) {
    const solver::Digest::Value origin = motion_origin(settings, log);
    if (known != nullptr && known->origin == origin) {
        return *known;
    }
    std::optional<MotionHistory> found = motion_of(settings, log, errors);
    return {.origin = origin, .history = found ? std::make_shared<const MotionHistory>(std::move(*found)) : nullptr};
}

}  // namespace

VehicleTable read_vehicle(TomlTable& root, const std::optional<physics::MagicFormula>& law, bool unreadable,
                          std::shared_ptr<const CarMotion> known, DrivenSignals& signals) {
    InputErrors& errors = root.errors();
    GivenSignals& given = signals.given;
    VehicleTable read{.car = std::move(known)};
    const std::optional<VehicleSettings> settings = settings_of(root, law, signals.inputs);
    if (root.has("vehicle")) {
        given.try_emplace("speed", root.place("vehicle"));  // without it, motion_of says so
    }
    if (!settings || unreadable) {
        // The inputs that it would have given are not missing.
        for (const ComputedInput& one : computed_inputs()) {
            if (root.has("vehicle")) {
                given.try_emplace(std::string(one.signal->name), root.place("vehicle"));
            }
        }
        return read;
    }
    std::optional<VehicleLog> log = find_vehicle_log(signals, settings->place, errors);
    if (log) {
        log->speed_is_brought_back = root.content().find({"effects", "input_delay", "speed"}) != nullptr;
    }
    std::vector<std::string> names;
    std::vector<std::string> kept;
    std::vector<ComputedInput> computed;
    for (const ComputedInput& one : computed_inputs()) {
        const bool slip_ratio = one.signal->member == &physics::Inputs::slip_ratio;
        if (slip_ratio && (!settings->has_slip_ratio() || given.contains("slip_speed"))) {
            continue;
        }
        // A load that was measured is better than one that is computed.
        const bool is_new = given.try_emplace(std::string(one.signal->name), settings->place).second;
        (is_new ? names : kept).emplace_back(one.signal->name);
        if (is_new) {
            computed.push_back(one);
        }
    }
    if (!log) {
        return read;
    }
    CarMotion car = motion_by(*settings, *log, read.car.get(), errors);
    if (car.history == nullptr) {
        read.car = nullptr;
        return read;
    }
    const MotionHistory& motion = *car.history;
    read.course_agrees = motion.course_agrees;
    solver::InputSignals& inputs = signals.inputs;
    // A disc cools to the air around it: without that there is no temperature of it.
    const bool has_disc = inputs.gives(*physics::find_signal("air_temperature")) &&
                          given.try_emplace("brake_temperature", settings->place).second;
    const auto model =
        std::make_shared<VehicleInputModel>(*settings, std::move(*log), inputs, std::move(computed), has_disc);
    if (const auto origin = model->axle_origin(); car.axle == nullptr || car.axle_origin != origin) {
        car.axle_origin = origin;
        car.axle = std::make_shared<const AxleHistory>(model->axle(settings->numbers, motion));
    }
    read.car = std::make_shared<const CarMotion>(car);
    const CornerHistory& corner = model->own(*car.axle);
    model->put(settings->numbers, motion, corner, inputs);
    const std::span<const double> numbers = settings->numbers.all();
    read.numbers.assign(numbers.begin(), numbers.end());
    read.model = model;
    const std::string_view name = physics::corner_names[static_cast<std::size_t>(settings->corner)];
    if (!names.empty()) {
        errors.warn_of_corner(settings->place, name,
                              "{} {} computed from the motion of the car, and the speed of the "
                              "tire from that of the car and the yaw rate",
                              listed(names), names.size() > 1 ? "are" : "is");
    }
    if (!kept.empty()) {
        errors.warn_of_corner(settings->place, name, "{} {} not computed: the case gives {}", listed(kept),
                              kept.size() > 1 ? "are" : "is", kept.size() > 1 ? "them" : "it");
    }
    for (const std::string& source : motion.sources) {
        errors.warn(settings->place, source);
    }
    warn_of_limits(corner, *settings, errors);
    return read;
}

}  // namespace tiretherm::input
