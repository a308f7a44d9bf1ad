// SPDX-License-Identifier: BSD-3-Clause
// Table of a car's signals; checks the unit and the size of each column that has one of their names.

#include "input/vehicle/vehicle_log.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "input/toml/toml_text.hpp"
#include "input/vehicle/at_times.hpp"
#include "input/vehicle/dead_channels.hpp"
#include "physics/vehicle/vehicle.hpp"

namespace tiretherm::input {

namespace {

constexpr std::array<VehicleSignal, 8> table{{
    {"longitudinal_acceleration", &VehicleLog::longitudinal_acceleration, "m s-2", "m/s2", "g", -80.0, 80.0,
     "positive when the car speeds up"},
    {"lateral_acceleration", &VehicleLog::lateral_acceleration, "m s-2", "m/s2", "g", -80.0, 80.0,
     "positive in left turns, or as lateral_acceleration_sign says"},
    {"yaw_rate", &VehicleLog::yaw_rate, "rad s-1", "rad/s", "deg/s", -6.0, 6.0,
     "positive in left turns, or as yaw_rate_sign says"},
    {"steering_wheel_angle", &VehicleLog::steering_wheel_angle, "rad", "rad", "deg", -30.0, 30.0,
     "positive to the left, or as steering_sign says"},
    {"brake_pressure", &VehicleLog::brake_pressure, "", "", "", 0.0, 0.0, "in any unit, 0 when the brakes are released",
     true},
    {"vertical_acceleration", &VehicleLog::vertical_acceleration, "m s-2", "m/s2", "g", -80.0, 80.0,
     "along the car's own vertical axis, with gravity or without"},
    {"bank", &VehicleLog::bank, "rad", "rad", "deg", -1.2, 1.2,
     "of the road across the car, positive where it helps in left turns, or as bank_sign says"},
    {"slope", &VehicleLog::slope, "rad", "rad", "deg", -0.6, 0.6, "of the road along the car, positive uphill"},
}};

/// Takes away samples that no car has, where they are so few that the sensor was knocked or a byte was lost.
/// @returns false after an error: more are a wrong unit
bool take_away_impossible(const VehicleSignal& signal, const SourceLocation& place, InputErrors& errors,
                          solver::SignalHistory& history) {
    constexpr double most_share = 0.01;
    constexpr double fewest = 3.0;  // in a short log, where they are a tenth at most
    constexpr double most_of_short = 0.1;
    std::vector<std::size_t> beyond;
    for (std::size_t i = 0; i < history.value.size(); ++i) {
        if (history.value[i] < signal.low || history.value[i] > signal.high) {
            beyond.push_back(i);
        }
    }
    if (beyond.empty()) {
        return true;
    }
    const auto n = static_cast<double>(history.value.size());
    const std::string what = fmt::format("{} is {:.6g} {} at {:.6g} s, beyond {:.6g} to {:.6g}, where no car is",
                                         signal.name, history.value[beyond.front()], signal.shown_unit,
                                         history.time[beyond.front()], signal.low, signal.high);
    if (static_cast<double>(beyond.size()) > std::max(most_share * n, std::min(fewest, most_of_short * n))) {
        errors.add(place, {.what = what,
                           .remedy = "look for a wrong unit of the column, or leave out the part with from and to",
                           .about = std::string(signal.name)});
        return false;
    }
    errors.warn(place, beyond.size() == 1
                           ? what + ": the sample is left out"
                           : fmt::format("{}: {} samples of this kind are left out", what, beyond.size()));
    std::ranges::reverse(beyond);
    for (const std::size_t i : beyond) {
        history.time.erase(history.time.begin() + static_cast<std::ptrdiff_t>(i));
        history.value.erase(history.value.begin() + static_cast<std::ptrdiff_t>(i));
    }
    return true;
}

/// @returns false after an error
bool take(const VehicleSignal& signal, const UserColumn& column, const SourceLocation& place, InputErrors& errors,
          solver::SignalHistory& into) {
    const std::optional<double> factor = factor_to(signal, column.unit);
    if (!factor) {
        const Dimension wanted = dimension(signal.unit, Scale::absolute);
        errors.add(place,
                   fmt::format("the column {} is {}; {} is wanted", signal.name,
                               column.unit == "1" ? "without a unit" : dimension(column.unit, Scale::absolute).name,
                               wanted.name),
                   fmt::format("write its unit into the heading, such as {} [{}], or units = {{ {} = \"{}\" }} into "
                               "[[run]]",
                               signal.name, signal.logged_unit, signal.name, signal.logged_unit));
        return false;
    }
    into = column.signal;
    std::ranges::for_each(into.value, [&](double& value) { value *= *factor; });
    return signal.unit.empty() || take_away_impossible(signal, place, errors, into);
}

/// Takes out channels that say nothing, with a remark each. A constant that alone says how the car turns may be a straight line or
/// a circle, and stays.
void leave_out_dead(const std::vector<UserColumn>& columns, VehicleLog& log) {
    std::vector<DeadChannel> dead = dead_channels(log);
    const auto is_alive = [&](std::string_view name) {
        return !(log.*member_of(name)).time.empty() && std::ranges::find(dead, name, &DeadChannel::name) == dead.end();
    };
    const bool turns_are_told = !log.course.course.time.empty() || is_alive("lateral_acceleration") ||
                                is_alive("yaw_rate") || is_alive("steering_wheel_angle");
    for (const DeadChannel& channel : dead) {
        const std::string& beside = find_column(columns, channel.name)->beside;
        ErrorText& remark = log.remarks.emplace_back();
        remark.about = channel.name;
        if (!turns_are_told && !is_along_the_car(channel.name) && beside.empty()) {
            remark.what = fmt::format("{} {}, and nothing else says how it turns: is a sensor connected?", channel.name,
                                      channel.why);
            continue;
        }
        log.*member_of(channel.name) = {};
        remark.what = fmt::format("{} {}: not used", channel.name, channel.why);
        if (!beside.empty()) {
            remark.remedy = fmt::format("take the column that moves: columns = {{ {} = \"{}\" }}",
                                        toml_text::key(beside), channel.name);
        }
    }
}

/// A remark on each channel that says nothing for a while. It is used nevertheless: what another signal makes of it has another
/// sign, perhaps.
void warn_of_stands(VehicleLog& log) {
    for (const DeadChannel& channel : dead_for_a_while(log)) {
        ErrorText& remark = log.remarks.emplace_back();
        remark.about = channel.name;
        remark.what = fmt::format("{} {}", channel.name, channel.why);
        remark.remedy =
            "if its sensor was lost, leave its column out, and the other signals are used: ignore = [\"...\"]";
    }
}

/// The car's speed as [drive] or the run's file gives it, as a history.
solver::SignalHistory speed_of(const solver::InputSignals& inputs) {
    const physics::Signal* speed = physics::find_signal("speed");
    for (const solver::Series& series : inputs.series()) {
        if (series.signal == speed) {
            return {.time = series.time, .value = series.value};
        }
    }
    return inputs.gives(*speed) ? solver::SignalHistory{.time = {0.0}, .value = {inputs.constants().speed}}
                                : solver::SignalHistory{};
}

}  // namespace

std::span<const VehicleSignal> vehicle_signals() { return table; }

bool is_along_the_car(std::string_view name) {
    return name != "lateral_acceleration" && name != "yaw_rate" && name != "steering_wheel_angle";
}

void add_vehicle_columns(const TomlValue& document, std::vector<std::string>& names) {
    for (const VehicleSignal& signal : table) {
        if (document.find("vehicle") != nullptr && std::ranges::find(names, signal.name) == names.end()) {
            names.emplace_back(signal.name);
        }
    }
}

std::optional<double> factor_to(const VehicleSignal& signal, const std::string& base) {
    if (signal.unit.empty() || signature(signal.unit) == base) {
        return 1.0;
    }
    // UDUNITS reads the g of an accelerometer as a gram.
    if (signature(signal.unit) == signature("m s-2") && base == "kg") {
        return 1e3 * physics::standard_gravity;
    }
    return std::nullopt;
}

solver::SignalHistory VehicleLog::*member_of(std::string_view name) {
    return std::ranges::find(table, name, &VehicleSignal::name)->member;
}

bool is_vehicle_signal(std::string_view name) {
    return std::ranges::find(table, name, &VehicleSignal::name) != table.end();
}

CourseOverGround where_it_drives(CourseOverGround course, const solver::SignalHistory& speed) {
    constexpr double slow = 2.0;  // m/s
    if (course.course.time.empty() || speed.time.empty()) {
        return {};
    }
    solver::SignalHistory driven;
    const std::vector<double> at = at_times(speed, course.course.time);
    for (std::size_t i = 0; i < at.size(); ++i) {
        if (std::abs(at[i]) >= slow) {
            driven.time.push_back(course.course.time[i]);
            driven.value.push_back(course.course.value[i]);
        }
    }
    course.course = driven.time.size() > 1 ? unwrapped(std::move(driven)) : solver::SignalHistory{};
    return course;
}

bool is_used_up_by_vehicle(std::string_view name) {
    const auto* const found = std::ranges::find(table, name, &VehicleSignal::name);
    return found != table.end() && !found->may_heat;
}

std::optional<VehicleLog> find_vehicle_log(const DrivenSignals& signals, const SourceLocation& place,
                                           InputErrors& errors) {
    VehicleLog log;
    bool sound = true;
    for (const VehicleSignal& signal : table) {
        const UserColumn* column = find_column(signals.columns, signal.name);
        if (column == nullptr) {
            continue;
        }
        if (column->signal.time.empty()) {
            sound = false;  // its gaps have been reported
            continue;
        }
        sound = take(signal, *column, place, errors, log.*signal.member) && sound;
    }
    log.speed = speed_of(signals.inputs);
    log.course = where_it_drives(signals.course, log.speed);
    leave_out_dead(signals.columns, log);
    warn_of_stands(log);
    return sound ? std::optional(std::move(log)) : std::nullopt;
}

}  // namespace tiretherm::input
