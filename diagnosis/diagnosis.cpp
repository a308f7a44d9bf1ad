#include "diagnosis/diagnosis.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "diagnosis/explanation.hpp"

namespace tiretherm::diagnosis {

namespace {

/// Local error of a step, K. At 10 mK the steps of a bench bias its loss by 0.3 standard deviations.
constexpr double step_error = 1e-3;
/// In log likelihood: an explanation that is this much less likely than the best is not in the set. With all of them
/// alike before the data it has a probability of 1 in 150.
constexpr double in_set = 5.0;
/// A catalogue effect is given up for an unknown source that is likelier by this: there are more of these to choose from.
constexpr double unknown_over_one = 4.0;
/// What a second number must gain to be worth its freedom: the odds of a number whose signature may be up to some ten
/// standard deviations, ln sqrt(1 + 10^2).
constexpr double cost_of_number = 2.3;
constexpr double wide = 1.959964;  // 95 % of a normal distribution

}  // namespace

std::string_view word_of(Verdict verdict) {
    switch (verdict) {
        case Verdict::named:
            return "named";
        case Verdict::confounded:
            return "confounded";
        case Verdict::unknown:
            return "unknown";
        case Verdict::consistent:
            return "consistent";
        case Verdict::cannot_tell:
            return "cannot_tell";
    }
    return "";
}

namespace {

/// The strongest unknown source.
struct Loudest {
    std::size_t term = 0;
    double z = 0.0;
};

Loudest loudest_unknown(const Scores& scores) {
    Loudest found;
    for (Eigen::Index k = 0; k < scores.z.size(); ++k) {
        if (std::abs(scores.z[k]) > std::abs(found.z)) {
            found = {.term = static_cast<std::size_t>(k), .z = scores.z[k]};
        }
    }
    return found;
}

std::string place_of(const Evidence& evidence, const UnknownTerm& term) {
    return term.sensor ? evidence.experiment->runs.front().problem.channels[term.place].name
                       : evidence.unknowns.places[term.place].name;
}

/// What is left of the scores once one unknown source is taken out as well.
double loudest_beside(const Scores& scores, std::size_t term) {
    const auto t = static_cast<Eigen::Index>(term);
    double most = 0.0;
    for (Eigen::Index k = 0; k < scores.z.size(); ++k) {
        const double c = scores.correlation(k, t);
        if (1.0 - c * c > 1e-3) {
            most = std::max(most, std::abs(scores.z[k] - c * scores.z[t]) / std::sqrt(1.0 - c * c));
        }
    }
    return most;
}

UnknownSource describe(const Evidence& evidence, const Loudest& loudest) {
    const UnknownTerm& term = evidence.unknowns.terms[loudest.term];
    const auto k = static_cast<Eigen::Index>(loudest.term);
    const Scores& scores = evidence.unknown_scores;
    UnknownSource source{.place = place_of(evidence, term), .sigma = std::abs(loudest.z), .sensor = term.sensor};
    const double deviation = 1.0 / scores.length[k];
    source.watts = scores.amplitude(k);
    source.low = source.watts - wide * deviation;
    source.high = source.watts + wide * deviation;
    if (term.event) {
        source.follows = "time window";
        source.unit = "W";
        source.per = source.watts;
        source.from = term.from;
        source.to = term.to;
        source.run = evidence.experiment->runs[term.run].name;
    } else {
        const Course& course = evidence.unknowns.courses[term.course];
        source.follows = course.follows;
        source.unit = course.unit;
        source.per = source.watts / course.largest;
    }
    for (std::size_t other = 0; other < evidence.unknowns.terms.size(); ++other) {
        const auto o = static_cast<Eigen::Index>(other);
        const double behind = 0.5 * (loudest.z * loudest.z - scores.z[o] * scores.z[o]);
        if (other != loudest.term && behind < in_set && !evidence.unknowns.terms[other].event) {
            source.alike.push_back(place_of(evidence, evidence.unknowns.terms[other]) + ", " +
                                   evidence.unknowns.courses[evidence.unknowns.terms[other].course].follows);
        }
    }
    return source;
}

class Inquiry {
public:
    Inquiry(const cases::Experiment& experiment, const Observations& observations)
        : experiment_(experiment), observations_(observations) {
        for (cases::MeasuredRun& run : experiment_.runs) {
            run.problem.settings.tolerance = std::min(run.problem.settings.tolerance, step_error);
        }
    }

