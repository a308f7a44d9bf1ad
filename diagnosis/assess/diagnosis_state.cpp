// SPDX-License-Identifier: BSD-3-Clause
// Writes the state of a diagnosis into its result: causes, unknown sources, what was tried and what it can be at most.

#include "diagnosis/assess/diagnosis_state.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "diagnosis/assess/cause_description.hpp"
#include "diagnosis/assess/tried_additions.hpp"
#include "diagnosis/assess/upper_limits.hpp"
#include "input/text/word_lists.hpp"

namespace tiretherm::diagnosis {

namespace {

constexpr double wide = 1.959964;  // 95 % of a normal distribution
/// In log likelihood: places and signals that are no less likely than this are named beside the best.
constexpr double alike_within = 5.0;

std::string place_of(const ScoreTestData& score_data, const UnknownTerm& term) {
    return term.sensor ? score_data.experiment->runs.front().problem.channels[term.place].name
                       : score_data.unknowns.places[term.place].name;
}

UnknownSource describe_unknown(const DiagnosisState& found) {
    const ScoreTestData& score_data = found.score_data;
    const UnknownTerm& term = score_data.unknowns.terms[found.unknown.term];
    const auto k = static_cast<Eigen::Index>(found.unknown.term);
    const Scores& scores = score_data.unknown_scores;
    UnknownSource source{
        .place = place_of(score_data, term), .sigma = std::abs(found.unknown.z), .sensor = term.sensor};
    const double largest = term.event ? 1.0 : score_data.unknowns.signals[term.signal].largest;
    double per = scores.amplitude(k) / largest;
    double deviation = 1.0 / (scores.length[k] * largest);
    if (found.unknown_fit.sound) {
        const Eigen::Index j = score_data.base.values.size();
        per = found.unknown_fit.fit.values[j];
        deviation = found.unknown_fit.fit.deviations()[j];
    }
    source.per = per;
    source.watts = largest * per;
    source.low = largest * (per - wide * deviation);
    source.high = largest * (per + wide * deviation);
    if (term.event) {
        source.follows = "time window";
        source.unit = "1";
        source.from = term.from;
        source.to = term.to;
        source.run = score_data.experiment->runs[term.run].name;
    } else {
        source.follows = score_data.unknowns.signals[term.signal].follows;
        source.unit = score_data.unknowns.signals[term.signal].unit;
    }
    for (std::size_t other = 0; other < score_data.unknowns.terms.size(); ++other) {
        const UnknownTerm& one = score_data.unknowns.terms[other];
        const double z = scores.z[static_cast<Eigen::Index>(other)];
        if (other != found.unknown.term && found.unknown.gain() - 0.5 * z * z < alike_within && !one.event) {
            source.alike.push_back(place_of(score_data, one) + ", " + score_data.unknowns.signals[one.signal].follows);
        }
    }
    return source;
}

/// Causes of the set first, hypothesis by hypothesis, then the others that were tried alone.
void describe_causes(const DiagnosisState& found, Diagnosis& into) {
    std::vector<std::size_t> described;  // Candidate::cause of each
    const auto describe = [&](const FittedHypothesis& one, bool in_set) {
        std::vector<std::size_t> members;
        for (std::size_t i = 0; i < one.candidates.size(); ++i) {
            const std::size_t cause = found.score_data.candidates[one.candidates[i]].cause;
            const auto known = std::ranges::find(described, cause);
            members.push_back(static_cast<std::size_t>(known - described.begin()));
            if (known == described.end()) {
                described.push_back(cause);
                into.causes.push_back(describe_cause(found.score_data, one, i));
                into.causes.back().in_set = in_set;
                into.causes.back().rank = static_cast<int>(described.size());
            }
        }
        if (in_set) {
            into.hypotheses.push_back(std::move(members));
        }
    };
    // A richer mesh was there before what was added to it.
    const bool has_mesh = !found.mesh.empty() && !found.set.empty();
    if (has_mesh) {
        into.causes.push_back({.kind = CauseKind::mesh, .id = "mesh", .place = found.mesh, .in_set = true, .rank = 1});
        described.push_back(static_cast<std::size_t>(-1));
    }
    for (const FittedHypothesis* one : found.set) {
        describe(*one, true);
    }
    if (has_mesh) {
        into.hypotheses.front().insert(into.hypotheses.front().begin(), 0);
    }
    for (const std::string& mesh : found.other_meshes) {
        if (mesh != found.mesh && !into.hypotheses.empty()) {
            into.hypotheses.push_back({into.causes.size()});
            into.causes.push_back({.kind = CauseKind::mesh, .id = "mesh", .place = mesh, .in_set = true});
            described.push_back(static_cast<std::size_t>(-1));
            into.causes.back().rank = static_cast<int>(described.size());
        }
    }
    for (const FittedHypothesis& one : found.singles) {
        if (one.sound) {
            describe(one, false);
        }
    }
    if (found.search) {
        return;  // ranked by what they predict, not by their likelihood
    }
    double sum = 0.0;
    for (const FittedHypothesis* one : found.set) {
        sum += std::exp(one->gain - found.set.front()->gain);
    }
    for (std::size_t e = 0; e < found.set.size(); ++e) {
        for (const std::size_t member : into.hypotheses[e]) {
            into.causes[member].probability += std::exp(found.set[e]->gain - found.set.front()->gain) / sum;
        }
    }
}

/// What was tested on data that were left out, and what was put aside.
void describe_search(const PredictionSearch& search, const DiagnosisState& found, Diagnosis& into) {
    std::ranges::copy(search.remarks, std::back_inserter(into.remarks));
    const auto add = [&](std::size_t hypothesis, const PredictionGain& gain) {
        if (hypothesis < into.hypotheses.size()) {
            into.held_out_gains.push_back(
                {.causes = into.hypotheses[hypothesis], .removed = gain.removed, .low = gain.low, .high = gain.high});
        }
    };
    if (!search.accepted.empty()) {
        add(0, search.gain);
    }
    for (std::size_t i = 1; i < found.set.size(); ++i) {
        add(i, search.alternatives[i - 1].gain);
    }
}

/// The likeliest hypothesis that may not be in a verdict, where it is likelier than all that may.
const FittedHypothesis* implausible(const DiagnosisState& found) {
    const FittedHypothesis* best = nullptr;
    double admitted = 0.0;
    for (const auto* list : {&found.singles, &found.pairs}) {
        for (const FittedHypothesis& one : *list) {
            if (one.admissible) {
                admitted = std::max(admitted, one.gain);
            } else if (one.sound && (best == nullptr || one.gain > best->gain)) {
                best = &one;
            }
        }
    }
    return best != nullptr && best->gain > admitted + alike_within ? best : nullptr;
}

}  // namespace

void report(const DiagnosisState& found, Diagnosis& into) {
    into.verdict = found.verdict;
    describe_causes(found, into);
    if (found.verdict == Verdict::unknown || found.unknown_stands) {
        into.unknown = describe_unknown(found);
    }
    if (found.verdict == Verdict::consistent) {
        into.reason = noise_above_sheet(found.score_data);
    }
    into.limits = upper_limits(found);
    for (TriedModel& trial : ranked(found.search && found.tried.empty() ? found.search->tried : found.tried)) {
        into.tried.push_back(std::move(trial.addition));
    }
    into.richer_meshes = found.richer_meshes;
    into.n_candidates = n_causes(found.score_data);
    if (const FittedHypothesis* better = implausible(found)) {
        std::vector<std::string> names;
        for (const std::size_t k : better->candidates) {
            names.emplace_back(found.score_data.candidates[k].effect->id);
        }
        into.remarks.push_back(remark::fits_at_bound_only(input::listed(names)));
    }
    if (found.search) {
        describe_search(*found.search, found, into);
    }
    if (found.something_left) {
        into.remarks.push_back(remark::more_is_missing());
    }
    into.values = found.score_data.base.values;
    into.base = found.score_data.base.simulated;
    into.noise = found.score_data.noise.channels;
    const FittedHypothesis* best = found.best();
    into.extended = best != nullptr ? best->fit.simulated : into.base;
    // A window of one run is nothing that a case could have.
    const bool is_event =
        found.verdict == Verdict::unknown && found.score_data.unknowns.terms[found.unknown.term].event;
    if (best != nullptr && !is_event) {
        into.extended_model = best->model;
        into.extended_values = best->fit.values;
        into.extended_mesh = found.change;
        if (found.verdict == Verdict::unknown) {
            into.extended_user_effects = {user_effect(found.score_data, found.unknown.term, 0)};
        }
    }
    into.simulations = found.score_data.simulations;
}

}  // namespace tiretherm::diagnosis
