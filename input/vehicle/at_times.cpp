// SPDX-License-Identifier: BSD-3-Clause
// One pass through a history whose times ascend, for times that ascend.

#include "input/vehicle/at_times.hpp"

#include <algorithm>
#include <cmath>

namespace tiretherm::input {

std::vector<double> clock_of(const VehicleLog& log) {
    std::vector<double> time;
    double from = -INFINITY;
    double to = INFINITY;
    for (const auto* history : {&log.speed, &log.longitudinal_acceleration, &log.lateral_acceleration, &log.yaw_rate,
                                &log.steering_wheel_angle}) {
        if (history->time.size() > 1) {
            time.insert(time.end(), history->time.begin(), history->time.end());
            from = std::max(from, history->time.front());
            to = std::min(to, history->time.back());
        }
    }
    std::ranges::sort(time);
    time.erase(std::unique(time.begin(), time.end()), time.end());
    std::erase_if(time, [&](double t) { return t < from || t > to; });
    return time;
}

std::vector<double> at_times(const solver::SignalHistory& history, const std::vector<double>& time) {
    std::vector<double> value(time.size());
    std::size_t i = 0;
    for (std::size_t k = 0; k < time.size(); ++k) {
        while (i + 1 < history.time.size() && history.time[i + 1] <= time[k]) {
            ++i;
        }
        const bool between = i + 1 < history.time.size() && time[k] > history.time[i];
        value[k] = between
                       ? history.value[i] + (history.value[i + 1] - history.value[i]) * (time[k] - history.time[i]) /
                                                (history.time[i + 1] - history.time[i])
                       : history.value[i];
    }
    return value;
}

}  // namespace tiretherm::input