    Diagnosis run() {
        Diagnosis result;
        evidence_ = gather_evidence(experiment_, observations_);
        if (!evidence_.status.ok()) {
            result.status = evidence_.status;
            return result;
        }
        look();
        if (const Explanation* best = best_explanation(); best != nullptr && best->gain > bent_gain) {
            const std::vector<std::size_t> again = best->candidates;
            if (settle_noise(evidence_, *best)) {
                look();
            }
        }
        decide(result);
        fill(result);
        return result;
    }

private:
    /// Above this gain in log likelihood a cause bends the picture at the base model so far that the noise is asked again.
    static constexpr double bent_gain = 30.0;

    [[nodiscard]] bool is_loud() const {
        const Loudest unknown = loudest_unknown(evidence_.unknown_scores);
        double most = 0.0;
        for (Eigen::Index k = 0; k < evidence_.scores.z.size(); ++k) {
            most = std::max(most, admitted(evidence_.scores.z[k], evidence_.sign[k]));
        }
        return most > evidence_.threshold || std::abs(unknown.z) > evidence_.unknown_threshold;
    }

    void look() {
        singles_.clear();
        pairs_.clear();
        unknown_ = loudest_unknown(evidence_.unknown_scores);
        if (!is_loud()) {
            return;
        }
        singles_ = explain_by_one(evidence_);
        const double unknown_gain = 0.5 * unknown_.z * unknown_.z;
        const bool any_single = std::ranges::any_of(
            singles_, [&](const Explanation& one) { return one.quiet && one.gain > unknown_gain - unknown_over_one; });
        if (!any_single) {
            pairs_ = explain_by_two(evidence_);
        }
    }

    [[nodiscard]] const Explanation* best_explanation() const {
        const Explanation* best = nullptr;
        for (const auto* list : {&singles_, &pairs_}) {
            for (const Explanation& one : *list) {
                if (one.sound && (best == nullptr || one.gain > best->gain + (list == &pairs_ ? 8.0 : 0.0))) {
                    best = &one;
                }
            }
        }
        return best;
    }

    void decide(Diagnosis& result) {
        set_.clear();
        if (!is_loud()) {
            result.verdict = Verdict::consistent;
            return;
        }
        const double unknown_gain = 0.5 * unknown_.z * unknown_.z;
        keep(singles_, unknown_gain - unknown_over_one);
        if (!set_.empty()) {
            result.verdict = set_.size() == 1 ? Verdict::named : Verdict::confounded;
            return;
        }
        const bool unknown_is_quiet = std::abs(unknown_.z) > evidence_.unknown_threshold && is_quiet_beside_unknown();
        // A pair has two numbers and is one of many: it must be worth them.
        const double n_pairs = 0.5 * static_cast<double>(evidence_.candidates.size() * evidence_.candidates.size());
        const double n_terms = static_cast<double>(evidence_.unknowns.terms.size());
        const double unknown_worth = unknown_gain - cost_of_number - std::log(n_terms);
        keep(pairs_, 0.0);
        if (!set_.empty() && unknown_is_quiet) {
            const double pair_worth = set_.front()->gain - 2.0 * cost_of_number - std::log(n_pairs);
            if (unknown_worth > pair_worth) {
                set_.clear();
            }
        }
        if (set_.empty()) {
            result.verdict = Verdict::unknown;
            result.unknown = describe(evidence_, unknown_);
            return;
        }
        result.verdict = set_.size() == 1 ? Verdict::named : Verdict::confounded;
    }

