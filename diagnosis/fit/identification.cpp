// SPDX-License-Identifier: BSD-3-Clause
// Alternates least squares and noise estimation until neither moves the other, then corrects the data of cameras for
// the grid's error, assesses the result and says what is unexpected about it.

#include "diagnosis/fit/identification.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "diagnosis/findings/parameter_findings.hpp"
#include "diagnosis/fit/doubt.hpp"
#include "diagnosis/fit/fit.hpp"
#include "diagnosis/fit/fit_assessment.hpp"
#include "diagnosis/fit/held_out.hpp"
#include "diagnosis/fit/profile.hpp"
#include "diagnosis/fit/refinement.hpp"
#include "diagnosis/noise/white_equivalent.hpp"
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

/// What was fitted, as numbers, channels and intervals.
void assess(const Fit& fit, Identification& into) {
    into.values = fit.values();
    into.after = fit.now().simulated;
    assess_parameters(fit, into, true);
    assess_channels(fit, into);
    into.simulations += fit.simulator().simulations();
}

/// A fit to data that are corrected for the error of grid and steps, as it is at the values of a fit before.
struct CorrectedFit {
    Eigen::VectorXd change;  ///< [n_rows] SI, of what is simulated
    Observations observations;
    Fit fit;

    CorrectedFit(Fit& rough, const input::Experiment& finer)
        : change(change_by_refinement({.experiment = rough.experiment(),
                                       .observations = rough.observations(),
                                       .values = rough.values(),
                                       .simulated = rough.now().simulated,
                                       .steps = rough.simulator().steps()},
                                      &finer)),
          observations(less(rough.observations(), change)),
          fit(rough.experiment(), observations) {
        fit.simulator().take_steps(rough.simulator().steps());
        fit.take_covariance(rough.covariance());
    }

    /// @returns false when the model fails
    bool settle(const Eigen::VectorXd& from, Identification& into) {
        into.simulations += 2 * static_cast<long>(observations.times.size());
        if (!fit.move_to(from)) {
            return false;
        }
        const Fit::Turn turn = fit.minimise_squares();
        into.iterations += turn.iterations;
        into.converged = into.converged && turn.converged;
        if (!fit.now().status.ok()) {
            return false;
        }
        fit.find_noise();
        return true;
    }

    /// What was simulated as it would be without the grid's error, in the place of data without it.
    void correct(Identification& into) const {
        into.before += change;
        into.after += change;
        for (NumberFit& number : into.numbers) {
            const double by = change[static_cast<Eigen::Index>(number.row)];
            number.measured += by;
            number.before += by;
            number.after += by;
        }
        const std::vector<double> largest = largest_changes(observations, change);
        for (ChannelFit& channel : into.channels) {
            for (std::size_t c = 0; c < largest.size(); ++c) {
                if (observations.channels[c] == channel.channel) {
                    channel.grid_error = std::max(channel.grid_error, largest[c]);
                }
            }
        }
    }

private:
    static Observations less(Observations observations, const Eigen::VectorXd& change) {
        observations.measured -= change;
        return observations;
    }
};

/// What the fitted parameters say, with the standard deviations that the noise makes: before intervals are widened.
std::vector<ParameterFinding> findings_of(const input::Experiment& experiment, const Identification& result) {
    std::vector<FittedParameter> fitted;
    std::vector<double> before;
    for (const Fitted& one : result.fitted) {
        fitted.push_back({.value = one.value,
                          .standard_deviation = one.standard_deviation,
                          .at_bound = one.identifiability == Identifiability::at_bound});
        before.push_back(one.before);
    }
    return parameter_findings(experiment, fitted, before);
}

/// Mean over the channels of the logarithm of the mean square: half of its differences is the relative change of the rms.
double log_error(const HeldOutErrors& out, const Observations& observations) {
    double sum = 0.0;
    for (std::size_t c = 0; c < observations.channels.size(); ++c) {
        sum += std::log(out.mean_square(observations, c)) / static_cast<double>(observations.channels.size());
    }
    return sum;
}

