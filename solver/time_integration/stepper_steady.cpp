// SPDX-License-Identifier: BSD-3-Clause
// The steady state: by Newton's method, from nearer by where that strays.
#include <algorithm>

#include "solver/time_integration/stepper.hpp"

namespace tiretherm::solver {

/// Where Newton's method strays on its way to the steady state: steps of backward Euler, each ten times longer than the one
/// before, with the inputs held (pseudo-transient continuation; Kelley and Keyes, SIAM J. Numer. Anal. 35, 508-523, 1998).
/// @returns false where one of them is not found
bool Stepper::come_near_steady(const Newton::Stage& steady) {
    Newton::Stage step = steady;
    step.steady = step.closed = false;
    T_[1] = T_[0];
    system_.make_consistent(T_[1], step.coefficients);
    bool is_found = true;
    for (step.s = 1.0; is_found && step.s < 1e9; step.s *= 10.0) {
        system_.enthalpy(T_[1], known_);
        is_found = newton_.solve(step, T_[1]).ok();
    }
    std::fill(known_.begin(), known_.end(), 0.0);
    return is_found;
}

Status Stepper::solve_steady(double t) {
    forcing_.open(t, t);
    std::fill(known_.begin(), known_.end(), 0.0);
    T_[1] = T_[0];
    system_.make_consistent(T_[1], forcing_.stage(0));
    const Newton::Stage steady{.s = 1.0,
                               .known = known_,
                               .coefficients = forcing_.stage(0),
                               .time = t,
                               .tolerance = newton_share * problem_->settings.tolerance,
                               .steady = true};
    Status status = newton_.solve(steady, T_[1]);
    if (status.outcome == Outcome::not_converged && come_near_steady(steady)) {
        status = newton_.solve(steady, T_[1]);
    }
    if (!status.ok()) {
        return status;
    }
    update_heat_budget(0);
    now_.watts = stage_watts_.front();
    T_[0] = T_[1];
    std::fill(now_.left.begin(), now_.left.end(), 0.0);
    now_.end_is_known = false;
    for (std::vector<double>& stage : now_.last) {
        stage = T_[0];
    }
    find_stored();
    now_.time = now_.step_begin = t;
    return {};
}

}  // namespace tiretherm::solver
