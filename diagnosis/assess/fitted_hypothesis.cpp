// SPDX-License-Identifier: BSD-3-Clause
// Chooses hypotheses by the gain of the linearised model, fits the likely ones in full, alone and in pairs, and tests
// what is left of the residuals.

#include "diagnosis/assess/fitted_hypothesis.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include "mesh/parallel.hpp"

namespace tiretherm::diagnosis {

namespace {

/// In log likelihood: what is this much less likely in the linearised model is not fitted in full. The model is not
/// linear: a part of the best gain is allowed on top.
constexpr double far_behind = 10.0;
constexpr double nonlinearity = 0.15;
constexpr std::size_t most_singles = 8;
/// Single numbers leave few directions, in which many causes look alike: what is not tried would be missing from the set.
constexpr std::size_t most_singles_of_numbers = 24;
constexpr std::size_t most_pairs = 8;
/// Of a curved cause.
constexpr std::size_t most_starts = 4;

double largest(const Scores& scores, const Eigen::VectorXi& sign, const std::vector<std::size_t>& but,
               const std::vector<Candidate>& candidates) {
    double most = 0.0;
    for (Eigen::Index k = 0; k < scores.z.size(); ++k) {
        const bool own = std::ranges::any_of(but, [&](std::size_t other) {
            return candidates[other].cause == candidates[static_cast<std::size_t>(k)].cause;
        });
        most = own ? most : std::max(most, admitted(scores.z[k], sign[k]));
    }
    return most;
}

/// Numbers that a cause holds on trial are free in its fit, within what the effect allows.
void free_held(input::Experiment& model, const Candidate& candidate, std::size_t effect) {
    for (const Candidate::Held& held : candidate.held) {
        const physics::ParameterSpec& number = candidate.effect->parameters[held.parameter];
        model.parameters.push_back({.name = std::string(number.key),
                                    .unit = std::string(number.unit),
                                    .kind = solver::FreeParameter::Kind::effect,
                                    .effect = effect,
                                    .parameter = held.parameter,
                                    .layers = {},
                                    .knots = {},
                                    .nodes = {},
                                    .runs = {},
                                    .prior = held.value,
                                    .low = held.low,
                                    .high = held.high});
    }
}

/// Candidates with the gain that a linear fit predicts for them.
struct LinearisedGain {
    std::vector<std::size_t> candidates;
    std::vector<double> amplitudes;
    double gain = 0.0;
};

void keep_likely(std::vector<LinearisedGain>& estimates, std::size_t most) {
    std::ranges::sort(estimates, std::greater{}, &LinearisedGain::gain);
    if (!estimates.empty()) {
        const double least = estimates.front().gain * (1.0 - nonlinearity) - far_behind;
        std::erase_if(estimates, [&](const LinearisedGain& estimate) { return estimate.gain < least; });
        estimates.resize(std::min(estimates.size(), most));
    }
}

std::vector<FittedHypothesis> fit_all(ScoreTestData& score_data, const std::vector<LinearisedGain>& estimates) {
    std::vector<FittedHypothesis> found(estimates.size());
    in_parallel(estimates.size(), [&](std::size_t i) {
        found[i] = fit_hypothesis(score_data, estimates[i].candidates, estimates[i].amplitudes);
    });
    for (const FittedHypothesis& one : found) {
        score_data.count(one.simulations);
    }
    std::ranges::stable_sort(found, std::greater{}, &FittedHypothesis::gain);
    return found;
}

/// Where a candidate's number starts: not beyond what the effect allows.
double start(const Candidate& candidate, double amplitude) {
    return std::clamp(candidate.absent + amplitude, candidate.low, candidate.high);
}

/// Of several estimates for the same causes the best.
void take(std::vector<LinearisedGain>& estimates, LinearisedGain estimate, const std::vector<Candidate>& candidates) {
    const auto same = [&](const LinearisedGain& other) {
        return std::ranges::equal(
            other.candidates, estimate.candidates, {}, [&](std::size_t k) { return candidates[k].cause; },
            [&](std::size_t k) { return candidates[k].cause; });
    };
    const auto known = std::ranges::find_if(estimates, same);
    if (known == estimates.end()) {
        estimates.push_back(std::move(estimate));
    } else if (known->gain < estimate.gain) {
        *known = std::move(estimate);
    }
}

/// What is left must not be worth another number, one of many: 2.3 and ln(many), and 3 to be sure.
bool is_rest_insignificant(const FittedHypothesis& one, const ScoreTestData& score_data) {
    constexpr double price = 5.3;
    const auto worth = [](Eigen::Index n) { return std::sqrt(2.0 * (price + std::log(static_cast<double>(n)))); };
    return one.largest_score < std::max(score_data.threshold, worth(score_data.scores.z.size())) &&
           one.largest_unknown_score <
               std::max(score_data.unknown_threshold, worth(score_data.unknown_scores.z.size()));
}

/// Fits a model whose numbers after the experiment's start at `from`; what lies beyond stays where it is.
void fit_model(const ScoreTestData& score_data, const Eigen::VectorXd& from, FittedHypothesis& one) {
    Fit fit(one.model, *score_data.observations);
    fit.simulator().take_steps(score_data.steps);
    fit.take_covariance(score_data.noise);
    Eigen::VectorXd start = fit.simulator().start();
    const Eigen::Index n = score_data.base.values.size();
    start.head(n) = score_data.base.values;
    start.segment(n, from.size()) = from;
    if (fit.move_to(start)) {
        one.fit = refit(fit);
    } else {
        one.fit.status = fit.now().status;
    }
    one.simulations += fit.simulator().simulations();
    one.sound = one.fit.status.ok() && one.fit.converged;
    if (!one.fit.status.ok()) {
        return;
    }
    one.gain = 0.5 * (score_data.base.cost - one.fit.cost);
    one.largest_score =
        largest(score_data.scores_after(one.fit), score_data.sign, one.candidates, score_data.candidates);
    const Scores unknown = score_data.unknown_scores_after(one.fit);
    one.largest_unknown_score = unknown.z.size() > 0 ? unknown.z.cwiseAbs().maxCoeff() : 0.0;
    one.rest_is_insignificant = one.sound && is_rest_insignificant(one, score_data);
}

/// Whether each cause has a size within its bounds that differs from none by more than chance would make it. Of a cause
/// alone the gain says the latter.
bool are_all_needed(const FittedHypothesis& one, const std::vector<Candidate>& on) {
    constexpr double least_sigma = 2.0;
    const Eigen::VectorXd deviation = one.fit.deviations();
    for (std::size_t i = 0; i < on.size(); ++i) {
        const Eigen::Index j = one.number_of(i);
        if (one.fit.at_bound[static_cast<std::size_t>(j)] ||
            (on.size() > 1 && std::abs(one.fit.values[j] - on[i].absent) < least_sigma * deviation[j])) {
            return false;
        }
    }
    return true;
}

}  // namespace

FittedHypothesis counted(ScoreTestData& score_data, FittedHypothesis one) {
    score_data.count(one.simulations);
    return one;
}

Eigen::Index FittedHypothesis::number_of(std::size_t i) const {
    const auto n = static_cast<Eigen::Index>(candidates.size());
    return fit.values.size() - n_held - n + static_cast<Eigen::Index>(i);
}

std::vector<double> with_timing_shared(const ScoreTestData& score_data, const std::vector<std::size_t>& candidates,
                                       std::vector<double> amplitudes) {
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        const Candidate& slow = score_data.candidates[candidates[i]];
        const physics::SensorModel* lags = slow.effect->sensor_model();
        for (std::size_t j = 0; lags != nullptr && lags->lag != nullptr && j < candidates.size(); ++j) {
            const Candidate& late = score_data.candidates[candidates[j]];
            const physics::SensorModel* delays = late.effect->sensor_model();
            if (delays != nullptr && delays->delay != nullptr && slow.channels == late.channels) {
                amplitudes[i] = amplitudes[j] = 0.5 * (amplitudes[i] + amplitudes[j]);
            }
        }
    }
    return amplitudes;
}

