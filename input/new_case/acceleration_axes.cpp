// SPDX-License-Identifier: BSD-3-Clause
// Correlates accelerations with the slope of speed.

#include "input/new_case/acceleration_axes.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "input/columns/column_course.hpp"
#include "input/loggers/car_columns.hpp"
#include "input/vehicle/at_times.hpp"
#include "physics/vehicle/local_mean.hpp"
#include "physics/vehicle/vehicle.hpp"

namespace tiretherm::input {

void settle_axes(Log& log, const VehicleLog& of_car) {
    constexpr double window = 2.0;  // s
    constexpr double sure = 0.5;    // correlation
    const solver::SignalHistory& speed = of_car.speed;
    const auto find = [&](std::string_view name) {
        const auto found = std::ranges::find_if(log.columns, [&](const LogColumn& column) {
            return column.name == name && names_an_axis(column.heading.name);
        });
        return found == log.columns.end() ? nullptr : &*found;
    };
    if (LogColumn* z = find("vertical_acceleration")) {
        constexpr double near = 0.2;  // g
        const std::vector<double>& value = of_car.vertical_acceleration.value;
        const double mean = std::accumulate(value.begin(), value.end(), 0.0) / static_cast<double>(value.size());
        if (!(std::abs(std::abs(mean) / physics::standard_gravity - 1.0) < near)) {
            z->drop("its mean is not that of gravity: whether it points upwards is not known");
        }
    }
    LogColumn* x = find("longitudinal_acceleration");
    LogColumn* y = find("lateral_acceleration");
    const auto follows = [&](const LogColumn* column) {
        if (column == nullptr || speed.time.size() < 3) {
            return 0.0;
        }
        const std::vector<double> acceleration = at_times(of_car.*member_of(column->name), speed.time);
        return std::abs(correlation(physics::local_mean(speed.time, acceleration, window),
                                    physics::local_slope(speed.time, speed.value, window)));
    };
    const double of_x = follows(x);
    const double of_y = follows(y);
    const bool lies_across = of_y > sure && of_y > of_x;
    for (LogColumn* column : {x, y}) {
        if (column != nullptr && std::max(of_x, of_y) <= sure) {
            column->drop(
                "it does not follow the slope of speed, nor does another axis: how the logger lies is not known");
        } else if (column != nullptr && lies_across) {
            column->name = column == x ? "lateral_acceleration" : "longitudinal_acceleration";
        }
    }
}

}  // namespace tiretherm::input
