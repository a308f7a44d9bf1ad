// SPDX-License-Identifier: BSD-3-Clause
// Evaluates the car's model at each sample and counts the time in which it is beyond its limits.

#include "input/vehicle/corner_signals.hpp"

#include <algorithm>

#include "input/vehicle/at_times.hpp"

namespace tiretherm::input {

CornerSignals corner_signals(const physics::Vehicle& vehicle, const MotionHistory& motion,
                             const MeasuredWheelHistories& measured) {
    CornerSignals signals;
    const std::vector<double>& time = motion.time;
    const auto read = [&](const solver::SignalHistory& history) {
        return history.time.empty() ? std::vector<double>{} : at_times(history, time);
    };
    const std::vector<double> camber = read(measured.camber);
    std::array<std::vector<double>, physics::n_corners> loads;
    std::ranges::transform(measured.vertical_load, loads.begin(), read);
    const double length = time.back() - time.front();
    for (std::size_t i = 0; i < time.size(); ++i) {
        physics::MeasuredWheels wheels{.camber = camber.empty() ? 0.0 : camber[i]};
        for (std::size_t corner = 0; corner < physics::n_corners; ++corner) {
            if (!loads[corner].empty()) {
                wheels.vertical_load[corner] = loads[corner][i];
            }
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