FittedHypothesis unfitted(const ScoreTestData& score_data, const std::vector<std::size_t>& candidates) {
    FittedHypothesis one;
    one.candidates = candidates;
    std::vector<Candidate> on;
    std::vector<double> absent;
    for (const std::size_t k : candidates) {
        on.push_back(score_data.candidates[k]);
        absent.push_back(on.back().absent);
    }
    one.model = with(*score_data.experiment, on, absent);
    const std::size_t first = one.model.parameters.size() - on.size();
    for (std::size_t i = 0; i < on.size(); ++i) {
        free_held(one.model, on[i], one.model.parameters[first + i].effect);
    }
    one.n_held = static_cast<Eigen::Index>(one.model.parameters.size() - first - on.size());
    return one;
}

FittedHypothesis fit_hypothesis(const ScoreTestData& score_data, const std::vector<std::size_t>& candidates,
                                const std::vector<double>& amplitudes) {
    FittedHypothesis one = unfitted(score_data, candidates);
    std::vector<Candidate> on;
    for (const std::size_t k : candidates) {
        on.push_back(score_data.candidates[k]);
    }
    const std::vector<double> from_absent = with_timing_shared(score_data, candidates, amplitudes);
    Eigen::VectorXd from(static_cast<Eigen::Index>(on.size()));
    for (std::size_t i = 0; i < on.size(); ++i) {
        from[static_cast<Eigen::Index>(i)] = start(on[i], from_absent[i]);
    }
    fit_model(score_data, from, one);
    for (std::size_t i = 0; one.sound && i < on.size(); ++i) {
        one.sound = one.fit.values[one.number_of(i)] != on[i].absent;
    }
    one.admissible = one.sound && are_all_needed(one, on);
    for (std::size_t i = 0; one.sound && i < on.size(); ++i) {
        const auto [low, high] = plausible_bounds(on[i]);
        const double value = one.fit.values[one.number_of(i)];
        one.plausible = one.plausible && low <= value && value <= high;
    }
    one.rest_is_insignificant = one.rest_is_insignificant && one.admissible;
    return one;
}

