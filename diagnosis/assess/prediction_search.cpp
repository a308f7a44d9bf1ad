// SPDX-License-Identifier: BSD-3-Clause
// Forward selection by the error on data that were left out, with a look back at what later causes make superfluous.

#include "diagnosis/assess/prediction_search.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "diagnosis/assess/extension.hpp"
#include "diagnosis/noise/white_equivalent.hpp"

namespace tiretherm::diagnosis {

namespace {

/// Causes that are added at most.
constexpr std::size_t most_causes = 4;
/// Candidates that are fitted at each step, and of these how many are tested on data that were left out.
struct Effort {
    std::size_t fitted;
    std::size_t tested;
};
constexpr Effort usual{.fitted = 7, .tested = 3};
constexpr Effort little{.fitted = 4, .tested = 2};
/// Steps of all runs times nodes from which on a simulation is dear.
constexpr std::size_t dear = 30'000;
constexpr std::size_t fewest_nodes = 10;  ///< below, a step costs no less
/// A cause that removes less of the mean square than this is not worth a number.
constexpr double least_removed = 0.03;
/// A channel's rms may rise by this share, by chance.
constexpr double tolerated_rise = 0.02;
/// White noise is taken where it predicts the temperatures better by this share of the rms.
constexpr double better_by = 0.02;
/// A cause is dropped again when the model without it predicts no worse than by this share of the mean square.
constexpr double superfluous = 0.01;
/// Standard deviations from which on a candidate is worth a fit.
constexpr double least_score = 2.0;

/// Mean over the channels of the logarithm of the mean square: half of its differences is the relative change of the rms.
double log_error(const PredictedModel& model, const Observations& observations) {
    double sum = 0.0;
    int counted = 0;
    for (std::size_t c = 0; c < observations.channels.size(); ++c) {
        const double square = model.out.mean_square(observations, c);
        if (square > 0.0) {
            sum += std::log(square);
            ++counted;
        }
    }
    return counted > 0 ? sum / counted : 0.0;
}

PredictedModel predicted(ScoreTestData& score_data, FittedHypothesis hypothesis, Covariance noise, bool fitted = true) {
    PredictedModel model{.hypothesis = std::move(hypothesis), .noise = std::move(noise)};
    model.out = held_out(model.hypothesis.model, *score_data.observations, model.noise, score_data.steps,
                         model.hypothesis.fit, fitted);
    score_data.count(model.out.simulations);
    return model;
}

/// What no model can remove of each channel's error: its sensor's noise, as far as it is stated. @returns [n_noises]
std::vector<double> floor_of(const Observations& observations) { return observations.stated; }

PredictionGain gain_over(const PredictedModel& before, const PredictedModel& after, const ScoreTestData& score_data) {
    return compare_predictions(before.out, after.out, *score_data.observations, score_data.noise.channels,
                               floor_of(*score_data.observations));
}

bool is_better(const PredictionGain& gain) {
    return gain.removed > least_removed && gain.low > 0.0 && gain.worst <= 1.0 + tolerated_rise;
}

Effort effort_of(const ScoreTestData& score_data) {
    std::size_t steps = 0;
    for (const std::vector<double>& run : score_data.steps) {
        steps += run.size();
    }
    const auto nodes = static_cast<std::size_t>(score_data.experiment->runs.front().problem.mesh.n_nodes);
    return steps * std::max(nodes, fewest_nodes) < dear ? usual : little;
}

/// Candidates that the linearised model promises most of beside what is there, the best first: by scores with the noise
/// of the fit, and by scores with correlated noise, in which quick effects such as those of timing stand out.
std::vector<std::size_t> promising(ScoreTestData& score_data, const PredictedModel& now) {
    const auto fits_in = [&](const Candidate& candidate) {
        return std::ranges::all_of(now.hypothesis.candidates, [&](std::size_t k) {
            return can_stand_beside(candidate, score_data.candidates[k]);
        });
    };
    const Covariance slow = noise_beside(score_data, now.hypothesis);
    const Covariance even = white_equivalent(slow, score_data.observations->blocks);
    std::vector<std::vector<std::pair<double, std::size_t>>> rankings;
    for (const Covariance* noise : {&slow, &even}) {
        const Scores scores = scores_beside(score_data, now.hypothesis, *noise);
        std::vector<std::pair<double, std::size_t>>& ranking = rankings.emplace_back();
        for (std::size_t k = 0; k < score_data.candidates.size(); ++k) {
            const auto i = static_cast<Eigen::Index>(k);
            const double z = admitted(scores.z[i], score_data.sign[i]);
            if (z > least_score && fits_in(score_data.candidates[k])) {
                ranking.emplace_back(z, k);
            }
        }
        std::ranges::sort(ranking, std::greater{});
    }
    const std::size_t most_fitted = effort_of(score_data).fitted;
    std::vector<std::size_t> chosen;
    std::set<std::size_t> taken;
    for (std::size_t place = 0; chosen.size() < most_fitted; ++place) {
        bool any = false;
        for (const auto& ranking : rankings) {
            if (place < ranking.size() && chosen.size() < most_fitted) {
                any = true;
                const std::size_t k = ranking[place].second;
                if (taken.insert(score_data.candidates[k].cause).second) {
                    chosen.push_back(k);
                }
            } else if (place < ranking.size()) {
                any = true;
            }
        }
        if (!any) {
            break;
        }
    }
    return chosen;
}

/// One more cause, fitted.
struct Trial {
    FittedHypothesis hypothesis;
    double gain = 0.0;  ///< predicted to first order: share of the mean square that is removed
};

/// Of the promising candidates those that remove most, fitted; implausible fits are set aside.
std::vector<Trial> try_all(ScoreTestData& score_data, const PredictedModel& now, PredictionSearch& search) {
    std::vector<Trial> trials;
    const std::vector<std::size_t> chosen = promising(score_data, now);
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        const std::size_t k = chosen[i];
        const Candidate& candidate = score_data.candidates[k];
        score_data.say({.doing = Work::candidate,
                        .of = name_of(candidate, *score_data.experiment),
                        .number = i + 1,
                        .count = chosen.size()});
        Trial trial{.hypothesis = extended(score_data, now.hypothesis, k, now.noise)};
        if (!trial.hypothesis.sound) {
            continue;
        }
        if (!trial.hypothesis.admissible) {
            const Remark remark = remark::fits_at_end_of_range(
                name_of(candidate, *score_data.experiment), std::string(candidate.number().key),
                trial.hypothesis.fit.values[trial.hypothesis.number_of(trial.hypothesis.candidates.size() - 1)]);
            if (std::ranges::find(search.remarks, remark) == search.remarks.end()) {
                search.remarks.push_back(remark);
            }
            continue;
        }
        trial.gain = linear_gain(score_data, now.hypothesis, trial.hypothesis);
        trials.push_back(std::move(trial));
    }
    std::ranges::sort(trials, std::greater{}, &Trial::gain);
    if (const std::size_t most_tested = effort_of(score_data).tested; trials.size() > most_tested) {
        trials.resize(most_tested);
    }
    return trials;
}

/// The model without one of its causes, as an improvement over the base.
std::optional<PredictedModel> without(ScoreTestData& score_data, const PredictedModel& model, std::size_t cause) {
    FittedHypothesis less = reduced(score_data, model.hypothesis, cause, model.noise);
    if (!less.sound) {
        return std::nullopt;
    }
    return predicted(score_data, std::move(less), model.noise);
}

/// Drops causes that later ones have made superfluous.
void look_back(ScoreTestData& score_data, PredictionSearch& search) {
    for (bool dropped = true; dropped && search.accepted.size() > 1;) {
        dropped = false;
        const PredictedModel now = search.best();
        for (std::size_t cause = 0; cause + 1 < now.hypothesis.candidates.size(); ++cause) {
            score_data.say({.doing = Work::looking_back});
            std::optional<PredictedModel> less = without(score_data, now, cause);
            if (!less) {
                continue;
            }
            const PredictionGain lost = gain_over(*less, now, score_data);
            if (lost.removed < superfluous || lost.low < -superfluous) {
                search.accepted.back() = {.model = std::move(*less), .gain = {}};
                search.accepted.back().gain = gain_over(search.base, search.accepted.back().model, score_data);
                search.accepted.erase(search.accepted.begin() + static_cast<std::ptrdiff_t>(search.accepted.size()) -
                                      2);
                dropped = true;
                break;
            }
        }
    }
}

/// White noise in the proportions of the data sheet, as large as it takes to leave no more than noise in the mean; nothing
/// where a sensor has none, or where the fit's own noise has about these proportions. Noise that is estimated beside a wrong
/// model is large in the channels that the fit has given up: they are never looked at again.
std::optional<Covariance> in_proportion(const Covariance& even, const Observations& observations) {
    constexpr double about = 4.0;
    double least = 1e300;
    double most = 0.0;
    double mean = 0.0;
    const auto n = static_cast<double>(observations.channels.size());
    for (std::size_t c = 0; c < observations.channels.size(); ++c) {
        if (!(observations.stated[c] > 0.0)) {
            return std::nullopt;
        }
        const double times = even.channels[c].sigma / observations.stated[c];
        least = std::min(least, times);
        most = std::max(most, times);
        mean += std::log(times) / n;
    }
    if (!(most > about * least)) {
        return std::nullopt;
    }
    Covariance same = even;
    for (std::size_t c = 0; c < observations.channels.size(); ++c) {
        same.channels[c].sigma = std::exp(mean) * observations.stated[c];
    }
    return same;
}

}  // namespace

