// SPDX-License-Identifier: BSD-3-Clause
// Evaluates the car's model at each sample and counts the time in which it is beyond its limits.

#include "input/vehicle/corner_signals.hpp"

#include <algorithm>

#include "input/vehicle/at_times.hpp"

namespace tiretherm::input {

AxleHistory axle_history(const physics::Vehicle& vehicle, physics::Corner corner, const MotionHistory& motion,
                         const MeasuredWheelHistories& measured) {
    AxleHistory axle;
    const std::vector<double>& time = motion.time;
    const auto read = [&](const solver::SignalHistory& of) {
        return of.time.empty() ? std::vector<double>{} : at_times(of, time);
    };
    const std::vector<double> camber = read(measured.camber);
    const std::vector<double> load = read(measured.vertical_load);
    const auto at = static_cast<std::size_t>(corner);
    const double length = time.back() - time.front();
    const std::size_t left = at - at % axle.size();
    for (CornerHistory& history : axle) {
        history.inputs.reserve(time.size());
    }
    for (std::size_t i = 0; i < time.size(); ++i) {
        physics::MeasuredWheels wheels{.camber = camber.empty() ? 0.0 : camber[i]};
        wheels.vertical_load[at] = load.empty() ? std::nullopt : std::optional(load[i]);
        const physics::VehicleMoment moment =
            physics::vehicle_moment(vehicle, motion.motion[i], wheels, physics::axle_of(at));
        // Each sample stands for the time half way to its neighbours.
        const double share = 0.5 * (time[std::min(i + 1, time.size() - 1)] - time[i > 0 ? i - 1 : 0]) / length;
        for (std::size_t side = 0; side < axle.size(); ++side) {
            CornerHistory& history = axle[side];
            const physics::CornerInputs& inputs = moment.corners[left + side];
            history.inputs.push_back(inputs);
            history.lifted += inputs.lifted ? share : 0.0;
            history.exceeds += inputs.exceeds ? share : 0.0;
            history.rolls_over += moment.rolls_over ? share : 0.0;
        }
    }
    return axle;
}

}  // namespace tiretherm::input