    [[nodiscard]] bool is_quiet_beside_unknown() const {
        return loudest_beside(evidence_.unknown_scores, unknown_.term) < evidence_.unknown_threshold;
    }

    /// Quiet explanations that are about as likely as the best of them.
    void keep(const std::vector<Explanation>& from, double least_gain) {
        double best = 0.0;
        for (const Explanation& one : from) {
            if (one.quiet && one.gain > least_gain) {
                best = std::max(best, one.gain);
                if (one.gain > best - in_set) {
                    set_.push_back(&one);
                }
            }
        }
    }

    void fill(Diagnosis& result) {
        const std::vector<solver::Channel>& channels = experiment_.runs.front().problem.channels;
        const auto describe_one = [&](const Explanation& one, std::size_t i) {
            const Candidate& candidate = evidence_.candidates[one.candidates[i]];
            Cause cause{.id = std::string(candidate.effect->id)};
            if (candidate.channel >= 0) {
                cause.channel = channels[static_cast<std::size_t>(candidate.channel)].name;
            }
            if (candidate.layer >= 0) {
                cause.place = experiment_.runs.front().problem.mesh.layers[static_cast<std::size_t>(candidate.layer)];
            }
            const Eigen::VectorXd deviation = one.fit.deviations();
            const auto add = [&](Eigen::Index j, std::size_t parameter, double factor) {
                const physics::Parameter& number = candidate.effect->parameters[parameter];
                const double value = one.fit.values[j];
                cause.numbers.push_back({.key = std::string(number.key),
                                         .unit = std::string(number.unit),
                                         .value = factor * value,
                                         .low = factor * std::max(number.low, value - wide * deviation[j]),
                                         .high = factor * std::min(number.high, value + wide * deviation[j])});
            };
            const Eigen::Index j = one.number_of(i);
            add(j, candidate.parameter, 1.0);
            for (const solver::Adjustable::Companion& companion : candidate.companions) {
                add(j, companion.parameter, companion.factor);
            }
            cause.sigma = deviation[j] > 0.0 ? std::abs(one.fit.values[j] - candidate.absent) / deviation[j] : 0.0;
            cause.gain = one.gain;
            return cause;
        };
        std::vector<std::size_t> described;  // cause numbers of the candidates
        for (const auto* list : {&pairs_, &singles_}) {
            for (const Explanation& one : *list) {
                const bool member = std::ranges::find(set_, &one) != set_.end();
                if (list == &pairs_ && !member) {
                    continue;
                }
                std::vector<std::size_t> members;
                for (std::size_t i = 0; i < one.candidates.size(); ++i) {
                    const std::size_t number = evidence_.candidates[one.candidates[i]].cause;
                    const auto known = std::ranges::find(described, number);
                    members.push_back(static_cast<std::size_t>(known - described.begin()));
                    if (known == described.end()) {
                        described.push_back(number);
                        result.causes.push_back(describe_one(one, i));
                    }
                    result.causes[members.back()].in_set = result.causes[members.back()].in_set || member;
                }
                if (member) {
                    result.explanations.push_back(members);
                }
            }
        }
        for (std::size_t i = 0; i < result.causes.size(); ++i) {
            result.causes[i].rank = static_cast<int>(i) + 1;
        }
        result.values = evidence_.base.values;
        result.base = evidence_.base.simulated;
        result.extended = set_.empty() ? result.base : set_.front()->fit.simulated;
        result.noise = evidence_.noise.channels;
        result.simulations = evidence_.simulations;
    }

    cases::Experiment experiment_;
    const Observations& observations_;
    Evidence evidence_;
    std::vector<Explanation> singles_;
    std::vector<Explanation> pairs_;
    Loudest unknown_;
    std::vector<const Explanation*> set_;
};

}  // namespace

Diagnosis diagnose(const cases::Experiment& experiment, const Observations& observations,
                   const DiagnosisChoice& /*choice*/) {
    const auto begin = std::chrono::steady_clock::now();
    Diagnosis result = Inquiry(experiment, observations).run();
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return result;
}

}  // namespace tiretherm::diagnosis
