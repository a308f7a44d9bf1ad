// SPDX-License-Identifier: BSD-3-Clause
// Forward selection by the error on data that were left out, with a look back at what later causes make superfluous.

#include "diagnosis/assess/prediction_search.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "diagnosis/assess/additions.hpp"
#include "diagnosis/assess/extension.hpp"
#include "diagnosis/assess/tried_additions.hpp"
#include "diagnosis/noise/white_equivalent.hpp"
#include "mesh/parallel.hpp"

namespace tiretherm::diagnosis {

namespace {

/// Additions that are fitted at each step before enough of them are admissible, how many that is, and of these how many are tested on
/// data that were left out.
struct Effort {
    std::size_t fitted;
    std::size_t admissible;
    std::size_t tested;
};
constexpr Effort usual{.fitted = 5, .admissible = 2, .tested = 3};
constexpr Effort little{.fitted = 3, .admissible = 2, .tested = 2};
/// Steps of all runs times nodes from which on a simulation is dear.
constexpr std::size_t dear = 30'000;
constexpr std::size_t fewest_nodes = 10;  ///< below, a step costs no less
/// A cause that removes less of the mean square than this is not worth a number.
constexpr double least_removed = 0.03;
/// What is promised less than this share of what the best addition is promised need not be tested beside it.
constexpr double as_good = 0.7;
/// Nor need be fitted what is promised less than this share of what is predicted of the best fit; at the next step it is again.
constexpr double worth_a_fit = 0.5;
/// A channel's rms may rise by this share, by chance.
constexpr double tolerated_rise = 0.02;
/// And by this share of what is removed: with a large fault gone the others move, and later additions make up for it.
constexpr double rise_of_removed = 0.1;
/// What removes less than this beyond doubt must not worsen any run.
constexpr double beyond_one_run = 0.1;
/// Of looking back.
constexpr int most_turns = 2;
/// Of what an addition must remove, the part that the linearised model must promise of it.
constexpr double least_promised = 0.7;

PredictionGain gain_over(const PredictedModel& before, const PredictedModel& after, const ScoreTestData& score_data) {
    const Observations& observations = *score_data.observations;
    return compare_predictions(before.out, after.out, observations, score_data.noise.channels, observations.stated);
}

Effort effort_of(const ScoreTestData& score_data) {
    std::size_t steps = 0;
    for (const std::vector<double>& run : score_data.steps) {
        steps += run.size();
    }
    const auto nodes = static_cast<std::size_t>(score_data.experiment->runs.front().problem.mesh.n_nodes);
    return steps * std::max(nodes, fewest_nodes) < dear ? usual : little;
}

/// Additions that were fitted.
struct FittedGroups {
    std::set<std::vector<std::size_t>> now;  ///< at this step
    std::set<std::vector<std::size_t>>
        dull;             ///< timing that removed nothing when it was fitted: from then on it counts like others
    bool are_all = true;  ///< none that is promised enough was put off for a better one
};

/// One more addition, fitted.
struct Trial {
    FittedHypothesis hypothesis;
    double promised =
        0.0;  ///< share of the mean square that is removed on data that were left out, to first order about the fit
};

void remark_on_end(const ScoreTestData& score_data, const FittedHypothesis& one, PredictionSearch& search) {
    for (std::size_t i = 0; i < one.candidates.size(); ++i) {
        const Eigen::Index j = one.number_of(i);
        const Candidate& candidate = score_data.candidates[one.candidates[i]];
        if (!one.fit.at_bound[static_cast<std::size_t>(j)] || one.fit.values[j] == candidate.absent) {
            continue;
        }
        const Remark remark = remark::fits_at_end_of_range(name_of(candidate, *score_data.experiment),
                                                           std::string(candidate.number().key), one.fit.values[j]);
        if (std::ranges::find(search.remarks, remark) == search.remarks.end()) {
            search.remarks.push_back(remark);
        }
    }
}

/// Fits additions until enough of them are admissible: timing, which is no line in its size and so promised too little of, then those
/// that are promised most of. What ends at the end of what is plausible is set aside. @returns the best first
std::vector<Trial> try_all(ScoreTestData& score_data, const PredictedModel& now, FittedGroups& done,
                           PredictionSearch& search) {
    const Effort effort = effort_of(score_data);
    const LinearPrediction linear = linear_beside(score_data, now.hypothesis, now.noise, true);
    const LinearPrediction::MeanSquares before = linear.with({});
    std::vector<CauseGroup> additions = additions_to(score_data, now.hypothesis, linear);
    std::stable_partition(additions.begin(), additions.end(), [](const CauseGroup& one) { return one.is_timing; });
    std::vector<Trial> trials;
    std::size_t fitted = 0;
    std::size_t admissible = 0;
    double best = 0.0;
    const auto is_always = [&](const CauseGroup& one) {
        return one.is_timing && !done.dull.contains(one.candidates) && !done.now.contains(one.candidates);
    };
    const auto fit = [&](const CauseGroup& one) {
        return extended(score_data, now.hypothesis, one.candidates,
                        linear.amplitudes({one.candidates.begin(), one.candidates.end()}), now.noise);
    };
    const auto say = [&](const CauseGroup& one, std::size_t number) {
        score_data.say({.doing = Work::candidate,
                        .of = name_of(score_data.candidates[one.candidates.front()], *score_data.experiment),
                        .number = number,
                        .count = effort.fitted});
    };
    // What is fitted in any case is fitted first, several at a time.
    std::vector<std::optional<FittedHypothesis>> fits(additions.size());
    if (const auto first = std::ranges::find_if(additions, is_always); first != additions.end()) {
        say(*first, 1);
    }
    in_parallel(additions.size(), [&](std::size_t i) {
        if (is_always(additions[i])) {
            fits[i] = fit(additions[i]);
        }
    });
    for (std::size_t i = 0; i < additions.size(); ++i) {
        const CauseGroup& addition = additions[i];
        const bool always = is_always(addition);
        if (done.now.contains(addition.candidates)) {
            continue;
        }
        if (!always && (addition.promised < least_promised * least_removed || fitted == effort.fitted ||
                        admissible == effort.admissible)) {
            continue;
        }
        if (!always && addition.promised < worth_a_fit * best) {
            done.are_all = false;
            continue;
        }
        say(addition, fitted + 1);
        Trial trial{.hypothesis = counted(score_data, fits[i] ? std::move(*fits[i]) : fit(addition))};
        done.now.insert(addition.candidates);
        done.dull.insert(addition.candidates);
        fitted += always ? 0 : 1;
        if (!trial.hypothesis.sound) {
            continue;
        }
        trial.promised = share_removed(before, linear_beside(score_data, trial.hypothesis, now.noise, false).with({}));
        if (trial.promised > 0.0) {
            search.tried.push_back(trial_of(score_data, trial.hypothesis, now.hypothesis, trial.promised));
        }
        if (!trial.hypothesis.admissible) {
            remark_on_end(score_data, trial.hypothesis, search);
            continue;
        }
        admissible += always ? 0 : 1;
        best = std::max(best, trial.promised);
        if (trial.promised > least_promised * least_removed) {
            done.dull.erase(addition.candidates);
            trials.push_back(std::move(trial));
        }
    }
    std::ranges::sort(trials, std::greater{}, [](const Trial& one) { return worth_of(one.promised, one.hypothesis); });
    trials.resize(std::min(trials.size(), effort.tested));
    return trials;
}

/// The model with another addition in the place of one of its causes, where that predicts better.
/// @param less the model without the cause
std::optional<PredictedModel> swapped(ScoreTestData& score_data, const PredictedModel& now,
                                      const FittedHypothesis& less, std::size_t dropped) {
    const LinearPrediction linear = linear_beside(score_data, less, now.noise, true);
    const LinearPrediction::MeanSquares before = linear_beside(score_data, now.hypothesis, now.noise, false).with({});
    for (const CauseGroup& addition : additions_to(score_data, less, linear)) {
        const bool is_same = std::ranges::any_of(addition.candidates, [&](std::size_t k) {
            return score_data.candidates[k].cause == score_data.candidates[dropped].cause;
        });
        const std::vector<Eigen::Index> columns{addition.candidates.begin(), addition.candidates.end()};
        if (is_same) {
            continue;
        }
        if (share_removed(before, linear.with(columns)) < least_removed) {
            return std::nullopt;
        }
        FittedHypothesis other =
            counted(score_data, extended(score_data, less, addition.candidates, linear.amplitudes(columns), now.noise));
        if (other.sound && other.admissible) {
            PredictedModel model = predicted(score_data, std::move(other), now.noise);
            return model.out.ok && is_improvement(gain_over(now, model, score_data)) ? std::optional(std::move(model))
                                                                                     : std::nullopt;
        }
    }
    return std::nullopt;
}

/// Drops a cause that later ones have made superfluous, or puts another in its place that predicts better.
/// @returns whether anything changed
bool look_back(ScoreTestData& score_data, PredictionSearch& search) {
    const PredictedModel now = search.best();
    const std::size_t n = now.hypothesis.candidates.size();
    const LinearPrediction::MeanSquares before = linear_beside(score_data, now.hypothesis, now.noise, false).with({});
    for (std::size_t cause = 0; n > 1 && cause < n; ++cause) {
        score_data.say({.doing = Work::looking_back});
        FittedHypothesis fewer = counted(score_data, reduced(score_data, now.hypothesis, cause, now.noise));
        if (!fewer.sound) {
            continue;
        }
        const double promised = share_removed(linear_beside(score_data, fewer, now.noise, false).with({}), before);
        if (promised < least_removed) {
            PredictedModel less = predicted(score_data, fewer, now.noise);
            const PredictionGain lost = gain_over(less, now, score_data);
            if (lost.removed < superfluous || lost.low < -superfluous) {
                search.accepted.back() = {.model = std::move(less), .gain = {}};
                return true;
            }
        }
        if (std::optional<PredictedModel> other = swapped(score_data, now, fewer, now.hypothesis.candidates[cause])) {
            search.accepted.back() = {.model = std::move(*other), .gain = {}};
            return true;
        }
    }
    return false;
}

/// Channels whose noises keep their proportions within this factor count as before.
constexpr double about_the_same = 1.3;

/// A model fitted anew with the noise that it leaves, so that every channel goes on counting alike.
PredictedModel settled(ScoreTestData& score_data, PredictedModel model) {
    const Covariance noise = alike(model.hypothesis, *score_data.observations);
    double least = 1e300;
    double most = 0.0;
    for (std::size_t c = 0; c < noise.channels.size(); ++c) {
        const double ratio = noise.channels[c].sigma / model.noise.channels[c].sigma;
        least = std::min(least, ratio);
        most = std::max(most, ratio);
    }
    const bool is_white =
        std::ranges::all_of(model.noise.channels, [](const Noise& one) { return one.white_share == 1.0; });
    if (model.base != BaseModel::as_it_stands && is_white && most < about_the_same * least) {
        return model;
    }
    FittedHypothesis again = counted(score_data, refitted(score_data, model.hypothesis, noise));
    if (!again.sound) {
        return model;
    }
    PredictedModel found = predicted(score_data, std::move(again), noise);
    return found.out.ok ? found : model;
}

}  // namespace

PredictedModel predicted(ScoreTestData& score_data, FittedHypothesis hypothesis, Covariance noise, bool fitted) {
    PredictedModel model{.hypothesis = std::move(hypothesis), .noise = std::move(noise)};
    model.out = held_out(model.hypothesis.model, *score_data.observations, model.noise, score_data.steps,
                         model.hypothesis.fit, fitted);
    score_data.count(model.out.simulations);
    return model;
}

Covariance alike(const FittedHypothesis& model, const Observations& observations) {
    return white_noise_of(observations.measured - model.fit.simulated, observations.blocks,
                          observations.channels.size());
}

AdditionDoubt doubt_of(const PredictionGain& gain, double beyond_doubt) {
    if (gain.removed <= least_removed) {
        return AdditionDoubt::too_small;
    }
    if (gain.low <= beyond_doubt) {
        return AdditionDoubt::may_be_chance;
    }
    if (gain.worst > 1.0 + tolerated_rise + rise_of_removed * gain.removed) {
        return AdditionDoubt::worsens_channel;
    }
    return gain.in_every_fold || gain.low > beyond_one_run ? AdditionDoubt::none : AdditionDoubt::worsens_part;
}

bool is_improvement(const PredictionGain& gain, double beyond_doubt) {
    return doubt_of(gain, beyond_doubt) == AdditionDoubt::none;
}

void search_by_prediction(ScoreTestData& score_data, PredictionSearch& search) {
    // What is added is added to a fit in which every channel counts alike, whatever predicts best.
    PredictedModel now = settled(score_data, search.base);
    FittedGroups done;
    bool is_second = false;  // what was put off for better ones is fitted where these do not predict better, once
    while (search.accepted.size() < most_additions) {
        done.are_all = true;
        std::vector<Improvement> better;
        std::vector<Trial> trials = try_all(score_data, now, done, search);
        for (std::size_t i = 0; i < trials.size(); ++i) {
            Trial& trial = trials[i];
            // The others are tested for what may stand beside the first cause.
            if (!better.empty() && (!search.accepted.empty() || trial.promised < as_good * trials.front().promised)) {
                break;
            }
            const Candidate& added = score_data.candidates[trial.hypothesis.candidates.back()];
            score_data.say({.doing = Work::prediction,
                            .of = name_of(added, *score_data.experiment),
                            .number = i + 1,
                            .count = trials.size()});
            Improvement one{.model = predicted(score_data, std::move(trial.hypothesis), now.noise)};
            one.gain = gain_over(now, one.model, score_data);
            // The best of several is the likelier by chance the less there is left to find.
            const double beyond_doubt = search.accepted.empty() ? 0.0 : least_removed;
            if (one.model.out.ok) {
                take_prediction(one.gain, doubt_of(one.gain, beyond_doubt), one.model.hypothesis, score_data,
                                search.tried);
            }
            if (one.model.out.ok && is_improvement(one.gain, beyond_doubt)) {
                better.push_back(std::move(one));
            }
        }
        if (better.empty() && (done.are_all || std::exchange(is_second, true))) {
            break;
        }
        if (better.empty()) {
            continue;
        }
        std::ranges::sort(better, std::greater{},
                          [](const Improvement& one) { return worth_of(one.gain.removed, one.model.hypothesis); });
        if (search.accepted.empty()) {
            for (std::size_t i = 1; i < better.size(); ++i) {
                // As good as the best as far as these data tell: the difference of the two has an interval around zero.
                if (is_other(score_data, better[i].model.hypothesis, better.front().model.hypothesis) &&
                    gain_over(better[i].model, better.front().model, score_data).low <= 0.0) {
                    search.alternatives.push_back(better[i]);
                }
            }
        }
        now = settled(score_data, better.front().model);
        search.accepted.push_back({.model = now, .gain = better.front().gain});
        score_data.course.additions = std::ssize(search.accepted);
        done.now.clear();
        is_second = false;
    }
    for (int turn = 0; !search.accepted.empty() && turn < most_turns && look_back(score_data, search); ++turn) {
    }
    if (search.accepted.empty()) {
        return;
    }
    search.gain = gain_over(search.base, search.best(), score_data);
    if (!is_improvement(search.gain)) {  // another fit of the case does as well without any cause
        search.accepted.clear();
        search.alternatives.clear();
        search.gain = {};
    }
}

}  // namespace tiretherm::diagnosis
