#include "diagnosis/explanation.hpp"

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
constexpr std::size_t most_pairs = 8;
/// Two signatures that are this much alike are no pair.
constexpr double alike = 0.995;

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
void free_held(cases::Experiment& model, const Candidate& candidate, std::size_t effect) {
    for (const auto& [parameter, held] : candidate.held) {
        const physics::Parameter& number = candidate.effect->parameters[parameter];
        model.parameters.push_back({.name = std::string(number.key),
                                    .unit = std::string(number.unit),
                                    .kind = solver::Adjustable::Kind::effect,
                                    .effect = effect,
                                    .parameter = parameter,
                                    .layers = {},
                                    .knots = {},
                                    .nodes = {},
                                    .prior = held,
                                    .low = std::max(number.low, held - 20.0),
                                    .high = std::min(number.high, held + 20.0)});
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
        found.back().expected_gain = promise.gain;
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
    Fit fit(one.model, *evidence.observations);
    fit.simulator().take_steps(evidence.steps);
    fit.take_covariance(evidence.noise);
    Eigen::VectorXd from = fit.simulator().start();
    from.head(evidence.base.values.size()) = evidence.base.values;
    for (std::size_t i = 0; i < on.size(); ++i) {
        from[static_cast<Eigen::Index>(first + i)] = start(on[i], amplitudes[i]);
    }
    if (!fit.move_to(from)) {
        one.fit.status = fit.now().status;
        evidence.simulations += fit.simulator().simulations();
        return one;
    }
    one.fit = refit(fit);
    evidence.simulations += fit.simulator().simulations();
    one.gain = 0.5 * (evidence.base.cost - one.fit.cost);
    one.sound = one.fit.status.ok() && one.fit.converged;
    for (std::size_t i = 0; i < on.size(); ++i) {
        const Eigen::Index j = one.number_of(i);
        one.sound = one.sound && one.fit.values[j] != on[i].absent;
    }
    one.loudest = largest(evidence.scores_after(one.fit), evidence.sign, candidates, evidence.candidates);
    const Scores unknown = evidence.unknown_scores_after(one.fit);
    one.loudest_unknown = unknown.z.size() > 0 ? unknown.z.cwiseAbs().maxCoeff() : 0.0;
    one.quiet = one.sound && one.loudest < evidence.threshold && one.loudest_unknown < evidence.unknown_threshold;
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
    keep_likely(promises, most_singles);
    return fit_all(evidence, promises);
}

std::vector<Explanation> explain_by_two(Evidence& evidence) {
    std::vector<Promise> promises;
    const Scores& scores = evidence.scores;
    for (std::size_t j = 0; j < evidence.candidates.size(); ++j) {
        for (std::size_t k = j + 1; k < evidence.candidates.size(); ++k) {
            const auto a = static_cast<Eigen::Index>(j);
            const auto b = static_cast<Eigen::Index>(k);
            const double c = scores.correlation(a, b);
            if (evidence.candidates[j].cause == evidence.candidates[k].cause || scores.length[a] == 0.0 ||
                scores.length[b] == 0.0 || std::abs(c) > alike) {
                continue;
            }
            const double left = 1.0 - c * c;
            const double za = (scores.z[a] - c * scores.z[b]) / left;
            const double zb = (scores.z[b] - c * scores.z[a]) / left;
            if (admitted(za, evidence.sign[a]) > 0.0 && admitted(zb, evidence.sign[b]) > 0.0) {
                take(promises,
                     {.candidates = {j, k},
                      .amplitudes = {za / scores.length[a], zb / scores.length[b]},
                      .gain = 0.5 * (za * scores.z[a] + zb * scores.z[b])},
                     evidence.candidates);
            }
        }
    }
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
    evidence.simulations += fit.simulator().simulations() + base.simulator().simulations();
    evidence.take_noise(fit.covariance(), std::move(again));
    return true;
}

}  // namespace tiretherm::diagnosis