PredictionSearch choose_base(ScoreTestData& score_data) {
    PredictionSearch search;
    const Observations& observations = *score_data.observations;
    FittedHypothesis slow;
    slow.model = *score_data.experiment;
    slow.fit = score_data.base;
    slow.sound = true;

    PredictedModel correlated = predicted(score_data, slow, score_data.noise);
    correlated.base = BaseModel::correlated_noise;
    const Covariance even = white_equivalent(score_data.noise, observations.blocks);
    std::optional<PredictedModel> white;
    const auto try_white = [&](const Covariance& noise) {
        FittedHypothesis flat = refitted(score_data, slow, noise);
        if (!flat.sound) {
            return;
        }
        PredictedModel model = predicted(score_data, std::move(flat), noise);
        model.base = BaseModel::white_noise;
        if (!white || (model.out.ok && log_error(model, observations) < log_error(*white, observations))) {
            white = std::move(model);
        }
    };
    try_white(even);
    if (const std::optional<Covariance> same = in_proportion(even, observations)) {
        try_white(*same);
    }
    const Covariance its_noise = white ? white->noise : even;
    FittedHypothesis plain = as_it_stands(score_data, its_noise);
    PredictedModel stands = predicted(score_data, std::move(plain), its_noise, false);
    stands.base = BaseModel::as_it_stands;

    const double of_correlated = log_error(correlated, observations);
    const double by_white = white && white->out.ok ? log_error(*white, observations) : 1e30;
    const double of_case = stands.out.ok ? log_error(stands, observations) : 1e30;
    search.white = 0.5 * (of_correlated - by_white) > better_by;
    search.base = search.white ? std::move(*white) : std::move(correlated);
    if (0.5 * ((search.white ? by_white : of_correlated) - of_case) > better_by) {
        search.base = std::move(stands);
        search.white = true;
    }
    return search;
}

