#include "diagnosis/assess/explanation.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

namespace tiretherm::diagnosis {

namespace {

/// In log likelihood: what is this much less likely in the straight picture is not fitted in full. The picture is bent:
/// a part of the best gain is allowed on top.
constexpr double far_behind = 10.0;
constexpr double bent = 0.15;
constexpr std::size_t most_singles = 8;
/// Single numbers leave few directions, in which many causes look alike: what is not tried would be missing from the set.
constexpr std::size_t most_singles_of_numbers = 24;
constexpr std::size_t most_pairs = 8;

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
                                    .prior = held.value,
                                    .low = held.low,
                                    .high = held.high});
    }
}

/// Candidates of a straight fit with the gain that it promises.
struct Promise {
    std::vector<std::size_t> candidates;
    std::vector<double> amplitudes;
    double gain = 0.0;
};

void keep_likely(std::vector<Promise>& promises, std::size_t most) {
    std::ranges::sort(promises, std::greater{}, &Promise::gain);
    if (!promises.empty()) {
        const double least = promises.front().gain * (1.0 - bent) - far_behind;
        std::erase_if(promises, [&](const Promise& promise) { return promise.gain < least; });
        promises.resize(std::min(promises.size(), most));
    }
}

std::vector<Explanation> fit_all(Evidence& evidence, const std::vector<Promise>& promises) {
    std::vector<Explanation> found;
    for (const Promise& promise : promises) {
        found.push_back(explain(evidence, promise.candidates, promise.amplitudes));
    }
    std::ranges::stable_sort(found, std::greater{}, &Explanation::gain);
    return found;
}

/// Where a candidate's number starts: not beyond what the effect allows.
double start(const Candidate& candidate, double amplitude) {
    return std::clamp(candidate.absent + amplitude, candidate.low, candidate.high);
}

/// Of several promises of the same causes the best.
void take(std::vector<Promise>& promises, Promise promise, const std::vector<Candidate>& candidates) {
    const auto same = [&](const Promise& other) {
        return std::ranges::equal(
            other.candidates, promise.candidates, {}, [&](std::size_t k) { return candidates[k].cause; },
            [&](std::size_t k) { return candidates[k].cause; });
    };
    const auto known = std::ranges::find_if(promises, same);
    if (known == promises.end()) {
        promises.push_back(std::move(promise));
    } else if (known->gain < promise.gain) {
        *known = std::move(promise);
    }
}

/// What is left must not be worth another number, one of many: 2.3 and ln(many), and 3 to be sure.
bool is_quiet(const Explanation& one, const Evidence& evidence) {
    constexpr double price = 5.3;
    const auto worth = [](Eigen::Index n) { return std::sqrt(2.0 * (price + std::log(static_cast<double>(n)))); };
    return one.loudest < std::max(evidence.threshold, worth(evidence.scores.z.size())) &&
           one.loudest_unknown < std::max(evidence.unknown_threshold, worth(evidence.unknown_scores.z.size()));
}

/// Fits a model whose numbers after the experiment's start at `from`; what lies beyond stays where it is.
void fit_model(Evidence& evidence, const Eigen::VectorXd& from, Explanation& one) {
    Fit fit(one.model, *evidence.observations);
    fit.simulator().take_steps(evidence.steps);
    fit.take_covariance(evidence.noise);
    Eigen::VectorXd start = fit.simulator().start();
    const Eigen::Index n = evidence.base.values.size();
    start.head(n) = evidence.base.values;
    start.segment(n, from.size()) = from;
    if (fit.move_to(start)) {
        one.fit = refit(fit);
    } else {
        one.fit.status = fit.now().status;
    }
    evidence.count(fit.simulator().simulations());
    one.sound = one.fit.status.ok() && one.fit.converged;
    if (!one.fit.status.ok()) {
        return;
    }
    one.gain = 0.5 * (evidence.base.cost - one.fit.cost);
    one.loudest = largest(evidence.scores_after(one.fit), evidence.sign, one.candidates, evidence.candidates);
    const Scores unknown = evidence.unknown_scores_after(one.fit);
    one.loudest_unknown = unknown.z.size() > 0 ? unknown.z.cwiseAbs().maxCoeff() : 0.0;
    one.quiet = one.sound && is_quiet(one, evidence);
}

}  // namespace

Eigen::Index Explanation::number_of(std::size_t i) const {
    const auto n = static_cast<Eigen::Index>(candidates.size());
    return fit.values.size() - n_held - n + static_cast<Eigen::Index>(i);
}