/// Where correlated noise is in doubt, the case is fitted with white noise of the same information as well, and the fit that
/// predicts data that were left out better is kept: slow noise may have swallowed what the model gets wrong.
/// @returns the noise of the fit that is kept
Covariance keep_better_noise(Fit& fit, Identification& into) {
    constexpr double better_by = 0.02;  // of the rms
    const Observations& observations = fit.observations();
    const bool in_doubt = std::ranges::any_of(into.channels, &ChannelFit::is_in_doubt);
    if (!in_doubt || fit.experiment().noise != "automatic" || !observations.images.empty()) {
        return fit.covariance();
    }
    Fit flat(fit.experiment(), observations);
    flat.simulator().take_steps(fit.simulator().steps());
    flat.take_covariance(white_equivalent(fit.covariance(), observations.blocks));
    if (!flat.move_to(fit.values())) {
        return fit.covariance();
    }
    const Refit slow = refit(fit, 0);
    const Refit even = refit(flat);
    const std::vector<std::vector<double>>& steps = fit.simulator().steps();
    const HeldOutErrors of_slow = held_out(fit.experiment(), observations, fit.covariance(), steps, slow);
    const HeldOutErrors of_even = held_out(fit.experiment(), observations, flat.covariance(), steps, even);
    into.simulations += flat.simulator().simulations() + of_slow.simulations + of_even.simulations;
    const double gain = 0.5 * (log_error(of_slow, observations) - log_error(of_even, observations));
    if (!of_even.ok || !(gain > better_by) || !flat.move_to(even.values)) {
        return fit.covariance();
    }
    into.values = flat.values();
    into.after = flat.now().simulated;
    assess_parameters(flat, into, true);
    const HeldOutErrors fitted{.left = observations.measured - into.after};
    for (std::size_t c = 0; c < into.channels.size(); ++c) {
        into.channels[c].rmse_after = std::sqrt(fitted.mean_square(observations, c));
    }
    into.white_noise_gain = gain;
    return flat.covariance();
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
    std::optional<CorrectedFit> corrected;
    if (choice.finer != nullptr) {
        stage = "fit that is corrected for the grid's error";
        corrected.emplace(fit, *choice.finer);
        if (!corrected->settle(fit.values(), result)) {
            result.status = {solver::Outcome::not_converged, "the fit that is corrected for the grid's error failed"};
            return;
        }
        result.simulations += fit.simulator().simulations();
    }
    Fit& last = corrected ? corrected->fit : fit;
    assess(last, result);
    if (observations.images.empty()) {
        stage = "comparison of correlated with white noise on data that are left out";
        Covariance kept = keep_better_noise(last, result);
        if (!choice.leave_out.empty()) {
            stage = "fits that leave something out";
            Fit everything(experiment, last.observations());
            everything.simulator().take_steps(last.simulator().steps());
            everything.take_covariance(std::move(kept));
            if (everything.move_to(result.values)) {
                result.left_out = leave_out_in_turn(everything, choice.leave_out, result.simulations);
            }
        }
    }
    if (choice.profile && result.white_noise_gain == 0.0) {
        stage = "search of the intervals by profile likelihood";
        const long before = last.simulator().simulations();
        profile_intervals(last.least_squares(), result);
        result.simulations += last.simulator().simulations() - before;
    }
    if (corrected) {
        widen(last.values() - fit.values(), last, result);
        if (observations.images.empty()) {
            corrected->correct(result);
        }
    }
    for (ParameterFinding& one : findings_of(experiment, result)) {
        doubt_beside(experiment.parameters[one.parameter], result);
        result.findings.push_back(std::move(one.remark));
    }
    for (const NamedFold& one : choice.leave_out) {
        const auto left = std::ranges::find(result.left_out, one.name, &LeftOut::name);
        if (left == result.left_out.end() || left->channels.empty()) {
            result.findings.push_back(remark::not_left_out(one.name));
        }
    }
    if (result.white_noise_gain > 0.0) {
        result.findings.insert(result.findings.begin(),
                               remark::white_noise_predicts_better(100.0 * (1.0 - std::exp(-result.white_noise_gain))));
    }
    widen_doubtful(experiment.parameters, result);
    doubt_input_numbers(experiment.parameters, result);
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
