// SPDX-License-Identifier: BSD-3-Clause
// Closes the heat budget of a stage: constants by which all temperatures move, beside or after the corrections.
#include "solver/time_integration/newton.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/parallel.hpp"
#include "solver/time_integration/stopwatch.hpp"

namespace tiretherm::solver {

namespace {

/// The share of the heat turned over in a stage by which its heat budget may fail to close.
constexpr double energy_closure = 1e-11;
/// A move of all temperatures from which the slope of the balance is learnt whatever it is. K
constexpr double smallest_learnt = 1e-9;

}  // namespace

/// Whether the heat budget of the stage closes: the balance of the whole mesh, beside the heat turned over and the
/// round-off of the enthalpies that it is a difference of.
bool Newton::closes_heat_budget(const Stage& stage) const {
    double turnover = 0.0;
    for (const double w : system_->terms().watts) {
        turnover += std::abs(w);
    }
    return std::abs(system_->of_budget(residual_)) <= energy_closure * stage.s * turnover + 4e-16 * sum_of(enthalpy_);
}

/// Moves all temperatures alike until the heat budget closes. @returns false where that does not lead there
bool Newton::close_by_shifts(const Stage& stage, std::span<double> T) {
    now_.last_shift = 0.0;
    for (int shift = 0; shift < max_stalled / 2; ++shift) {
        if (closes_heat_budget(stage)) {
            return true;
        }
        shift_all(T);
        if (!evaluate(stage, T).ok()) {
            return false;
        }
    }
    return closes_heat_budget(stage);
}

/// One correction with the matrices at hand, and the constant that closes the balance of the whole mesh. @returns the
/// largest change, K
double Newton::polish(std::span<double> T) {
    const Stopwatch watch(timed_ ? &now_.counters.solve_seconds : nullptr);
    now_.last_shift = 0.0;
    factors_.current().solve(residual_, correction_);
    ++now_.counters.linear_iterations;
    J_.multiply(correction_, remainder_);
    const double left = system_->of_budget(residual_) - system_->of_budget(remainder_);
    const double shift = now_.weight != 0.0 ? left / now_.weight : 0.0;
    return largest_over_nodes(T.size(),
                              [&](std::size_t i) {
                                  T[i] += correction_[i] + shift;
                                  return std::abs(correction_[i] + shift);
                              })
        .value;
}

/// Moves every temperature by the constant that closes the balance of the whole mesh, whose slope is learnt from one
/// such move to the next. @returns K
double Newton::shift_all(std::span<double> T) {
    const double joules = system_->of_budget(residual_);
    if (now_.last_shift != 0.0) {
        const double slope = (now_.last_joules - joules) / now_.last_shift;
        // Of a move near round-off only what is plausible; of a larger one anything that rises: a law may have a kink there.
        const bool kink = std::abs(now_.last_shift) > smallest_learnt && slope > 0.0;
        now_.weight = kink || (slope > 0.5 * now_.weight && slope < 2.0 * now_.weight) ? slope : now_.weight;
    }
    now_.last_joules = joules;
    now_.last_shift = now_.weight != 0.0 ? joules / now_.weight : 0.0;
    over_nodes(T.size(), [&](std::size_t i) { T[i] += now_.last_shift; });
    return std::abs(now_.last_shift);
}

/// Shifts the correction by the constant that makes the linearised balance of the whole mesh exact. @returns its size, K
double Newton::close_linearised_budget() {
    J_.multiply(ones_, J_ones_);
    now_.weight = system_->of_budget(J_ones_);
    const double shift = now_.weight != 0.0 ? system_->of_budget(remainder_) / now_.weight : 0.0;
    return largest_over_nodes(correction_.size(),
                              [&](std::size_t i) {
                                  correction_[i] += shift;
                                  return std::abs(correction_[i]);
                              })
        .value;
}

}  // namespace tiretherm::solver