Explanation explain(Evidence& evidence, const std::vector<std::size_t>& candidates,
                    const std::vector<double>& amplitudes) {
    Explanation one;
    one.candidates = candidates;
    std::vector<Candidate> on;
    std::vector<double> absent;
    for (const std::size_t k : candidates) {
        on.push_back(evidence.candidates[k]);
        absent.push_back(on.back().absent);
    }
    one.model = with(*evidence.experiment, on, absent);
    const std::size_t first = one.model.parameters.size() - on.size();
    for (std::size_t i = 0; i < on.size(); ++i) {
        free_held(one.model, on[i], one.model.parameters[first + i].effect);
    }
    one.n_held = static_cast<Eigen::Index>(one.model.parameters.size() - first - on.size());
    Eigen::VectorXd from(static_cast<Eigen::Index>(on.size()));
    for (std::size_t i = 0; i < on.size(); ++i) {
        from[static_cast<Eigen::Index>(i)] = start(on[i], amplitudes[i]);
    }
    fit_model(evidence, from, one);
    for (std::size_t i = 0; one.sound && i < on.size(); ++i) {
        one.sound = one.fit.values[one.number_of(i)] != on[i].absent;
    }
    one.quiet = one.quiet && one.sound;
    return one;
}

solver::UserEffect user_effect(const Evidence& evidence, std::size_t term, std::size_t run) {
    const UnknownTerm& unknown = evidence.unknowns.terms[term];
    solver::UserEffect effect;
    effect.name = "unknown";
    effect.places = {evidence.unknowns.places[unknown.place].name};
    if (unknown.event) {
        effect.follows = "1";
        const double on = unknown.run == run ? 1.0 : 0.0;
        effect.signal = {.time = {unknown.from, unknown.from, unknown.to, unknown.to}, .value = {0.0, on, on, 0.0}};
    } else {
        const Course& course = evidence.unknowns.courses[unknown.course];
        effect.follows = course.follows;
        effect.signal = {.time = course.time[run], .value = course.value[run]};
    }
    return effect;
}

Explanation explain_unknown(Evidence& evidence, std::size_t term, double watts) {
    Explanation one;
    const UnknownTerm& unknown = evidence.unknowns.terms[term];
    if (unknown.sensor) {
        return one;
    }
    one.model = *evidence.experiment;
    const double largest = unknown.event ? 1.0 : evidence.unknowns.courses[unknown.course].largest;
    std::size_t effect = 0;
    for (std::size_t r = 0; r < one.model.runs.size(); ++r) {
        effect = solver::add_user_effect(one.model.runs[r].problem, user_effect(evidence, term, r));
    }
    // Its scale is that of a watt at the signal's largest value.
    one.model.parameters.push_back({.name = "unknown source",
                                    .unit = "W",
                                    .kind = solver::FreeParameter::Kind::effect,
                                    .effect = effect,
                                    .layers = {},
                                    .knots = {},
                                    .nodes = {},
                                    .low = -1e6 / largest,
                                    .high = 1e6 / largest});
    fit_model(evidence, Eigen::VectorXd::Constant(1, watts / largest), one);
    return one;
}

std::vector<Explanation> explain_by_one(Evidence& evidence) {
    std::vector<Promise> promises;
    const Scores& scores = evidence.scores;
    for (std::size_t k = 0; k < evidence.candidates.size(); ++k) {
        const auto i = static_cast<Eigen::Index>(k);
        const double z = admitted(scores.z[i], evidence.sign[i]);
        if (z > 0.0) {
            take(promises, {.candidates = {k}, .amplitudes = {scores.amplitude(i)}, .gain = 0.5 * z * z},
                 evidence.candidates);
        }
    }
    keep_likely(promises, evidence.observations->channels.empty() ? most_singles_of_numbers : most_singles);
    return fit_all(evidence, promises);
}

std::vector<Explanation> explain_by_two(Evidence& evidence, double least_gain) {
    std::vector<Promise> promises;
    const Scores& scores = evidence.scores;
    for (const Pair& pair : evidence.pairs) {
        const PairScore both = score_of_pair(scores, evidence.sign, pair);
        if (both.gain > 0.0) {
            const auto [a, b] = pair;
            take(promises,
                 {.candidates = {static_cast<std::size_t>(a), static_cast<std::size_t>(b)},
                  .amplitudes = {both.first / scores.length[a], both.second / scores.length[b]},
                  .gain = both.gain},
                 evidence.candidates);
        }
    }
    std::erase_if(promises, [&](const Promise& promise) { return promise.gain < least_gain; });
    keep_likely(promises, most_pairs);
    return fit_all(evidence, promises);
}

bool settle_noise(Evidence& evidence, const Explanation& best) {
    Fit fit(best.model, *evidence.observations);
    fit.simulator().take_steps(evidence.steps);
    fit.take_covariance(evidence.noise);
    if (!fit.move_to(best.fit.values)) {
        return false;
    }
    fit.find_noise(evidence.essence(best.fit));
    Fit base(*evidence.experiment, *evidence.observations);
    base.simulator().take_steps(evidence.steps);
    base.take_covariance(fit.covariance());
    if (!base.move_to(evidence.base.values)) {
        return false;
    }
    Refit again = refit(base);
    evidence.count(fit.simulator().simulations() + base.simulator().simulations());
    evidence.take_noise(fit.covariance(), std::move(again));
    return true;
}

}  // namespace tiretherm::diagnosis
