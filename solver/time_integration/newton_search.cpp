// SPDX-License-Identifier: BSD-3-Clause
// How much of a correction is made where it jumps over a kink of a law.
#include "solver/time_integration/newton.hpp"

#include <cmath>
#include <numeric>

namespace tiretherm::solver {

namespace {

/// Trials of one search along a correction.
constexpr int most_trials = 30;

}  // namespace

/// The residual along the correction at a share of it: zero where the heat balance, were it that of an energy, is at its
/// least on the way. @returns K J
double Newton::residual_along(const Stage& stage, std::span<const double> from, double share) {
    for (std::size_t i = 0; i < from.size(); ++i) {
        trial_[i] = from[i] + share * correction_[i];
    }
    system_->evaluate(trial_, stage.coefficients);
    find_residual(stage, trial_);
    return std::inner_product(residual_.begin(), residual_.end(), correction_.begin(), 0.0);
}

/// Shortens a correction that jumps over a kink of a law, such as a peak of c(T): enthalpies grow with temperature, so that
/// the residual along the correction falls, and the share of it is sought where that is nearly zero (regula falsi, Illinois).
void Newton::search_along_correction(const Stage& stage, std::span<const double> T) {
    const double start = std::inner_product(residual_.begin(), residual_.end(), correction_.begin(), 0.0);
    double share = 1.0;
    double low = 0.0;
    double at_low = start;
    double high = 1.0;
    double at_high = residual_along(stage, T, high);
    if (at_high > 0.0 || !(start > 0.0)) {
        return;
    }
    for (int trial = 0; trial < most_trials; ++trial) {
        const double chord = low + (high - low) * at_low / (at_low - at_high);
        share = std::isfinite(chord) && trial % 3 != 2 ? chord : 0.5 * (low + high);
        const double at_share = residual_along(stage, T, share);
        if (std::abs(at_share) <= 0.1 * start) {
            break;
        }
        if (at_share > 0.0) {
            low = share;
            at_low = at_share;
            at_high *= 0.5;
        } else {
            high = share;
            at_high = at_share;
            at_low *= 0.5;
        }
    }
    for (double& change : correction_) {
        change *= share;
    }
}

}  // namespace tiretherm::solver
