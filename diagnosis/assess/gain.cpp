// SPDX-License-Identifier: BSD-3-Clause
// Cross-validation of the extended model over held-out runs or blocks: share of the error removed with a block-bootstrap
// interval (Kuensch, Ann. Statist. 17 (1989) 1217), and the verdict that the prediction bears out.

#include <algorithm>
#include <cmath>
#include <limits>

#include "diagnosis/assess/diagnosis_state.hpp"
#include "diagnosis/assess/extension.hpp"

namespace tiretherm::diagnosis {

namespace {

/// Odds from which on a prediction confirms a cause.
const double confirming = std::log(100.0);
/// What a confirmed cause removes at least of the error that a model could remove.
constexpr double least_confirmed = 0.1;

double rms(const HeldOutErrors& out, const Observations& observations, std::size_t noise) {
    return std::sqrt(out.mean_square(observations, noise));
}

/// The same with correlated noise taken out, for effects that are small beside slow noise.
HeldOutErrors whitened(HeldOutErrors out, const Observations& observations, const Covariance& noise) {
    RowIndices rows;
    for (Eigen::Index i = 0; i < out.left.size(); ++i) {
        if (std::isfinite(out.left[i])) {
            rows.push_back(i);
        }
    }
    const Observations some = subset(observations, rows);
    Eigen::MatrixXd left = out.left(rows);
    whiten(some.blocks, subset(noise, rows), left);
    out.left(rows) = left.col(0);
    return out;
}

/// The base and the extended model predicted with the noise of the score tests.
struct Predictions {
    HeldOutErrors before;
    HeldOutErrors after;
};

Predictions predict_both(ScoreTestData& score_data, const FittedHypothesis& best) {
    Predictions both;
    both.before =
        held_out(*score_data.experiment, *score_data.observations, score_data.noise, score_data.steps, score_data.base);
    both.after = held_out(best.model, *score_data.observations, score_data.noise, score_data.steps, best.fit);
    score_data.count(both.before.simulations + both.after.simulations);
    return both;
}

/// What the sensors' noise is of each channel: as stated, and no more than the extended model leaves. SI
std::vector<double> noise_floor(const Observations& observations, const Eigen::VectorXd& extended) {
    const HeldOutErrors all{.left = observations.measured - extended};
    std::vector<double> floor;
    for (std::size_t c = 0; c < observations.channels.size(); ++c) {
        const double left = rms(all, observations, c);
        floor.push_back(observations.stated[c] > 0.0 ? std::min(left, observations.stated[c]) : left);
    }
    return floor;
}

/// Whether something drifts in the only recording: whether it goes on in the next, begins anew or is gone, that does not tell.
bool drifts_in_the_only_run(const DiagnosisState& found, const FittedHypothesis& best) {
    return found.score_data.observations->n_recordings() == 1 &&
           std::ranges::any_of(best.candidates,
                               [&](std::size_t k) { return is_drift(found.score_data.candidates[k].number().unit); });
}

}  // namespace

void take_gain(const PredictionGain& gain, Gain& into) {
    // Noise cannot be removed: what there is to remove is the rest, and of a model that is nearly right a twentieth at least.
    const double removable = std::max(0.05, gain.removable);
    into.measured = true;
    into.removed = gain.removed;
    into.removed_low = gain.low;
    into.removed_high = gain.high;
    into.removable_removed = gain.removed / removable;
    into.low = gain.low / removable;
    into.high = gain.high / removable;
    into.log_e = gain.log_odds;
}

bool is_confirmed(const PredictionGain& gain, const Gain& taken) {
    return taken.log_e >= confirming && gain.in_every_fold && gain.worst <= 1.0 + 0.02 && taken.low > least_confirmed &&
           gain.least_explained >= greater_part;
}

void measure_gain(DiagnosisState& found, Diagnosis& into) {
    ScoreTestData& score_data = found.score_data;
    const Observations& observations = *score_data.observations;
    const std::size_t n_noises = observations.channels.size();
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    const FittedHypothesis* best = found.best();
    Predictions both;
    const bool predicted = best != nullptr && n_noises > 0;
    if (predicted) {
        if (found.search) {
            both = {.before = found.search->base.out, .after = found.search->best().out};
            into.gain.over = found.search->base.base;
            into.gain.over_mesh = found.search->base.mesh;
        } else {
            both = predict_both(score_data, *best);
        }
        found.of_folds = both.after.values;
        into.gain.within_run = observations.n_recordings() == 1;
        if (both.before.ok && both.after.ok) {
            const std::vector<double> floor = noise_floor(observations, into.extended);
            const PredictionGain plain =
                compare_predictions(both.before, both.after, observations, score_data.noise.channels, floor);
            take_gain(plain, into.gain);
            bool proven = plain.low > 0.0;
            if (!found.search) {
                // Small effects beside slow noise: the whitened errors see them best.
                std::vector<Noise> unit(n_noises, Noise{.sigma = 1.0});
                const PredictionGain sharp =
                    compare_predictions(whitened(both.before, observations, score_data.noise),
                                        whitened(both.after, observations, score_data.noise), observations, unit,
                                        std::vector<double>(n_noises, 0.0));
                proven = proven || (sharp.low > 0.0 && plain.removed > 0.0);
                into.gain.log_e = plain.removed > 0.0 ? sharp.log_odds : std::min(0.0, sharp.log_odds);
            }
            into.gain.confirmed = proven && is_confirmed(plain, into.gain) && !drifts_in_the_only_run(found, *best);
            if (!proven && plain.removed <= 0.0) {
                into.extended_model.reset();  // it would predict no better than the case
            }
            if (!proven && (found.verdict == Verdict::named || found.verdict == Verdict::confounded)) {
                into.verdict = found.verdict = Verdict::partial;
            }
        } else if (found.verdict == Verdict::named) {
            into.verdict = found.verdict = Verdict::partial;
        }
    }
    for (std::size_t c = 0; c < n_noises; ++c) {
        const auto fitted = [&](const Eigen::VectorXd& simulated) {
            HeldOutErrors all{.left = observations.measured - simulated};
            return rms(all, observations, c);
        };
        into.channels.push_back({.channel = observations.channels[c],
                                 .rmse_before = fitted(into.base),
                                 .rmse_after = fitted(into.extended),
                                 .heldout_before = predicted ? rms(both.before, observations, c) : none,
                                 .heldout_after = predicted ? rms(both.after, observations, c) : none});
    }
}

}  // namespace tiretherm::diagnosis
