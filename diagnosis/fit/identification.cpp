// SPDX-License-Identifier: BSD-3-Clause
// Alternates least squares and noise estimation until neither moves the other, then corrects the data of cameras for
// the grid's error and assesses the result.

#include "diagnosis/fit/identification.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "diagnosis/fit/fit.hpp"
#include "diagnosis/fit/fit_assessment.hpp"
#include "diagnosis/fit/profile.hpp"
#include "diagnosis/fit/refinement.hpp"
#include "solver/stop_signal.hpp"

namespace tiretherm::diagnosis {

namespace {

/// Turns of fit and noise at most; two are the rule.
constexpr int most_turns = 8;
/// Neither the noise nor a number moves the other further than this: relative, and in standard deviations.
constexpr double settled_noise = 0.01;
constexpr double settled_number = 0.05;

/// Fit and noise in turn until neither moves the other. @returns false when the model fails
bool settle(Fit& fit, Identification& into) {
    into.converged = false;
    for (int turn = 0; turn < most_turns && !into.converged; ++turn) {
        Fit::Turn made = fit.minimise_squares();
        into.iterations += made.iterations;
        if (turn == 0) {  // steps as the fitted values want them
            fit.simulator().clear_steps();
            made.moved = std::numeric_limits<double>::infinity();
            if (fit.now().status.ok() && !fit.move_to(fit.values())) {
                return false;
            }
        }
        if (!fit.now().status.ok()) {
            return false;
        }
        const Covariance before = fit.covariance();
        fit.find_noise();
        into.converged =
            made.converged && made.moved <= settled_number && change(before, fit.covariance()) <= settled_noise;
    }
    return true;
}

/// A correction by Richardson's rule leaves a quarter of the error at most, as another halving would change a quarter of
/// what the last one did.
constexpr double left_over = 0.25;

/// What is left of the grid's error belongs to the interval.
void widen(const Eigen::VectorXd& moved, const Fit& fit, Identification& into) {
    for (std::size_t j = 0; j < into.fitted.size(); ++j) {
        Fitted& one = into.fitted[j];
        const auto i = static_cast<Eigen::Index>(j);
        one.by_grid = moved[i];
        if (!(one.standard_deviation > 0.0) || !std::isfinite(one.standard_deviation)) {
            continue;
        }
        const double wider = std::hypot(1.0, left_over * moved[i] / one.standard_deviation);
        one.standard_deviation *= wider;
        one.low = std::max(fit.low()[i], one.value - (one.value - one.low) * wider);
        one.high = std::min(fit.high()[i], one.value + (one.high - one.value) * wider);
    }
}

/// The data less the error of grid and steps, at the values that were fitted.
Observations corrected(Fit& fit, const input::Experiment& finer) {
    Observations observations = fit.observations();
    observations.measured -= change_by_refinement({.experiment = fit.experiment(),
                                                   .observations = fit.observations(),
                                                   .values = fit.values(),
                                                   .simulated = fit.now().simulated,
                                                   .steps = fit.simulator().steps()},
                                                  &finer);
    return observations;
}

/// What was fitted, as numbers, channels and intervals.
void assess(const Fit& fit, Identification& into) {
    into.values = fit.values();
    into.after = fit.now().simulated;
    assess_parameters(fit, into, true);
    assess_channels(fit, into);
    into.simulations += fit.simulator().simulations();
}

/// Fits again to data that are corrected for the grid's error. @returns false when the model fails
bool settle_corrected(Fit& rough, const input::Experiment& finer, Identification& into) {
    const Observations observations = corrected(rough, finer);
    Fit fit(rough.experiment(), observations);
    fit.simulator().take_steps(rough.simulator().steps());
    fit.take_covariance(rough.covariance());
    into.simulations += rough.simulator().simulations() + 2 * static_cast<long>(observations.times.size());
    if (!fit.move_to(rough.values())) {
        return false;
    }
    const Fit::Turn turn = fit.minimise_squares();
    into.iterations += turn.iterations;
    into.converged = into.converged && turn.converged;
    if (!fit.now().status.ok()) {
        return false;
    }
    fit.find_noise();
    assess(fit, into);
    widen(fit.values() - rough.values(), fit, into);
    return true;
}

/// @param stage out: what is being done
void identify(const input::Experiment& experiment, const Observations& observations,
              const IdentificationOptions& choice, Identification& result, const char*& stage) {
    Fit fit(experiment, observations);
    fit.simulator().on_progress(choice.progress);
    fit.take_stated_noise();
    const bool started = fit.move_to(fit.simulator().start());
    result.before = fit.now().simulated;
    if (!started || !settle(fit, result)) {
        result.status = fit.now().status;
        return;
    }
    if (choice.finer != nullptr && !observations.images.empty()) {
        stage = "fit that is corrected for the grid's error";
        if (!settle_corrected(fit, *choice.finer, result)) {
            result.status = {solver::Outcome::not_converged, "the fit that is corrected for the grid's error failed"};
            return;
        }
    } else {
        assess(fit, result);
    }
    if (choice.profile) {
        stage = "search of the intervals by profile likelihood";
        profile_intervals(fit.least_squares(), result);
        result.simulations = fit.simulator().simulations();
    }
}

}  // namespace

Identification identify(const input::Experiment& experiment, const Observations& observations,
                        const IdentificationOptions& choice) {
    const auto begin = std::chrono::steady_clock::now();
    Identification result;
    const char* stage = "fit";
    try {
        // Images are corrected for the errors of grid and steps together.
        const bool by_images = !observations.images.empty();
        const input::Experiment fine = by_images ? experiment : with_fine_steps(experiment);
        identify(fine, observations, choice, result, stage);
    } catch (const solver::Interrupted&) {
        result.status = {solver::Outcome::stopped, fmt::format("stopped during the {}", stage)};
    }
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return result;
}

}  // namespace tiretherm::diagnosis
