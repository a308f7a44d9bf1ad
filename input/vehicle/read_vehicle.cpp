// SPDX-License-Identifier: BSD-3-Clause
// Gives a case's tire the inputs of its corner: what the case or its run gives wins, the rest is computed; warnings say
// what was computed from what.

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "input/text/suggestions.hpp"
#include "input/vehicle/at_times.hpp"
#include "input/vehicle/corner_signals.hpp"

namespace tiretherm::input {

namespace {

using physics::CornerInputs;
using physics::Inputs;

struct Computed {
    double Inputs::*input;
    double CornerInputs::*member;
};
constexpr std::array computed{
    Computed{&Inputs::vertical_load, &CornerInputs::vertical_load},
    Computed{&Inputs::slip_angle, &CornerInputs::slip_angle},
    Computed{&Inputs::slip_ratio, &CornerInputs::slip_ratio},
    Computed{&Inputs::lateral_force, &CornerInputs::lateral_force},
    Computed{&Inputs::longitudinal_force, &CornerInputs::longitudinal_force},
};

const physics::Signal& signal_of(double Inputs::*member) {
    return *std::ranges::find(physics::signals(), member, &physics::Signal::member);
}

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
    solver::Series series{.signal = &signal, .time = motion.time, .value = {}, .logged = true};
    for (const CornerInputs& inputs : corner.inputs) {
        series.value.push_back(std::clamp(inputs.*member, signal.low, signal.high));
    }
    return series;
}

/// Of the disc at this wheel, from its share of the braking force. @param air K, a history
solver::Series brake_of(const physics::Signal& signal, const VehicleSettings& settings, const MotionHistory& motion,
                        const CornerHistory& corner, const solver::SignalHistory& air) {
    std::vector<double> power;
    for (std::size_t i = 0; i < motion.time.size(); ++i) {
        const CornerInputs& inputs = corner.inputs[i];
        const bool brakes = !motion.motion[i].brakes_released;
        power.push_back(brakes ? std::max(0.0, -inputs.longitudinal_force) * std::abs(inputs.speed) : 0.0);
    }
    solver::Series series{.signal = &signal, .time = motion.time, .value = {}, .logged = true};
    for (const double kelvin :
         physics::brake_temperature(settings.brake, motion.time, power, at_times(air, motion.time))) {
        series.value.push_back(std::clamp(kelvin, signal.low, signal.high));
    }
    return series;
}

std::string percent(double share) {
    return share < 0.1 ? fmt::format("{:.2g} %", 100.0 * share) : fmt::format("{:.0f} %", 100.0 * share);
}

/// What the model could not follow.
void warn_of_limits(const CornerSignals& signals, const VehicleSettings& settings, InputErrors& errors) {
    const CornerHistory& corner = signals.corners[static_cast<std::size_t>(settings.corner)];
    const std::string_view name = physics::corner_names[static_cast<std::size_t>(settings.corner)];
    if (corner.exceeds > 0.0) {
        errors.warn(settings.place,
                    fmt::format("at {}: the forces exceed what the tire can give in {} of the time: the slips are then "
                                "those of the highest force",
                                name, percent(corner.exceeds)));
    }
    if (corner.lifted > 0.0) {
        errors.warn(settings.place,
                    fmt::format("at {}: the wheel is in the air in {} of the time: the other wheels carry "
                                "its load",
                                name, percent(corner.lifted)));
    }
    if (signals.rolls_over > 0.0) {
        errors.warn(settings.place, fmt::format("the car would roll over in {} of the time: check the height of its "
                                                "centre of gravity, its tracks and the lateral acceleration",
                                                percent(signals.rolls_over)));
    }
}

}  // namespace

void read_vehicle(TomlTable& root, ProblemBuilder& builder) {
    InputErrors& errors = root.errors();
    const std::optional<VehicleSettings> settings = read_vehicle_settings(root, builder);
    const bool unreadable = builder.run && builder.run->unreadable;
    if (root.has("vehicle")) {
        builder.given.try_emplace("speed", root.place("vehicle"));  // without it, motion_of says so
    }
    if (!settings || unreadable) {
        // The inputs that it would have given are not missing.
        for (const Computed& one : computed) {
            if (root.has("vehicle")) {
                builder.given.try_emplace(std::string(signal_of(one.input).name), root.place("vehicle"));
            }
        }
        return;
    }
    const std::optional<VehicleLog> log = find_vehicle_log(builder, settings->place, errors);
    const std::optional<MotionHistory> motion = log ? motion_of(*settings, *log, errors) : std::nullopt;
    solver::InputSignals& inputs = builder.problem.input_signals;
    std::vector<std::string> names;
    std::vector<std::string> kept;
    CornerSignals signals;
    if (motion) {
        const physics::Signal& load = signal_of(&Inputs::vertical_load);
        MeasuredWheelHistories measured{.camber = history_of(inputs, signal_of(&Inputs::camber))};
        measured.vertical_load[static_cast<std::size_t>(settings->corner)] = history_of(inputs, load);
        signals = corner_signals(settings->vehicle, *motion, measured);
    }
    const CornerHistory& corner = signals.corners[static_cast<std::size_t>(settings->corner)];
    for (const Computed& one : computed) {
        const physics::Signal& signal = signal_of(one.input);
        const bool slip_ratio = one.input == &Inputs::slip_ratio;
        if (slip_ratio && (!settings->has_slip_ratio || builder.given.contains("slip_speed"))) {
            continue;
        }
        if (!builder.given.try_emplace(std::string(signal.name), settings->place).second) {
            kept.emplace_back(signal.name);
            continue;
        }
        names.emplace_back(signal.name);
        if (motion) {
            inputs.add(series_of(signal, one.member, *motion, corner));
        }
    }
    if (!motion) {
        return;
    }
    inputs.replace(series_of(signal_of(&Inputs::speed), &CornerInputs::speed, *motion, corner));
    const physics::Signal& disc = signal_of(&Inputs::brake_temperature);
    const solver::SignalHistory air = history_of(inputs, signal_of(&Inputs::air_temperature));
    if (!air.time.empty() && builder.given.try_emplace(std::string(disc.name), settings->place).second) {
        inputs.add(brake_of(disc, *settings, *motion, corner, air));
    }
    const std::string_view name = physics::corner_names[static_cast<std::size_t>(settings->corner)];
    if (!names.empty()) {
        errors.warn(settings->place,
                    fmt::format("at {}: {} {} computed from the motion of the car, and the speed of the "
                                "tire from that of the car and the yaw rate",
                                name, listed(names), names.size() > 1 ? "are" : "is"));
    }
    if (!kept.empty()) {
        errors.warn(settings->place, fmt::format("at {}: {} {} not computed: the case gives {}", name, listed(kept),
                                                 kept.size() > 1 ? "are" : "is", kept.size() > 1 ? "them" : "it"));
    }
    for (const std::string& source : motion->sources) {
        errors.warn(settings->place, source);
    }
    warn_of_limits(signals, *settings, errors);
}

}  // namespace tiretherm::input
