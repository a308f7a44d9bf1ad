// SPDX-License-Identifier: BSD-3-Clause
// Evaluates the car's model at each sample and counts the time in which it is beyond its limits.

#include "input/vehicle/corner_signals.hpp"

#include <algorithm>

namespace tiretherm::input {

namespace {

/// A history read off at times that ascend.
class Reading {
public:
    explicit Reading(const solver::SignalHistory& history) : history_(history) {}
    [[nodiscard]] std::optional<double> at(double t) {
        const std::vector<double>& time = history_.time;
        if (time.empty()) {
            return std::nullopt;
        }
        while (at_ + 1 < time.size() && time[at_ + 1] <= t) {
            ++at_;
        }
        const double value = history_.value[at_];
        return at_ + 1 == time.size() || t <= time[at_]
                   ? value
                   : value + (history_.value[at_ + 1] - value) * (t - time[at_]) / (time[at_ + 1] - time[at_]);
    }

private:
    const solver::SignalHistory& history_;
    std::size_t at_ = 0;
};

}  // namespace

CornerSignals corner_signals(const physics::Vehicle& vehicle, const MotionHistory& motion,
                             const MeasuredWheelHistories& measured) {
    CornerSignals signals;
    std::vector<Reading> loads(measured.vertical_load.begin(), measured.vertical_load.end());
    Reading camber(measured.camber);
    const std::vector<double>& time = motion.time;
    const double length = time.back() - time.front();
    for (std::size_t i = 0; i < time.size(); ++i) {
        physics::MeasuredWheels wheels{.camber = camber.at(time[i]).value_or(0.0)};
        for (std::size_t corner = 0; corner < physics::n_corners; ++corner) {
            wheels.vertical_load[corner] = loads[corner].at(time[i]);
        }
        const physics::VehicleMoment moment = physics::vehicle_moment(vehicle, motion.motion[i], wheels);
        // Each sample stands for the time half way to its neighbours.
        const double share = 0.5 * (time[std::min(i + 1, time.size() - 1)] - time[i > 0 ? i - 1 : 0]) / length;
        signals.rolls_over += moment.rolls_over ? share : 0.0;
        for (std::size_t corner = 0; corner < physics::n_corners; ++corner) {
            CornerHistory& history = signals.corners[corner];
            history.inputs.push_back(moment.corners[corner]);
            history.lifted += moment.corners[corner].lifted ? share : 0.0;
            history.exceeds += moment.corners[corner].exceeds ? share : 0.0;
        }
    }
    return signals;
}

}  // namespace tiretherm::input
