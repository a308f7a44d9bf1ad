#include <algorithm>
#include <cmath>
#include <set>

#include "diagnosis/assess/findings.hpp"

namespace tiretherm::diagnosis {

namespace {

// All in log likelihood.

/// An explanation that is this much less likely than the best is not in the set. With all of them alike before the data
/// it has a probability of 1 in 150. There are many pairs that do nearly as well as any pair.
constexpr double behind_single = 5.0;
constexpr double behind_pair = 4.0;
/// A cause of the catalogue is given up for an unknown source that is likelier by this. Among the many of these some ten look
/// much like any true cause; by chance the best of them gains half the square of 3.6 in one of three hundred cases.
constexpr double unknown_over_one = 6.5;
/// One that is likelier by this is told beside the cause.
constexpr double unknown_beside_one = 3.0;
/// One cause is given up for two that are likelier by this. A second cause beside the true one gains up to half the square
/// of the threshold by chance, 6.4; pairs without the true one are many, and rarely do better.
constexpr double two_over_one = 8.0;
/// What a number must gain to be worth its freedom: the odds of a number whose signature may be up to some ten standard
/// deviations, ln sqrt(1 + 10^2).
constexpr double cost_of_number = 2.3;
/// Above this gain a cause bends the picture at the base model so far that the noise is asked again.
constexpr double bent_gain = 30.0;

double n_causes(const Evidence& evidence) {
    std::set<std::size_t> causes;
    for (const Candidate& candidate : evidence.candidates) {
        causes.insert(candidate.cause);
    }
    return std::max<double>(1.0, static_cast<double>(causes.size()));
}

/// What an explanation is worth beside all others of its kind.
double worth(const Findings& found, const Explanation& one) {
    const double n = n_causes(found.evidence);
    const bool two = one.candidates.size() == 2;
    return one.gain - (two ? 2.0 : 1.0) * cost_of_number - std::log(two ? 0.5 * n * n : n);
}

double worth_of_unknown(const Findings& found) {
    return std::max(found.unknown_fit.gain, found.unknown.gain()) - cost_of_number -
           std::log(static_cast<double>(found.evidence.unknowns.terms.size()));
}

/// A cause or a source by itself is beyond chance.
bool is_one_loud(const Evidence& evidence, const LoudTerm& unknown) {
    double most = 0.0;
    for (Eigen::Index k = 0; k < evidence.scores.z.size(); ++k) {
        most = std::max(most, admitted(evidence.scores.z[k], evidence.sign[k]));
    }
    return most > evidence.threshold || std::abs(unknown.z) > evidence.unknown_threshold;
}

/// Two causes together are, whether or not one is: two may hide each other.
bool are_two_loud(const Evidence& evidence) {
    return std::ranges::any_of(evidence.pairs, [&](const Pair& pair) {
        return score_of_pair(evidence.scores, evidence.sign, pair).gain > evidence.pair_threshold;
    });
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

const Explanation* likeliest(const std::vector<Explanation>& from, bool quiet) {
    const Explanation* best = nullptr;
    for (const Explanation& one : from) {
        if (one.sound && (one.quiet || !quiet) && (best == nullptr || one.gain > best->gain)) {
            best = &one;
        }
    }
    return best;
}

/// Explanations that leave nothing, about as likely as the best of them.
std::vector<const Explanation*> standing(const std::vector<Explanation>& from, double least_gain, double behind) {
    std::vector<const Explanation*> set;
    const Explanation* best = likeliest(from, true);
    for (const Explanation& one : from) {
        if (one.quiet && one.gain > least_gain && one.gain > best->gain - behind) {
            set.push_back(&one);
        }
    }
    return set;
}

void look(Findings& found) {
    found.singles.clear();
    found.pairs.clear();
    found.unknown_fit = {};
    found.unknown = loudest_term(found.evidence.unknown_scores);
    const bool one = is_one_loud(found.evidence, found.unknown);
    if (!one && !are_two_loud(found.evidence)) {
        return;
    }
    if (one) {
        found.singles = explain_by_one(found.evidence);
    }
    const auto set = standing(found.singles, found.unknown.gain() - unknown_over_one, behind_single);
    found.pairs = explain_by_two(found.evidence, set.empty() ? 0.0 : set.front()->gain + two_over_one);
}

void take(Findings& found, std::vector<const Explanation*> set) {
    found.set = std::move(set);
    found.verdict = found.set.size() == 1 ? Verdict::named : Verdict::confounded;
}

/// The strongest unknown source, fitted.
void look_into_unknown(Findings& found) {
    if (found.unknown.z != 0.0) {
        const auto k = static_cast<Eigen::Index>(found.unknown.term);
        found.unknown_fit =
            explain_unknown(found.evidence, found.unknown.term, found.evidence.unknown_scores.amplitude(k));
    }
}

/// Whether the strongest unknown source is likely enough beside a cause that leaves nothing.
bool worth_telling(const Findings& found, const Explanation& cause) {
    return std::abs(found.unknown.z) > found.evidence.unknown_threshold &&
           found.unknown.gain() > cause.gain + unknown_beside_one;
}

void decide(Findings& found) {
    if (!is_one_loud(found.evidence, found.unknown) && found.pairs.empty()) {
        found.verdict = Verdict::consistent;
        return;
    }
    const auto alone = standing(found.singles, found.unknown.gain() - unknown_over_one, behind_single);
    const auto two = standing(found.pairs, 0.0, behind_pair);
    if (!alone.empty() && (two.empty() || two.front()->gain < alone.front()->gain + two_over_one)) {
        take(found, alone);
        if (worth_telling(found, *alone.front())) {
            look_into_unknown(found);
            found.unknown_stands = true;
            found.verdict = Verdict::confounded;
        }
        return;
    }
    // No single cause leaves nothing. What does must be worth its numbers; if nothing does, the likeliest is named and
    // what is left is said.
    look_into_unknown(found);
    const bool unknown_is_quiet =
        std::abs(found.unknown.z) > found.evidence.unknown_threshold &&
        (found.unknown_fit.sound
             ? found.unknown_fit.quiet
             : loudest_beside(found.evidence.unknown_scores, found.unknown.term) < found.evidence.unknown_threshold);
    double best = unknown_is_quiet ? worth_of_unknown(found) : 0.0;
    found.verdict = Verdict::unknown;
    if (!two.empty() && worth(found, *two.front()) > best) {
        best = worth(found, *two.front());
        take(found, two);
    }
    for (const auto* list : {&found.singles, &found.pairs}) {
        const Explanation* one = likeliest(*list, false);
        if (one != nullptr && !one->quiet && worth(found, *one) > best) {
            best = worth(found, *one);
            take(found, {one});
            found.something_left = true;
        }
    }
    if (found.set.empty() && !is_one_loud(found.evidence, found.unknown)) {
        found.verdict = Verdict::consistent;  // two seemed loud together, and no fit of any pair bore it out
        return;
    }
    if (!unknown_is_quiet && worth_of_unknown(found) > best) {
        found.set.clear();
        found.verdict = Verdict::unknown;
        found.something_left = true;
    }
}

}  // namespace

LoudTerm loudest_term(const Scores& scores) {
    LoudTerm found;
    for (Eigen::Index k = 0; k < scores.z.size(); ++k) {
        if (std::abs(scores.z[k]) > std::abs(found.z)) {
            found = {.term = static_cast<std::size_t>(k), .z = scores.z[k]};
        }
    }
    return found;
}

const Explanation* Findings::best() const {
    if (verdict == Verdict::unknown) {
        return unknown_fit.sound ? &unknown_fit : nullptr;
    }
    return set.empty() ? nullptr : set.front();
}

void inquire(Findings& findings) {
    look(findings);
    const Explanation* one = likeliest(findings.singles, false);
    const Explanation* two = likeliest(findings.pairs, false);
    const Explanation* best = two != nullptr && (one == nullptr || two->gain > one->gain + two_over_one) ? two : one;
    if (best != nullptr && best->gain > bent_gain && settle_noise(findings.evidence, *best)) {
        look(findings);
    }
    decide(findings);
}

}  // namespace tiretherm::diagnosis
