// SPDX-License-Identifier: BSD-3-Clause
// Decides between no missing effect, one cause, two causes and an unknown source, by thresholds on the log likelihood
// ratio.

#include <algorithm>
#include <cmath>

#include "diagnosis/assess/cause_description.hpp"
#include "diagnosis/assess/diagnosis_state.hpp"

namespace tiretherm::diagnosis {

namespace {

// All in log likelihood.

/// A hypothesis that is this much less likely than the best is not in the set. With all of them alike before the data
/// it has a probability of 1 in 150. There are many pairs that do nearly as well as any pair.
constexpr double behind_single = 5.0;
constexpr double behind_pair = 4.0;
/// A cause of the catalogue is given up for an unknown source that is likelier by this. Among the many of these some ten look
/// much like any true cause; by chance the best of them gains half the square of 3.6 in one of three hundred cases.
constexpr double unknown_over_one = 6.5;
/// One that is likelier by this is reported beside the cause.
constexpr double unknown_beside_one = 3.0;
/// One cause is given up for two that are likelier by this. A second cause beside the true one gains up to half the square
/// of the threshold by chance, 6.4; pairs without the true one are many, and rarely do better.
constexpr double two_over_one = 8.0;
/// What a number must gain to be worth its freedom: the odds of a number whose signature may be up to some ten standard
/// deviations, ln sqrt(1 + 10^2).
constexpr double cost_of_number = 2.3;
/// Above this gain a cause is so far from the linearisation at the base model that the noise is estimated again.
constexpr double nonlinear_gain = 30.0;

/// What a hypothesis is worth beside all others of its kind.
double worth(const DiagnosisState& found, const FittedHypothesis& one) {
    const auto n = std::max(1.0, static_cast<double>(n_causes(found.score_data)));
    const bool two = one.candidates.size() == 2;
    return one.gain - (two ? 2.0 : 1.0) * cost_of_number - std::log(two ? 0.5 * n * n : n);
}

double worth_of_unknown(const DiagnosisState& found) {
    return std::max(found.unknown_fit.gain, found.unknown.gain()) - cost_of_number -
           std::log(static_cast<double>(found.score_data.unknowns.terms.size()));
}

/// A cause or a source by itself is beyond chance.
bool is_one_significant(const ScoreTestData& score_data, const MostSignificantTerm& unknown) {
    double most = 0.0;
    for (Eigen::Index k = 0; k < score_data.scores.z.size(); ++k) {
        most = std::max(most, admitted(score_data.scores.z[k], score_data.sign[k]));
    }
    return most > score_data.threshold || std::abs(unknown.z) > score_data.unknown_threshold;
}

/// Two causes together are, whether or not one is: two may hide each other.
bool is_a_pair_significant(const ScoreTestData& score_data) {
    return std::ranges::any_of(score_data.pairs, [&](const Pair& pair) {
        return score_of_pair(score_data.scores, score_data.sign, pair).gain > score_data.pair_threshold;
    });
}

/// What is left of the scores once one unknown source is taken out as well.
double largest_score_beside(const Scores& scores, std::size_t term) {
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

const FittedHypothesis* likeliest(const std::vector<FittedHypothesis>& from, bool insignificant_rest_only) {
    const FittedHypothesis* best = nullptr;
    for (const FittedHypothesis& one : from) {
        if (one.admissible && (one.rest_is_insignificant || !insignificant_rest_only) &&
            (best == nullptr || one.gain > best->gain)) {
            best = &one;
        }
    }
    return best;
}

/// Hypotheses that leave nothing, about as likely as the best of them.
std::vector<const FittedHypothesis*> standing(const std::vector<FittedHypothesis>& from, double least_gain,
                                              double behind) {
    std::vector<const FittedHypothesis*> set;
    const FittedHypothesis* best = likeliest(from, true);
    for (const FittedHypothesis& one : from) {
        if (one.rest_is_insignificant && one.gain > least_gain && one.gain > best->gain - behind) {
            set.push_back(&one);
        }
    }
    return set;
}

void look(DiagnosisState& found) {
    found.singles.clear();
    found.pairs.clear();
    found.unknown_fit = {};
    found.unknown = most_significant_term(found.score_data.unknown_scores);
    const bool one = is_one_significant(found.score_data, found.unknown);
    if (!one && !is_a_pair_significant(found.score_data)) {
        return;
    }
    if (one) {
        found.singles = fit_single_causes(found.score_data);
    }
    const auto set = standing(found.singles, found.unknown.gain() - unknown_over_one, behind_single);
    found.pairs = fit_cause_pairs(found.score_data, set.empty() ? 0.0 : set.front()->gain + two_over_one);
}

void take(DiagnosisState& found, std::vector<const FittedHypothesis*> set) {
    found.set = std::move(set);
    found.verdict = found.set.size() == 1 ? Verdict::named : Verdict::confounded;
}

/// The strongest unknown source, fitted.
void look_into_unknown(DiagnosisState& found) {
    if (found.unknown.z != 0.0) {
        const auto k = static_cast<Eigen::Index>(found.unknown.term);
        found.unknown_fit = counted(found.score_data, fit_unknown_source(found.score_data, found.unknown.term,
                                                                         found.score_data.unknown_scores.amplitude(k)));
    }
}

/// Whether the strongest unknown source is likely enough beside a cause that leaves nothing.
bool worth_reporting(const DiagnosisState& found, const FittedHypothesis& cause) {
    return std::abs(found.unknown.z) > found.score_data.unknown_threshold &&
           found.unknown.gain() > cause.gain + unknown_beside_one;
}

void decide(DiagnosisState& found) {
    if (!is_one_significant(found.score_data, found.unknown) && found.pairs.empty()) {
        found.verdict = Verdict::consistent;
        return;
    }
    const auto alone = standing(found.singles, found.unknown.gain() - unknown_over_one, behind_single);
    const auto two = standing(found.pairs, 0.0, behind_pair);
    if (!alone.empty() && (two.empty() || two.front()->gain < alone.front()->gain + two_over_one)) {
        take(found, alone);
        if (worth_reporting(found, *alone.front())) {
            look_into_unknown(found);
            found.unknown_stands = true;
            found.verdict = Verdict::confounded;
        }
        return;
    }
    // No single cause leaves nothing. What does must be worth its numbers; if nothing does, the likeliest is named and
    // what is left is said.
    look_into_unknown(found);
    const bool unknown_leaves_insignificant_rest =
        std::abs(found.unknown.z) > found.score_data.unknown_threshold &&
        (found.unknown_fit.sound ? found.unknown_fit.rest_is_insignificant
                                 : largest_score_beside(found.score_data.unknown_scores, found.unknown.term) <
                                       found.score_data.unknown_threshold);
    double best = unknown_leaves_insignificant_rest ? worth_of_unknown(found) : 0.0;
    found.verdict = Verdict::unknown;
    if (!two.empty() && worth(found, *two.front()) > best) {
        best = worth(found, *two.front());
        take(found, two);
    }
    for (const auto* list : {&found.singles, &found.pairs}) {
        const FittedHypothesis* one = likeliest(*list, false);
        if (one != nullptr && !one->rest_is_insignificant && worth(found, *one) > best) {
            best = worth(found, *one);
            take(found, {one});
            found.something_left = true;
        }
    }
    if (found.set.empty() && !is_one_significant(found.score_data, found.unknown)) {
        found.verdict = Verdict::consistent;  // two seemed significant together, and no fit of any pair confirmed it
        return;
    }
    if (!unknown_leaves_insignificant_rest && worth_of_unknown(found) > best) {
        found.set.clear();
        found.verdict = Verdict::unknown;
        found.something_left = true;
    }
}

}  // namespace

MostSignificantTerm most_significant_term(const Scores& scores) {
    MostSignificantTerm found;
    for (Eigen::Index k = 0; k < scores.z.size(); ++k) {
        if (std::abs(scores.z[k]) > std::abs(found.z)) {
            found = {.term = static_cast<std::size_t>(k), .z = scores.z[k]};
        }
    }
    return found;
}

const FittedHypothesis* DiagnosisState::best() const {
    if (verdict == Verdict::unknown) {
        return unknown_fit.sound ? &unknown_fit : nullptr;
    }
    return set.empty() ? nullptr : set.front();
}

void search_hypotheses(DiagnosisState& state) {
    look(state);
    const FittedHypothesis* one = likeliest(state.singles, false);
    const FittedHypothesis* two = likeliest(state.pairs, false);
    const FittedHypothesis* best =
        two != nullptr && (one == nullptr || two->gain > one->gain + two_over_one) ? two : one;
    if (best != nullptr && best->gain > nonlinear_gain && settle_noise(state.score_data, *best)) {
        look(state);
    }
    decide(state);
    const bool any_plausible = std::ranges::any_of(state.set, &FittedHypothesis::plausible);
    if (!state.set.empty() && !any_plausible) {
        state.verdict = Verdict::partial;  // nothing else explains the data, and it is said to be implausible
    }
}

}  // namespace tiretherm::diagnosis