solver::UserEffect user_effect(const ScoreTestData& score_data, std::size_t term, std::size_t run) {
    const UnknownTerm& unknown = score_data.unknowns.terms[term];
    solver::UserEffect effect;
    effect.name = "unknown";
    effect.places = {score_data.unknowns.places[unknown.place].name};
    if (unknown.event) {
        effect.follows = "1";
        const double on = unknown.run == run ? 1.0 : 0.0;
        effect.signal = {.time = {unknown.from, unknown.from, unknown.to, unknown.to}, .value = {0.0, on, on, 0.0}};
    } else {
        const SourceSignal& source_signal = score_data.unknowns.signals[unknown.signal];
        effect.follows = source_signal.follows;
        effect.signal = {.time = source_signal.time[run], .value = source_signal.value[run]};
    }
    return effect;
}

FittedHypothesis fit_unknown_source(const ScoreTestData& score_data, std::size_t term, double watts) {
    FittedHypothesis one;
    const UnknownTerm& unknown = score_data.unknowns.terms[term];
    if (unknown.sensor) {
        return one;
    }
    one.model = *score_data.experiment;
    const double largest = unknown.event ? 1.0 : score_data.unknowns.signals[unknown.signal].largest;
    std::size_t effect = 0;
    for (std::size_t r = 0; r < one.model.runs.size(); ++r) {
        effect = solver::add_user_effect(one.model.runs[r].problem, user_effect(score_data, term, r));
    }
    // Its scale is that of a watt at the signal's largest value.
    one.model.parameters.push_back({.name = "unknown source",
                                    .unit = "W",
                                    .kind = solver::FreeParameter::Kind::effect,
                                    .effect = effect,
                                    .layers = {},
                                    .knots = {},
                                    .nodes = {},
                                    .runs = {},
                                    .low = -1e6 / largest,
                                    .high = 1e6 / largest});
    fit_model(score_data, Eigen::VectorXd::Constant(1, watts / largest), one);
    one.admissible = one.sound;
    return one;
}

