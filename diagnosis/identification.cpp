#include "diagnosis/identification.hpp"

#include <chrono>
#include <limits>

#include "diagnosis/fit.hpp"
#include "diagnosis/judgement.hpp"
#include "diagnosis/profile.hpp"

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
            fit.simulator().forget_steps();
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

}  // namespace

Identification identify(const cases::Experiment& experiment, const Observations& observations,
                        const IdentificationChoice& choice) {
    const auto begin = std::chrono::steady_clock::now();
    Identification result;
    Fit fit(experiment, observations);
    fit.simulator().tell(choice.progress);
    fit.take_stated_noise();
    const bool started = fit.move_to(fit.simulator().start());
    result.before = fit.now().simulated;
    if (!started || !settle(fit, result)) {
        result.status = fit.now().status;
        return result;
    }
    result.values = fit.values();
    result.after = fit.now().simulated;
    judge_numbers(fit, result, true);
    judge_channels(fit, result);
    if (choice.profile) {
        profile_intervals(fit.question(), result);
    }
    result.simulations = fit.simulator().simulations();
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return result;
}

}  // namespace tiretherm::diagnosis
