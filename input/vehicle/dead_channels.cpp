// SPDX-License-Identifier: BSD-3-Clause
// Compares how far each signal moves with how far the others say that it must have moved.

#include "input/vehicle/dead_channels.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <utility>

#include <fmt/format.h>

#include "input/loggers/car_columns.hpp"
#include "input/vehicle/at_times.hpp"
#include "input/vehicle/clock_shift.hpp"
#include "physics/vehicle/local_mean.hpp"
#include "physics/vehicle/vehicle.hpp"
#include "solver/order_statistics.hpp"

namespace tiretherm::input {

namespace {

using Values = std::vector<double>;

constexpr std::size_t fewest = 20;      ///< samples
constexpr double moving = 3.0;          ///< m/s, that the speed of a car changes by which drives
constexpr double tail = 0.01;           ///< of the samples at either end, which may be knocks
constexpr double surely = 2.0;          ///< m/s2, span of an acceleration that other signals tell
constexpr double coasting = 3.0;        ///< m/s2, that no car slows by without its brakes
constexpr double slope_window = 1.0;    ///< s
constexpr double shortest_stand = 3.0;  ///< s, in which a live signal has moved by a step of its converter

/// How far a signal moves that is nothing but noise.
struct Noise {
    std::string_view name;
    double span = 0.0;  ///< SI
};
constexpr std::array noises{Noise{"longitudinal_acceleration", 0.5}, Noise{"lateral_acceleration", 0.5},
                            Noise{"yaw_rate", 0.02}, Noise{"steering_wheel_angle", 0.02}};

/// The width of the values but for a hundredth at either end.
double span(const Values& values) {
    if (values.size() < fewest) {
        return 0.0;
    }
    const auto cut = static_cast<std::size_t>(tail * static_cast<double>(values.size()));
    return solver::nth_smallest(values, values.size() - 1 - cut) - solver::nth_smallest(values, cut);
}

double range(const Values& values) {
    const auto [low, high] = std::ranges::minmax(values);
    return high - low;
}

/// Slope of a signal at its times, each once.
Values slope_of(const solver::SignalHistory& history) {
    Values time = history.time;
    time.erase(std::unique(time.begin(), time.end()), time.end());
    return physics::local_slope(time, at_times(history, time), slope_window);
}

/// Span of the speed times a rate of turn, as an acceleration.
double span_of_turns(const VehicleLog& log, const Values& rate, const Values& time) {
    Values product = at_times(log.speed, time);
    std::ranges::transform(product, rate, product.begin(), std::multiplies<>());
    return span(std::move(product));
}

/// What the other signals say of one: the span of the acceleration that it belongs to, m/s2.
double told_by_others(std::string_view name, const VehicleLog& log) {
    const bool has_speed = log.speed.time.size() > 1;
    if (name == "longitudinal_acceleration") {
        return has_speed ? span(slope_of(log.speed)) : 0.0;
    }
    double told = name == "lateral_acceleration" ? 0.0 : span(log.lateral_acceleration.value);
    if (name != "yaw_rate" && has_speed && !log.yaw_rate.time.empty()) {
        told = std::max(told, span_of_turns(log, log.yaw_rate.value, log.yaw_rate.time));
    }
    if (const solver::SignalHistory& course = log.course.course; has_speed && course.time.size() > 1) {
        const Values rate = physics::local_slope(course.time, course.value, log.course.window(slope_window));
        told = std::max(told, span_of_turns(log, rate, course.time));
    }
    return told;
}

std::string why_dead(const VehicleSignal& signal, const solver::SignalHistory& history, const VehicleLog& log) {
    const bool is_constant = range(history.value) == 0.0;
    const std::string stands = fmt::format("stands at {:.4g} in all its samples", history.value.front());
    if (signal.unit.empty()) {
        const Values slope = slope_of(log.speed);
        return is_constant && *std::ranges::min_element(slope) < -coasting
                   ? fmt::format("{} while the car brakes", stands)
                   : "";
    }
    if (is_constant && (signal.name == "bank" || signal.name == "slope")) {
        return {};  // roads are like that
    }
    if (is_constant) {
        return fmt::format("{} while the car moves", stands);
    }
    if (!moves_like_noise(signal.name, history) || told_by_others(signal.name, log) < surely) {
        return {};
    }
    return fmt::format("moves by no more than noise while other signals say that the car {}",
                       signal.name == "longitudinal_acceleration" ? "speeds up and brakes" : "turns");
}

/// What another signal makes of the acceleration that one belongs to, at its times.
Told told_at_times(std::string_view name, const VehicleLog& log, const Values& time) {
    if (name == "longitudinal_acceleration") {
        Values once = log.speed.time;
        once.erase(std::unique(once.begin(), once.end()), once.end());
        return {.name = "the slope of speed",
                .acceleration = at_times({.time = std::move(once), .value = slope_of(log.speed)}, time)};
    }
    if (name == "yaw_rate" && !log.lateral_acceleration.time.empty()) {
        return {.name = "lateral_acceleration", .acceleration = at_times(log.lateral_acceleration, time)};
    }
    if (name == "lateral_acceleration" && !log.yaw_rate.time.empty()) {
        Values product = at_times(log.speed, time);
        std::ranges::transform(product, at_times(log.yaw_rate, time), product.begin(), std::multiplies<>());
        return {.name = "speed times yaw_rate", .acceleration = std::move(product)};
    }
    return {};
}

/// A part of a signal that stands, from its first sample to the last.
struct Stand {
    double from = 0.0;  ///< s
    double to = 0.0;    ///< s
    double told = 0.0;  ///< m/s2, by which the other signal moves meanwhile
};

/// The longest of those in which the other signal moves.
Stand longest_stand(const solver::SignalHistory& history, const Values& told) {
    Stand longest;
    for (std::size_t first = 0, end = 0; first < history.value.size(); first = end) {
        for (end = first + 1; end < history.value.size() && history.value[end] == history.value[first];) {
            ++end;
        }
        const double from = history.time[first];
        const double to = history.time[end - 1];
        if (to - from < std::max(shortest_stand, longest.to - longest.from)) {
            continue;
        }
        const auto [low, high] = std::minmax_element(told.begin() + static_cast<std::ptrdiff_t>(first),
                                                     told.begin() + static_cast<std::ptrdiff_t>(end));
        if (*high - *low > surely) {
            longest = {from, to, *high - *low};
        }
    }
    return longest;
}

}  // namespace

bool moves_like_noise(std::string_view name, const solver::SignalHistory& signal) {
    const auto noise = std::ranges::find(noises, name, &Noise::name);
    return noise != noises.end() && signal.value.size() >= fewest && span(signal.value) <= noise->span;
}

std::vector<DeadChannel> dead_channels(const VehicleLog& log) {
    std::vector<DeadChannel> dead;
    if (log.speed.time.size() < fewest || range(log.speed.value) < moving) {
        return dead;
    }
    for (const VehicleSignal& signal : vehicle_signals()) {
        const solver::SignalHistory& history = log.*member_of(signal.name);
        std::string why = history.time.size() < fewest ? "" : why_dead(signal, history, log);
        if (!why.empty()) {
            dead.push_back({.name = signal.name, .why = std::move(why)});
        }
    }
    return dead;
}

std::vector<DeadChannel> dead_for_a_while(const VehicleLog& log) {
    std::vector<DeadChannel> dead;
    if (log.speed.time.size() < fewest) {
        return dead;
    }
    for (const std::string_view name : {"longitudinal_acceleration", "lateral_acceleration", "yaw_rate"}) {
        const solver::SignalHistory& history = log.*member_of(name);
        const Told told = history.time.size() < fewest ? Told{} : told_at_times(name, log, history.time);
        if (told.acceleration.empty()) {
            continue;
        }
        if (const Stand stand = longest_stand(history, told.acceleration); stand.to > stand.from) {
            dead.push_back(
                {.name = name,
                 .why = fmt::format("stands still from {:.6g} s to {:.6g} s while {} moves by {:.2g} g", stand.from,
                                    stand.to, told.name, stand.told / physics::standard_gravity)});
        }
    }
    return dead;
}

std::string live_column_beside(const DataFile& file, int used, const UserColumn& column,
                               const std::vector<double>& time, const InputErrors& errors) {
    const auto signal = std::ranges::find(vehicle_signals(), column.name, &VehicleSignal::name);
    const auto is_dead = [&](solver::SignalHistory history, const std::string& base) {
        const double factor = factor_to(*signal, base).value_or(1.0);
        std::ranges::for_each(history.value, [&](double& value) { value *= factor; });
        return history.value.size() < fewest || range(history.value) == 0.0 || moves_like_noise(signal->name, history);
    };
    if (signal == vehicle_signals().end() || !is_dead(column.signal, column.unit)) {
        return {};
    }
    for (std::size_t i = 0; i < file.heads().size(); ++i) {
        const Heading& heading = file.heads()[i].heading;
        const std::string base = base_unit(heading.unit);
        const std::vector<CarColumn> may_be = car_columns(heading);
        if (std::cmp_equal(i, used) || std::ranges::find(may_be, signal->name, &CarColumn::name) == may_be.end() ||
            (heading.unit && !factor_to(*signal, base))) {
            continue;
        }
        InputErrors unheard = errors;
        const std::vector<std::vector<double>> read = file.read(
            {{.column = static_cast<int>(i), .name = "", .spec = {.unit = base}, .purpose = Purpose::unused}}, unheard);
        if (!read.empty() && read.front().size() == time.size() && !is_dead(known_samples(time, read.front()), base)) {
            return heading.name;
        }
    }
    return {};
}

}  // namespace tiretherm::input
