// SPDX-License-Identifier: BSD-3-Clause
// The search by prediction as a part of a diagnosis: on the case's mesh and on richer ones, for causes and for heat that no
// effect is; and what of it becomes the verdict.

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "diagnosis/assess/diagnosis_state.hpp"
#include "diagnosis/assess/extension.hpp"
#include "diagnosis/assess/tried_additions.hpp"
#include "diagnosis/fit/block_deviations.hpp"
#include "diagnosis/noise/white_equivalent.hpp"

namespace tiretherm::diagnosis {

namespace {

/// Improvements that stand beside the best in the set.
constexpr std::size_t most_alternatives = 3;

/// A richer model fitted with white noise from the same start as the base, and how it predicts.
std::optional<PredictedModel> predicted_on(ScoreTestData& score_data, const RicherModel& richer,
                                           const Covariance& noise) {
    PredictedModel model;
    model.noise = noise;
    model.base = BaseModel::other_mesh;
    model.mesh = richer.name;
    model.hypothesis.model = *richer.experiment;
    Fit fit(model.hypothesis.model, *score_data.observations);
    fit.take_covariance(noise);
    if (!fit.move_to(fit.simulator().start())) {
        return std::nullopt;
    }
    model.hypothesis.fit = refit(fit);
    model.hypothesis.sound = model.hypothesis.fit.status.ok();
    score_data.count(fit.simulator().simulations());
    if (!model.hypothesis.sound) {
        return std::nullopt;
    }
    model.out = held_out(model.hypothesis.model, *score_data.observations, noise, fit.simulator().steps(),
                         model.hypothesis.fit);
    score_data.count(model.out.simulations);
    return model.out.ok ? std::optional(std::move(model)) : std::nullopt;
}

RicherMesh described(const std::string& name, const PredictedModel& model, const PredictionGain& gain,
                     const ScoreTestData& score_data) {
    const Observations& observations = *score_data.observations;
    RicherMesh mesh{.name = name,
                    .is_better = is_improvement(gain),
                    .removed = gain.removed,
                    .low = gain.low,
                    .high = gain.high,
                    .change = largest_change(gain, observations)};
    const Refit& fit = model.hypothesis.fit;
    const BlockDeviations deviations =
        block_deviations(fit, observations, length_of_blocks(observations, score_data.noise.channels));
    for (std::size_t j = 0; j < model.hypothesis.model.parameters.size(); ++j) {
        const solver::FreeParameter& number = model.hypothesis.model.parameters[j];
        const auto i = static_cast<Eigen::Index>(j);
        const double half = deviations.wide * deviations.deviation[i];
        mesh.numbers.push_back({.name = number.name,
                                .unit = number.unit,
                                .value = fit.values[i],
                                .low = std::max(number.low, fit.values[i] - half),
                                .high = std::min(number.high, fit.values[i] + half)});
    }
    return mesh;
}

/// A richer mesh is a cause, too: it is taken where with its own causes it predicts better than what was found with its. Alone it
/// need not: a sensor that is late hides a surface that is too slow.
void search_on(DiagnosisState& state, const RicherModel& richer) {
    ScoreTestData& score_data = state.score_data;
    PredictionSearch& search = *state.search;
    const Observations& observations = *score_data.observations;
    const auto gain_over = [&](const PredictedModel& before, const PredictedModel& after) {
        return compare_predictions(before.out, after.out, observations, score_data.noise.channels, observations.stated);
    };
    score_data.say({.doing = Work::other_mesh, .of = richer.name});
    --score_data.course.richer;
    const Covariance even = white_noise_of(observations.measured - search.best().hypothesis.fit.simulated,
                                           observations.blocks, observations.channels.size());
    const std::optional<PredictedModel> model = predicted_on(score_data, richer, even);
    if (!model) {
        return;
    }
    const PredictionGain gain = gain_over(search.base, *model);
    if (is_improvement(gain)) {
        state.other_meshes.push_back(richer.name);
    }
    state.richer_meshes.push_back(described(richer.name, *model, gain, score_data));
    ScoreTestData on_it;
    on_it.progress = score_data.progress;
    on_it.simulations = score_data.simulations;
    on_it.course.richer = score_data.course.richer;
    prepare_score_tests(*richer.experiment, observations,
                        candidates_of(*richer.experiment, richer.experiment->candidates), on_it);
    if (!on_it.status.ok()) {
        return;
    }
    PredictionSearch there;
    there.base = *model;
    there.white = true;
    search_by_prediction(on_it, there);
    score_data.simulations = on_it.simulations;
    there.gain = gain_over(search.base, there.best());
    if (!is_improvement(gain_over(search.best(), there.best())) || !is_improvement(there.gain)) {
        return;
    }
    state.richer_meshes.back().is_taken = true;
    state.tried = there.tried;
    if (there.accepted.empty()) {
        there.accepted.push_back({.model = *model, .gain = gain});
    }
    there.base = search.base;
    there.mesh = richer.name;
    std::ranges::copy(search.remarks, std::back_inserter(there.remarks));
    score_data = std::move(on_it);
    search = std::move(there);
    state.singles.clear();  // their candidates are those of the other mesh
    state.pairs.clear();
    state.unknown_stands = false;
    state.mesh = richer.name;
    state.change = richer.change;
}

/// Whether what is left of every channel is no more than its sensor's noise, as stated or as it plainly is.
bool leaves_noise_alone(const ScoreTestData& score_data, const HeldOutErrors& out) {
    const Observations& observations = *score_data.observations;
    for (std::size_t c = 0; c < observations.channels.size(); ++c) {
        const double left = std::sqrt(out.mean_square(observations, c));
        const double floor = is_plainly_noise(score_data, c) ? score_data.noise.channels[c].sigma : 0.0;
        const double stated = std::max(0.0, observations.stated[c]);
        if (!(stated > 0.0) || left > std::max(swollen * stated, as_large * floor)) {
            return false;
        }
    }
    return true;
}

HeldOutErrors out_of(ScoreTestData& score_data, const input::Experiment& model, const Refit& fit) {
    score_data.say({.doing = Work::left_out_data});
    HeldOutErrors found = held_out(model, *score_data.observations, score_data.noise, score_data.steps, fit);
    score_data.count(found.simulations);
    return found;
}

/// Whether the unknown source that was fitted predicts better than something else, beyond doubt.
bool unknown_source_beats(DiagnosisState& state, const HeldOutErrors& before) {
    const HeldOutErrors after = out_of(state.score_data, state.unknown_fit.model, state.unknown_fit.fit);
    const Observations& observations = *state.score_data.observations;
    return after.ok &&
           compare_predictions(before, after, observations, state.score_data.noise.channels, observations.stated).low >
               0.0;
}

}  // namespace

std::vector<std::size_t> by_score(const ScoreTestData& score_data, std::size_t most) {
    std::vector<std::pair<double, std::size_t>> ranking;
    const auto scored = static_cast<std::size_t>(score_data.scores.z.size());  // none before the score tests
    for (std::size_t k = 0; k < scored; ++k) {
        const auto i = static_cast<Eigen::Index>(k);
        ranking.emplace_back(admitted(score_data.scores.z[i], score_data.sign[i]), k);
    }
    std::ranges::sort(ranking, std::greater{});
    std::vector<std::size_t> chosen;
    for (const auto& [z, k] : ranking) {
        const bool known = std::ranges::any_of(chosen, [&, cause = score_data.candidates[k].cause](std::size_t other) {
            return score_data.candidates[other].cause == cause;
        });
        if (z > 0.0 && !known && chosen.size() < most) {
            chosen.push_back(k);
        }
    }
    return chosen;
}

void search_beside_model_error(DiagnosisState& state, const std::vector<RicherModel>& richer) {
    ScoreTestData& score_data = state.score_data;
    score_data.say({.doing = Work::left_out_data});
    state.search = choose_base(score_data);
    search_by_prediction(score_data, *state.search);
    state.tried = state.search->tried;
    for (const RicherModel& one : richer) {
        search_on(state, one);
    }
    take_what_was_found(state);
}

bool unknown_source_predicts(DiagnosisState& state) {
    if (state.verdict != Verdict::unknown || !state.unknown_fit.sound) {
        return true;
    }
    return unknown_source_beats(state, out_of(state.score_data, *state.score_data.experiment, state.score_data.base));
}

void accept_unknown_source(DiagnosisState& state) {
    ScoreTestData& score_data = state.score_data;
    state.unknown = most_significant_term(score_data.unknown_scores);
    if (std::abs(state.unknown.z) < score_data.unknown_threshold) {
        return;
    }
    score_data.say({.doing = Work::unknown_source});
    const auto k = static_cast<Eigen::Index>(state.unknown.term);
    state.unknown_fit =
        counted(score_data, fit_unknown_source(score_data, state.unknown.term, score_data.unknown_scores.amplitude(k)));
    if (state.unknown_fit.sound && unknown_source_beats(state, state.search->base.out)) {
        state.verdict = Verdict::unknown;
        state.search.reset();
    }
}

void search_for_more(DiagnosisState& state, const std::vector<RicherModel>& richer) {
    ScoreTestData& score_data = state.score_data;
    const Verdict verdict = state.verdict;
    const std::vector<const FittedHypothesis*> set = state.set;
    const FittedHypothesis* best = state.best();
    HeldOutErrors of_best;
    if (best != nullptr) {
        of_best = out_of(score_data, best->model, best->fit);
    }
    search_beside_model_error(state, richer);
    const bool found = !state.search->accepted.empty();
    const auto gain = [&](const HeldOutErrors& before, const HeldOutErrors& after) {
        return compare_predictions(before, after, *score_data.observations, score_data.noise.channels,
                                   score_data.observations->stated);
    };
    const bool better = found && (!state.mesh.empty() || best == nullptr || !best->plausible || !of_best.ok ||
                                  !is_improvement(gain(state.search->base.out, of_best)) ||
                                  gain(of_best, state.search->best().out).removed > 0.0);
    if (better) {
        state.something_left = false;  // the search says itself what is left
        return;
    }
    state.search.reset();
    state.verdict = verdict == Verdict::named || verdict == Verdict::confounded ? Verdict::partial : verdict;
    state.set = set;
    const FittedHypothesis* plausible = nullptr;
    for (const auto* list : {&state.singles, &state.pairs}) {
        for (const FittedHypothesis& one : *list) {
            if (one.admissible && one.plausible && (plausible == nullptr || one.gain > plausible->gain)) {
                plausible = &one;
            }
        }
    }
    const auto is_implausible = [](const FittedHypothesis* one) { return !one->plausible; };
    if (!state.something_left && plausible != nullptr && std::ranges::all_of(set, is_implausible)) {
        state.set.push_back(plausible);  // what explains everything by a size that nobody would believe is not alone
        return;
    }
    // Beside more than one thing that is missing, a size that nobody would believe is a coincidence.
    std::erase_if(state.set, is_implausible);
    if (state.set.empty() && !set.empty()) {
        state.set = plausible != nullptr ? std::vector{plausible} : set;
    }
    if (state.set.size() == 1 && set.size() == 1 && state.set.front()->candidates.size() == 1) {
        // The likelihoods of a model that lacks more than one thing do not tell close ones apart.
        const double least = set.front()->gain - std::max(5.0, 0.05 * set.front()->gain);
        for (const FittedHypothesis& one : state.singles) {
            if (&one != set.front() && one.admissible && one.plausible && one.gain > least &&
                state.set.size() <= most_alternatives) {
                state.set.push_back(&one);
            }
        }
    }
}

void take_what_was_found(DiagnosisState& state) {
    if (!state.search) {
        return;
    }
    const ScoreTestData& score_data = state.score_data;
    const PredictionSearch& search = *state.search;
    if (search.accepted.empty()) {
        state.verdict = leaves_noise_alone(score_data, search.base.out) ? Verdict::consistent : Verdict::cannot_tell;
        return;
    }
    state.set = {&search.best().hypothesis};
    for (std::size_t i = 0; i < std::min(most_alternatives, search.alternatives.size()); ++i) {
        state.set.push_back(&search.alternatives[i].model.hypothesis);
    }
    const bool nothing_left = leaves_noise_alone(score_data, search.best().out);
    state.verdict = !nothing_left ? Verdict::partial : (state.set.size() == 1 ? Verdict::named : Verdict::confounded);
}

}  // namespace tiretherm::diagnosis
