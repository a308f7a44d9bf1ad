// SPDX-License-Identifier: BSD-3-Clause
// Thresholds of speed, slip and deceleration that separate the driving phases; the deceleration is taken over 2 s
// before and after.

#include "diagnosis/compare/phase.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tiretherm::diagnosis {

namespace {

constexpr double standing_speed = 0.1;                       // m/s
constexpr double slip_angle = 0.3 * std::numbers::pi / 180;  // rad
constexpr double slip_ratio = 0.005;
constexpr double slowing_down = 0.01 * 9.81;  // m/s2
constexpr double force_of_load = 0.15;
/// s before and after, over which the fall of speed is taken: a logger's noise of 0.1 m/s gives 0.035 m/s2.
constexpr double reach = 2.0;

}  // namespace

bool has_forces(const input::MeasuredRun& run) {
    const solver::InputSignals& signals = run.problem.input_signals;
    return !run.corner.empty() && signals.gives(*physics::find_signal("vertical_load")) &&
           signals.gives(*physics::find_signal("lateral_force"));
}

Phase phase_at(const solver::Problem& problem, double time, const physics::Inputs& now, bool of_car) {
    if (std::abs(now.speed) < standing_speed) {
        return Phase::standing;
    }
    if (of_car) {
        const double along = std::abs(now.longitudinal_force);
        const double across = std::abs(now.lateral_force);
        if (std::hypot(along, across) < force_of_load * now.vertical_load) {
            return Phase::straight;
        }
        return across > along ? Phase::cornering : now.longitudinal_force < 0.0 ? Phase::braking : Phase::driving;
    }
    if (std::abs(now.slip_angle) >= slip_angle || std::abs(now.slip_ratio) >= slip_ratio) {
        return Phase::slipping;
    }
    const double before = std::max(problem.settings.start, time - reach);
    const double after = std::min(problem.settings.end, time + reach);
    const double fall = std::abs(problem.input_signals.at(before, solver::JumpSide::after).speed) -
                        std::abs(problem.input_signals.at(after, solver::JumpSide::before).speed);
    return fall > slowing_down * (after - before) ? Phase::slowing : Phase::free_rolling;
}

}  // namespace tiretherm::diagnosis