std::vector<FittedHypothesis> fit_single_causes(ScoreTestData& score_data) {
    std::vector<LinearisedGain> estimates;
    std::vector<LinearisedGain> curved;  // with numbers that are held on trial: each trial is a start of its own
    const Scores& scores = score_data.scores;
    for (std::size_t k = 0; k < score_data.candidates.size(); ++k) {
        const auto i = static_cast<Eigen::Index>(k);
        const double z = admitted(scores.z[i], score_data.sign[i]);
        if (z > 0.0) {
            LinearisedGain estimate{.candidates = {k}, .amplitudes = {scores.amplitude(i)}, .gain = 0.5 * z * z};
            if (!score_data.candidates[k].held.empty()) {
                curved.push_back(estimate);
            }
            take(estimates, std::move(estimate), score_data.candidates);
        }
    }
    keep_likely(estimates, score_data.observations->channels.empty() ? most_singles_of_numbers : most_singles);
    const auto known = [&](std::size_t cause, const auto& list) {
        return std::ranges::any_of(list, [&](const LinearisedGain& one) {
            return score_data.candidates[one.candidates.front()].cause == cause;
        });
    };
    // A likely cause that is curved is fitted from its best trials, not from the best alone.
    std::ranges::sort(curved, std::greater{}, &LinearisedGain::gain);
    std::vector<LinearisedGain> starts;
    for (const LinearisedGain& one : curved) {
        const std::size_t cause = score_data.candidates[one.candidates.front()].cause;
        const bool is_best = std::ranges::any_of(
            estimates, [&](const LinearisedGain& other) { return other.candidates.front() == one.candidates.front(); });
        if (known(cause, estimates) && !is_best && starts.size() + 1 < most_starts) {
            starts.push_back(one);
        }
    }
    std::vector<FittedHypothesis> found = fit_all(score_data, estimates);
    for (FittedHypothesis& again : fit_all(score_data, starts)) {
        const auto same = std::ranges::find_if(found, [&](const FittedHypothesis& one) {
            return score_data.candidates[one.candidates.front()].cause ==
                   score_data.candidates[again.candidates.front()].cause;
        });
        const bool better = same != found.end() && again.sound &&
                            (!same->sound || (again.admissible && !same->admissible) ||
                             (again.admissible == same->admissible && again.gain > same->gain));
        if (better) {
            *same = std::move(again);
        }
    }
    std::ranges::stable_sort(found, std::greater{}, &FittedHypothesis::gain);
    return found;
}

std::vector<FittedHypothesis> fit_cause_pairs(ScoreTestData& score_data, double least_gain) {
    std::vector<LinearisedGain> estimates;
    const Scores& scores = score_data.scores;
    for (const Pair& pair : score_data.pairs) {
        const PairScore both = score_of_pair(scores, score_data.sign, pair);
        if (both.gain > 0.0) {
            const auto [a, b] = pair;
            take(estimates,
                 {.candidates = {static_cast<std::size_t>(a), static_cast<std::size_t>(b)},
                  .amplitudes = {both.first / scores.length[a], both.second / scores.length[b]},
                  .gain = both.gain},
                 score_data.candidates);
        }
    }
    std::erase_if(estimates, [&](const LinearisedGain& estimate) { return estimate.gain < least_gain; });
    keep_likely(estimates, most_pairs);
    return fit_all(score_data, estimates);
}

bool settle_noise(ScoreTestData& score_data, const FittedHypothesis& best) {
    Fit fit(best.model, *score_data.observations);
    fit.simulator().take_steps(score_data.steps);
    fit.take_covariance(score_data.noise);
    if (!fit.move_to(best.fit.values)) {
        return false;
    }
    fit.find_noise(score_data.principal_signatures(best.fit));
    Fit base(*score_data.experiment, *score_data.observations);
    base.simulator().take_steps(score_data.steps);
    base.take_covariance(fit.covariance());
    if (!base.move_to(score_data.base.values)) {
        return false;
    }
    Refit again = refit(base);
    score_data.count(fit.simulator().simulations() + base.simulator().simulations());
    score_data.take_noise(fit.covariance(), std::move(again));
    return true;
}

}  // namespace tiretherm::diagnosis
