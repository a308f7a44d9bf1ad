// SPDX-License-Identifier: BSD-3-Clause
// Planes of the road from bank and slope; what carries the car, from them or from an accelerometer with gravity or without.

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include <fmt/format.h>

#include "input/columns/column_course.hpp"
#include "input/vehicle/at_times.hpp"
#include "input/vehicle/turn_signs.hpp"
#include "input/vehicle/vehicle_motion.hpp"
#include "physics/vehicle/local_mean.hpp"

namespace tiretherm::input {

namespace {

constexpr double g = physics::standard_gravity;

/// A column of the log as the other signals are smoothed, or a constant. @returns [n] of the times
std::vector<double> column_or(const solver::SignalHistory& logged, double constant, const VehicleSettings& settings,
                              const std::vector<double>& time) {
    return logged.time.empty() ? std::vector<double>(time.size(), constant)
                               : physics::local_mean(time, at_times(logged, time), settings.smoothing);
}

/// Roads lean into their turns. @param turn [n] m/s2 to the left; empty: not known
TurnSign sign_of_bank(const std::vector<double>& bank, const std::vector<double>& turn, TurnSign stated,
                      std::vector<std::string>& said) {
    constexpr double sure = 0.5;  // correlation
    const double r = turn.empty() ? 0.0 : correlation(bank, turn);
    const bool is_seen = stated == TurnSign::automatic && std::abs(r) > sure;
    const TurnSign sign = !is_seen ? stated : r < 0.0 ? TurnSign::right : TurnSign::left;
    said.push_back(fmt::format(
        "bank is taken as helping in {} turns where it is positive{}", input::turns(sign),
        is_seen ? fmt::format(": its correlation with the turns is {:.2f}", r) : std::string(" (bank_sign)")));
    return sign;
}

/// Mean over what is read where the car goes nearly straight, where gravity is all that there is. m/s2
double mean_ahead(const std::vector<double>& vertical, const std::vector<double>& lateral) {
    constexpr double straight = 0.1 * g;
    constexpr std::size_t enough = 10;
    std::vector<double> ahead;
    for (std::size_t i = 0; i < vertical.size(); ++i) {
        if (std::abs(lateral[i]) < straight) {
            ahead.push_back(vertical[i]);
        }
    }
    const std::vector<double>& seen = ahead.size() < enough ? vertical : ahead;
    return std::accumulate(seen.begin(), seen.end(), 0.0) / static_cast<double>(seen.size());
}

}  // namespace

std::vector<double> Road::for_tires(std::vector<double> turn) const {
    for (std::size_t i = 0; i < planes.size(); ++i) {
        turn[i] -= planes[i].across();
    }
    return turn;
}

std::vector<double> Road::of_tires(std::vector<double> read) const {
    for (std::size_t i = 0; i < planes.size(); ++i) {
        read[i] += planes[i].across();
    }
    return read;
}

std::vector<double> Road::uphill(std::vector<double> rate) const {
    for (std::size_t i = 0; i < along.size(); ++i) {
        rate[i] += along[i];
    }
    return rate;
}

Road road_of(const VehicleSettings& settings, const VehicleLog& log, const CarOnRoad& car,
             std::vector<std::string>& said) {
    constexpr double slope_of_slope = 1.0;  // s, over which crests and dips are seen
    const bool has_column = !log.bank.time.empty() || !log.slope.time.empty();
    const bool is_level = !has_column && settings.bank == 0.0 && settings.slope == 0.0;
    if (is_level || car.speed.size() != car.time.size()) {
        return {};
    }
    std::vector<double> bank = column_or(log.bank, settings.bank, settings, car.time);
    const std::vector<double> slope = column_or(log.slope, settings.slope, settings, car.time);
    if (!log.bank.time.empty()) {
        std::vector<double> turn = car.turns;
        for (std::size_t i = 0; i < turn.size(); ++i) {
            turn[i] *= car.speed[i];
        }
        if (sign_of_bank(bank, turn, settings.bank_sign, said) == TurnSign::right) {
            std::ranges::transform(bank, bank.begin(), std::negate<>());
        }
    }
    const std::vector<double> rise =
        physics::local_slope(car.time, slope, std::max(slope_of_slope, settings.smoothing));
    Road road;
    for (std::size_t i = 0; i < bank.size(); ++i) {
        road.planes.push_back({.bank = bank[i], .gravity = g * std::cos(slope[i]) + car.speed[i] * rise[i]});
        road.along.push_back(g * std::sin(slope[i]));
    }
    return road;
}

std::optional<std::vector<double>> vertical_motion(const VehicleSettings& settings, const VehicleLog& log,
                                                   const CarOnPlane& car, std::vector<std::string>& said,
                                                   InputErrors& errors) {
    constexpr double clear = 0.35;  // g, of a mean beside 0 and 1
    std::vector<double> vertical;
    if (log.vertical_acceleration.time.empty()) {
        for (std::size_t i = 0; i < car.road.planes.size(); ++i) {
            vertical.push_back(car.road.planes[i].vertical_acceleration(car.lateral[i]));
        }
        if (!vertical.empty()) {
            const auto [least, most] = std::ranges::minmax(vertical);
            said.push_back(
                fmt::format("the loads follow bank and slope: the wheels carry {:.2f} to {:.2f} times the weight "
                            "of the car, but for the air",
                            least / g, most / g));
        }
        return vertical;
    }
    vertical = column_or(log.vertical_acceleration, 0.0, settings, car.time);
    const double mean = mean_ahead(vertical, car.lateral) / g;
    const double whole = std::round(mean);
    const bool is_clear = std::abs(mean - whole) < clear && std::abs(whole) <= 1.0;
    const bool contains = settings.has_gravity.value_or(whole != 0.0);
    if (is_clear ? contains != (whole != 0.0) : !settings.has_gravity) {
        errors.add(
            settings.place,
            {.what = fmt::format(
                 "vertical_acceleration is {:.2g} g where the car goes straight, {}", mean,
                 is_clear ? "and vertical_acceleration_has_gravity says otherwise" : "neither near 0 nor near 1 g"),
             .remedy = "correct the unit of the column, or write vertical_acceleration_has_gravity = true, or false "
                       "for a column that is about 0 there",
             .about = "vertical_acceleration"});
        return std::nullopt;
    }
    const bool points_down = contains && mean < 0.0;
    for (double& value : vertical) {
        value = (points_down ? -value : value) + (contains ? 0.0 : g);
    }
    said.push_back(fmt::format("vertical_acceleration {} gravity: it is {:.2f} g where the car goes straight{}",
                               contains ? "contains" : "does not contain", mean,
                               points_down ? ", points down and is turned round"
                               : contains  ? ""
                                           : "; gravity is added, and up is taken as positive (ISO 8855)"));
    return vertical;
}

}  // namespace tiretherm::input
