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
#include "input/measurements/run_inputs.hpp"
#include "input/vehicle/at_times.hpp"
#include "physics/vehicle/local_mean.hpp"

namespace tiretherm::input {

namespace {

using Values = std::vector<double>;

constexpr std::size_t fewest = 20;    ///< samples
constexpr double moving = 3.0;        ///< m/s, that the speed of a car changes by which drives
constexpr double tail = 0.01;         ///< of the samples at either end, which may be knocks
constexpr double surely = 2.0;        ///< m/s2, span of an acceleration that other signals tell
constexpr double coasting = 3.0;      ///< m/s2, that no car slows by without its brakes
constexpr double slope_window = 1.0;  ///< s

/// How far a signal moves that is nothing but noise.
struct Noise {
    std::string_view name;
    double span = 0.0;  ///< SI
};
constexpr std::array noises{Noise{"longitudinal_acceleration", 0.5}, Noise{"lateral_acceleration", 0.5},
                            Noise{"yaw_rate", 0.02}, Noise{"steering_wheel_angle", 0.02}};

/// The width of the values but for a hundredth at either end.
double span(Values values) {
    if (values.size() < fewest) {
        return 0.0;
    }
    const auto cut = static_cast<std::ptrdiff_t>(tail * static_cast<double>(values.size()));
    std::nth_element(values.begin(), values.begin() + cut, values.end());
    const double low = values[static_cast<std::size_t>(cut)];
    std::nth_element(values.begin(), values.end() - 1 - cut, values.end());
    return values[values.size() - 1 - static_cast<std::size_t>(cut)] - low;
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
    if (is_constant) {
        return fmt::format("{} while the car moves", stands);
    }
    if (!moves_like_noise(signal.name, history) || told_by_others(signal.name, log) < surely) {
        return {};
    }
    return fmt::format("moves by no more than noise while other signals say that the car {}",
                       signal.name == "longitudinal_acceleration" ? "speeds up and brakes" : "turns");
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
        const std::vector<CarColumn> may_be = car_columns(heading.name);
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
