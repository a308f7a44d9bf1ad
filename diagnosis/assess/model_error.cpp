// SPDX-License-Identifier: BSD-3-Clause
// Errors of the model beside any cause: whether there are any, what a search by prediction makes of them, and what they do to
// the intervals.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "diagnosis/assess/diagnosis_state.hpp"
#include "diagnosis/assess/extension.hpp"
#include "diagnosis/fit/block_deviations.hpp"
#include "diagnosis/noise/white_equivalent.hpp"

namespace tiretherm::diagnosis {

namespace {

/// Noise this far above the data sheet's, in a channel of many samples, holds more than noise.
constexpr double swollen = 1.5;
constexpr double many = 50.0;
/// An rms beyond the noise that is smaller than this share of it is none.
constexpr double least_error = 0.5;
/// Improvements that stand beside the best in the set.
constexpr std::size_t most_alternatives = 3;
/// Blocks widen an interval by this factor at most where nothing else speaks of an error of the model: where few of them tell
/// what a number is, their scatter is uncertain itself.
constexpr double widest_undoubted = 2.0;

std::vector<double> samples_of(const Observations& observations) {
    std::vector<double> samples(observations.channels.size(), 0.0);
    for (const Block& block : observations.blocks) {
        if (block.channel >= 0) {
            samples[static_cast<std::size_t>(block.channel)] += static_cast<double>(block.rows());
        }
    }
    return samples;
}

/// Sum over time of the autocorrelation of what a channel leaves, up to where it first vanishes. @returns s
double time_scale(const Observations& observations, const Eigen::VectorXd& left, int noise) {
    double longest = 0.0;
    double weight = 0.0;
    for (const Block& block : observations.blocks) {
        if (block.channel != noise || block.rows() < 10) {
            continue;
        }
        const Eigen::VectorXd x = left.segment(block.first, block.rows());
        const double interval = (block.time.back() - block.time.front()) / static_cast<double>(block.rows() - 1);
        const double power = x.squaredNorm() / static_cast<double>(x.size());
        double sum = 0.5;
        for (Eigen::Index lag = 1; lag < x.size() / 2; ++lag) {
            const Eigen::Index n = x.size() - lag;
            const double r = x.head(n).dot(x.tail(n)) / (static_cast<double>(n) * power);
            if (r <= 0.0) {
                break;
            }
            sum += r;
        }
        longest += sum * interval * power;
        weight += power;
    }
    return weight > 0.0 ? longest / weight : 0.0;
}

/// A richer model fitted with white noise from the same start as the base, and how it predicts.
std::optional<PredictedModel> predicted_on(ScoreTestData& score_data, const RicherModel& richer,
                                           const Covariance& noise) {
    PredictedModel model;
    model.noise = noise;
    model.words = richer.name;
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

/// Whether what is left of every channel is no more than its sensor's noise.
bool leaves_noise_alone(const ScoreTestData& score_data, const HeldOutErrors& out) {
    const Observations& observations = *score_data.observations;
    for (std::size_t c = 0; c < observations.channels.size(); ++c) {
        const double floor = observations.stated[c] > 0.0 ? observations.stated[c] : 0.0;
        if (floor == 0.0 || std::sqrt(out.mean_square(observations, c)) > swollen * floor) {
            return false;
        }
    }
    return true;
}

/// Fits that stand beside the best one where these data leave the model in doubt: those of the other members of the set, and
/// of the case with nothing added. What a free number is depends on which of them is right.
/// @param error the model has an error that is not named
std::vector<const Refit*> other_fits(const DiagnosisState& state, bool error) {
    std::vector<const Refit*> others;
    const bool doubtful = error || state.something_left || state.verdict == Verdict::partial;
    if (!doubtful) {
        return others;
    }
    for (std::size_t i = 1; i < state.set.size(); ++i) {
        others.push_back(&state.set[i]->fit);
    }
    for (const FittedHypothesis& one : state.singles) {
        if (one.admissible && state.mesh.empty()) {  // on another mesh the numbers are others
            others.push_back(&one.fit);
        }
    }
    if (state.search) {
        others.push_back(&state.search->base.hypothesis.fit);
        for (const Improvement& one : state.search->accepted) {
            others.push_back(&one.model.hypothesis.fit);
        }
    } else {
        others.push_back(&state.score_data.base);
    }
    return others;
}

}  // namespace

bool has_model_error(const ScoreTestData& score_data) {
    const Observations& observations = *score_data.observations;
    const std::vector<double> samples = samples_of(observations);
    double longest_run = 0.0;
    for (const std::vector<double>& times : observations.times) {
        longest_run = std::max(longest_run, times.empty() ? 0.0 : times.back() - times.front());
    }
    for (std::size_t c = 0; c < observations.channels.size(); ++c) {
        const Noise& noise = score_data.noise.channels[c];
        if (samples[c] < many) {
            continue;
        }
        const double stated = observations.stated[c];
        const bool as_slow_as_allowed = noise.correlation_time > 0.0 &&
                                        noise.correlation_time > 0.99 * 0.1 * longest_run && noise.white_share < 0.5;
        if (stated > 0.0 ? noise.sigma > swollen * stated : as_slow_as_allowed) {
            return true;
        }
    }
    return false;
}

std::vector<std::size_t> by_score(const ScoreTestData& score_data, std::size_t most) {
    std::vector<std::pair<double, std::size_t>> ranking;
    for (std::size_t k = 0; k < score_data.candidates.size(); ++k) {
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
    score_data.say("predicting data that are left out");
    state.search = choose_base(score_data);
    search_by_prediction(score_data, *state.search);
    PredictionSearch& search = *state.search;

    // A richer mesh is a cause, too: it is taken where it predicts better than the best cause on this one.
    const Covariance even = search.white ? search.base.noise
                                          : white_equivalent(score_data.noise, score_data.observations->blocks);
    for (const RicherModel& one : richer) {
        score_data.say(fmt::format("trying the mesh \"{}\"", one.name));
        const std::optional<PredictedModel> model = predicted_on(score_data, one, even);
        if (!model) {
            continue;
        }
        const PredictionGain gain = compare_predictions(search.base.out, model->out, *score_data.observations,
                                                        score_data.noise.channels, score_data.observations->stated);
        if (gain.low <= 0.0 || gain.removed < 0.03) {
            search.largest_gain = std::max(search.largest_gain, gain.removed);
            continue;
        }
        state.other_meshes.push_back(one.name);
        if (search.accepted.empty() || gain.removed > search.gain.removed) {
            ScoreTestData on_it =
                prepare_score_tests(*one.experiment, *score_data.observations,
                                    candidates_of(*one.experiment, one.experiment->candidates), score_data.progress);
            if (!on_it.status.ok()) {
                continue;
            }
            PredictionSearch there;
            there.base = *model;
            there.white = true;
            there.base.noise = white_equivalent(on_it.noise, on_it.observations->blocks);
            on_it.simulations += score_data.simulations;
            search_by_prediction(on_it, there);
            const PredictedModel& best = there.best();
            there.gain = compare_predictions(search.base.out, best.out, *score_data.observations,
                                             score_data.noise.channels, score_data.observations->stated);
            if (there.accepted.empty()) {
                there.accepted.push_back({.model = *model, .gain = gain});
            }
            there.base = search.base;
            there.mesh = one.name;
            std::ranges::copy(search.remarks, std::back_inserter(there.remarks));
            score_data = std::move(on_it);
            search = std::move(there);
            state.mesh = one.name;
            state.change = one.change;
        }
    }

    take_what_was_found(state);
}

namespace {

HeldOutErrors out_of(ScoreTestData& score_data, const input::Experiment& model, const Refit& fit) {
    score_data.say("predicting data that are left out");
    HeldOutErrors found = held_out(model, *score_data.observations, score_data.noise, score_data.steps, fit);
    score_data.count(found.simulations);
    return found;
}

/// Whether the unknown source that was fitted predicts better than something else, beyond doubt.
bool unknown_source_beats(DiagnosisState& state, const HeldOutErrors& before) {
    const HeldOutErrors after = out_of(state.score_data, state.unknown_fit.model, state.unknown_fit.fit);
    const Observations& observations = *state.score_data.observations;
    return after.ok && compare_predictions(before, after, observations, state.score_data.noise.channels,
                                           observations.stated)
                               .low > 0.0;
}

}  // namespace

bool unknown_source_predicts(DiagnosisState& state) {
    if (state.verdict != Verdict::unknown || !state.unknown_fit.sound) {
        return true;
    }
    return unknown_source_beats(state,
                                out_of(state.score_data, *state.score_data.experiment, state.score_data.base));
}

void take_heat_without_a_name(DiagnosisState& state) {
    ScoreTestData& score_data = state.score_data;
    state.unknown = most_significant_term(score_data.unknown_scores);
    if (std::abs(state.unknown.z) < score_data.unknown_threshold) {
        return;
    }
    score_data.say("trying heat that no effect is");
    const auto k = static_cast<Eigen::Index>(state.unknown.term);
    state.unknown_fit = fit_unknown_source(score_data, state.unknown.term, score_data.unknown_scores.amplitude(k));
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
    const bool better = found && (!state.mesh.empty() || best == nullptr || !of_best.ok ||
                                  compare_predictions(of_best, state.search->best().out, *score_data.observations,
                                                      score_data.noise.channels, score_data.observations->stated)
                                          .removed > 0.0);
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

void describe_model_error(const DiagnosisState& state, Diagnosis& into) {
    const ScoreTestData& score_data = state.score_data;
    const Observations& observations = *score_data.observations;
    const Eigen::VectorXd left = observations.measured - into.extended;
    const std::vector<int> noise_of = noise_of_rows(observations);
    std::vector<Noise> slow = score_data.noise.channels;
    // The noise beside the span of all candidates says nothing of an error that one of them could explain and none does.
    const bool doubted = state.search || state.something_left || has_model_error(score_data);
    for (std::size_t c = 0; c < observations.channels.size(); ++c) {
        HeldOutErrors all{.left = left};
        const double square = all.mean_square(observations, c);
        const double stated = observations.stated[c];
        // Where no data sheet says it, what is new in every sample is the sensor's.
        const Noise& noise = score_data.noise.channels[c];
        const double floor = stated > 0.0 ? stated : noise.sigma * std::sqrt(noise.white_share);
        const double beyond = std::sqrt(std::max(0.0, square - floor * floor));
        if (beyond > least_error * floor && std::isfinite(beyond) && doubted) {
            const double seconds = time_scale(observations, left, static_cast<int>(c));
            into.model_error.push_back({.channel = observations.channels[c], .size = beyond, .time_scale = seconds});
            slow[c].correlation_time = std::max(slow[c].correlation_time, seconds);
        }
    }
    const FittedHypothesis* best = state.best();
    const Refit& fit = best != nullptr ? best->fit : score_data.base;
    const std::vector<solver::FreeParameter>& numbers =
        best != nullptr ? best->model.parameters : score_data.experiment->parameters;
    // What the model gets wrong differs from block to block, even where it is too small to be seen in the residuals.
    BlockDeviations deviations{.deviation = fit.deviations()};
    const Eigen::VectorXd noise_alone = deviations.wide * deviations.deviation;
    if (!observations.channels.empty()) {
        deviations = block_deviations(fit, observations, length_of_blocks(observations, slow));
    }
    // How far a number moves when runs are left out shows what the scatter within them does not.
    Eigen::VectorXd jackknife;
    if (doubted) {
        jackknife = jackknife_half_widths(state.search ? state.search->best().out.values : state.of_folds);
    }
    const auto half_of = [&](Eigen::Index j) {
        double blocks = deviations.wide * deviations.deviation[j];
        if (!doubted) {
            blocks = std::min(blocks, widest_undoubted * noise_alone[j]);
        }
        return j < jackknife.size() ? std::max(blocks, jackknife[j]) : blocks;
    };
    const std::vector<const Refit*> others = other_fits(state, !into.model_error.empty());
    for (std::size_t j = 0; j < score_data.experiment->parameters.size(); ++j) {
        const auto i = static_cast<Eigen::Index>(j);
        const double half = half_of(i);
        double low = fit.values[i] - half;
        double high = fit.values[i] + half;
        for (const Refit* other : others) {
            if (i < other->values.size()) {
                low = std::min(low, other->values[i] - half);
                high = std::max(high, other->values[i] + half);
            }
        }
        into.free_numbers.push_back({.name = numbers[j].name,
                                     .unit = numbers[j].unit,
                                     .value = fit.values[i],
                                     .low = std::max(numbers[j].low, low),
                                     .high = std::min(numbers[j].high, high)});
    }
    if (best == nullptr) {
        return;
    }
    // The sizes of the causes carry the same errors.
    for (std::size_t i = 0; i < best->candidates.size() && i < into.causes.size(); ++i) {
        const Eigen::Index j = best->number_of(i);
        for (CauseNumber& number : into.causes[i].numbers) {
            if (number.value == best->fit.values[j]) {
                const double half = half_of(j);
                number.low = std::min(number.low, number.value - half);
                number.high = std::max(number.high, number.value + half);
            }
        }
    }
}

}  // namespace tiretherm::diagnosis