void search_by_prediction(ScoreTestData& score_data, PredictionSearch& search) {
    // What is added is added to a fit, with the noise that predicts better; where the case as it stands does best, too.
    PredictedModel start = search.base;
    if (search.white) {
        FittedHypothesis flat = refitted(score_data, start.hypothesis, start.noise);
        if (flat.sound) {
            start = predicted(score_data, std::move(flat), start.noise);
        }
    }
    while (search.accepted.size() < most_causes) {
        const PredictedModel& now = search.accepted.empty() ? start : search.best();
        std::vector<Improvement> better;
        std::vector<Trial> trials = try_all(score_data, now, search);
        for (std::size_t i = 0; i < trials.size(); ++i) {
            Trial& trial = trials[i];
            const Candidate& added = score_data.candidates[trial.hypothesis.candidates.back()];
            score_data.say({.doing = Work::prediction,
                            .of = name_of(added, *score_data.experiment),
                            .number = i + 1,
                            .count = trials.size()});
            Improvement one{.model = predicted(score_data, std::move(trial.hypothesis), now.noise)};
            one.gain = gain_over(search.accepted.empty() ? search.base : now, one.model, score_data);
            if (one.model.out.ok && is_better(one.gain)) {
                better.push_back(std::move(one));
            } else if (one.model.out.ok) {
                search.largest_gain = std::max(search.largest_gain, one.gain.removed);
            }
        }
        if (better.empty()) {
            break;
        }
        std::ranges::sort(better, std::greater{}, [](const Improvement& one) { return one.gain.removed; });
        if (search.accepted.empty()) {
            for (std::size_t i = 1; i < better.size(); ++i) {
                // As good as the best as far as these data tell: the difference of the two has an interval around zero.
                if (gain_over(better[i].model, better.front().model, score_data).low <= 0.0) {
                    search.alternatives.push_back(better[i]);
                }
            }
        }
        search.accepted.push_back(std::move(better.front()));
    }
    look_back(score_data, search);
    search.gain = search.accepted.empty() ? PredictionGain{} : gain_over(search.base, search.best(), score_data);
}

}  // namespace tiretherm::diagnosis
