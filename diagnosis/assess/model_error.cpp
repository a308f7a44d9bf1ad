// SPDX-License-Identifier: BSD-3-Clause
// Errors of the model beside any cause: whether there are any, how large they are, and what they do to the intervals.

#include <algorithm>
#include <cmath>
#include <limits>

#include "diagnosis/assess/diagnosis_state.hpp"
#include "diagnosis/fit/block_deviations.hpp"
#include "diagnosis/fit/linearised_model.hpp"
#include "diagnosis/noise/white_equivalent.hpp"

namespace tiretherm::diagnosis {

namespace {

/// Samples from which on the noise of a channel is known well enough.
constexpr double many = 50.0;
/// An rms beyond the noise that is smaller than this share of it is none.
constexpr double least_error = 0.5;
/// Blocks widen an interval by this factor at most where nothing else speaks of an error of the model: where few of them tell
/// what a number is, their scatter is uncertain itself.
constexpr double widest_undoubted = 2.0;
/// Of the longest run: noise of a longer correlation may be an error of the model. A third of what noise is allowed to have.
constexpr double short_correlation = 0.1 / 3.0;

std::vector<double> samples_of(const Observations& observations) {
    std::vector<double> samples(observations.channels.size(), 0.0);
    for (const NoiseBlock& block : observations.blocks) {
        if (block.channel >= 0) {
            samples[static_cast<std::size_t>(block.channel)] += static_cast<double>(block.rows());
        }
    }
    return samples;
}

/// s
double longest_run(const Observations& observations) {
    double longest = 0.0;
    for (const std::vector<double>& times : observations.times) {
        longest = std::max(longest, times.empty() ? 0.0 : times.back() - times.front());
    }
    return longest;
}

/// Standard deviation of an estimated sigma, over it: of n samples 1 / sqrt(2 n), where correlation leaves fewer of their squares,
/// whose correlations are those of the samples squared (Bayley and Hammersley 1946).
double relative_deviation(const Noise& noise, const Observations& observations, std::size_t c) {
    const double interval = median_interval(observations.blocks, static_cast<int>(c));
    double times = 1.0;
    if (noise.correlation_time > 0.0 && interval > 0.0) {
        const double share = 1.0 - noise.white_share;
        const double square = std::exp(-2.0 * interval / noise.correlation_time);
        times += 2.0 * share * share * square / (1.0 - square);
    }
    return std::sqrt(times / (2.0 * samples_of(observations)[c]));
}

/// Fits that stand beside the best one: those of the other members of the set, which the data cannot tell from it, and where they
/// leave the model in doubt those of what else was tried, and of the case with nothing added. What a free number is depends on which
/// of them is right.
/// @param error the model has an error that is not named
std::vector<const Refit*> other_fits(const DiagnosisState& state, bool error) {
    std::vector<const Refit*> others;
    for (std::size_t i = 1; i < state.set.size(); ++i) {
        others.push_back(&state.set[i]->fit);
    }
    const bool doubtful = error || state.something_left || state.verdict == Verdict::partial;
    if (!doubtful) {
        return others;
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

/// Numbers without each half of each recording, in the linearised model. Two recordings leave one degree of freedom, of which
/// Student's t is 12.7: their halves leave three.
std::vector<Eigen::VectorXd> values_without_halves(const Refit& fit, const Observations& observations) {
    const LinearisedModel linear = linearise(fit, observations);
    const std::vector<std::size_t> half_of = blocks_of_rows(observations, std::numeric_limits<double>::infinity(), 2);
    std::vector<Eigen::VectorXd> values;
    for (std::size_t half = 0; half < 2 * observations.n_recordings(); ++half) {
        RowIndices rest;
        for (std::size_t row = 0; row < half_of.size(); ++row) {
            if (half_of[row] != half) {
                rest.push_back(static_cast<Eigen::Index>(row));
            }
        }
        values.push_back(fit.values + solve(linear, rest).cwiseProduct(fit.scale));
    }
    return values;
}

}  // namespace

bool is_plainly_noise(const ScoreTestData& score_data, std::size_t c) {
    const Observations& observations = *score_data.observations;
    const Noise& noise = score_data.noise.channels[c];
    const HeldOutErrors all{.left = observations.measured - score_data.base.simulated};
    const double left = std::sqrt(all.mean_square(observations, c));
    return samples_of(observations)[c] >= many && left < as_large * noise.sigma &&
           noise.correlation_time < short_correlation * longest_run(observations);
}

std::optional<Remark> noise_above_sheet(const ScoreTestData& score_data) {
    const Observations& observations = *score_data.observations;
    const solver::Problem& problem = score_data.experiment->runs.front().problem;
    Remarks channels;
    for (std::size_t c = 0; c < observations.channels.size(); ++c) {
        const Noise& noise = score_data.noise.channels[c];
        const double stated = observations.stated[c];
        if (stated > 0.0 && noise.sigma > swollen * stated && is_plainly_noise(score_data, c)) {
            const std::string unit(solver::unit_of(problem.channels[observations.channels[c]].quantity));
            const double ratio = noise.sigma / stated;
            const double half = 1.96 * ratio * relative_deviation(noise, observations, c);
            channels.push_back(remark::noise_of_channel(observations.names[c], noise.sigma, unit, ratio, ratio - half,
                                                        ratio + half, stated));
        }
    }
    return channels.empty() ? std::nullopt : std::optional(remark::noise_alone(std::move(channels)));
}

bool has_model_error(const ScoreTestData& score_data) {
    const Observations& observations = *score_data.observations;
    const std::vector<double> samples = samples_of(observations);
    for (std::size_t c = 0; c < observations.channels.size(); ++c) {
        const Noise& noise = score_data.noise.channels[c];
        if (samples[c] < many) {
            continue;
        }
        const double stated = observations.stated[c];
        const bool as_slow_as_allowed = noise.correlation_time > 0.0 &&
                                        noise.correlation_time > 0.99 * 0.1 * longest_run(observations) &&
                                        noise.white_share < 0.5;
        if (stated > 0.0 ? noise.sigma > swollen * stated : as_slow_as_allowed) {
            return true;
        }
    }
    return false;
}

bool is_doubted(const DiagnosisState& state) {
    return state.search || state.something_left || has_model_error(state.score_data);
}

void describe_model_error(const DiagnosisState& state, Diagnosis& into) {
    const ScoreTestData& score_data = state.score_data;
    const Observations& observations = *score_data.observations;
    const Eigen::VectorXd left = observations.measured - into.extended;
    const std::vector<int> noise_of = noise_of_rows(observations);
    std::vector<Noise> slow = score_data.noise.channels;
    // The noise beside the span of all candidates says nothing of an error that one of them could explain and none does.
    const bool doubted = is_doubted(state);
    for (std::size_t c = 0; c < observations.channels.size(); ++c) {
        HeldOutErrors all{.left = left};
        const double square = all.mean_square(observations, c);
        const double stated = observations.stated[c];
        // Where no data sheet says it, what is new in every sample is the sensor's.
        const Noise& noise = score_data.noise.channels[c];
        const bool is_noise_alone = state.verdict == Verdict::consistent && is_plainly_noise(score_data, c);
        const double floor = is_noise_alone ? std::max(stated, noise.sigma)
                             : stated > 0.0 ? stated
                                            : noise.sigma * std::sqrt(noise.white_share);
        const double beyond = std::sqrt(std::max(0.0, square - floor * floor));
        if (beyond > least_error * floor && std::isfinite(beyond) && doubted) {
            const double seconds = time_scale(left, observations.blocks, static_cast<int>(c));
            into.model_error.push_back({.channel = observations.channels[c],
                                        .size = beyond,
                                        .time_scale = seconds,
                                        .noise = stated > 0.0 ? stated : noise.sigma});
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
    if (doubted && observations.n_recordings() == 2) {
        jackknife = jackknife_half_widths(values_without_halves(fit, observations));
    } else if (doubted) {
        jackknife = jackknife_half_widths(state.search ? state.search->best().out.values : state.of_folds);
    }
    std::vector<double> halves;
    for (Eigen::Index j = 0; j < fit.values.size(); ++j) {
        double blocks = deviations.wide * deviations.deviation[j];
        if (!doubted) {
            blocks = std::min(blocks, widest_undoubted * noise_alone[j]);
        }
        halves.push_back(j < jackknife.size() ? std::max(blocks, jackknife[j]) : blocks);
    }
    const std::vector<const Refit*> others = other_fits(state, !into.model_error.empty());
    for (std::size_t j = 0; j < score_data.experiment->parameters.size(); ++j) {
        const auto i = static_cast<Eigen::Index>(j);
        const double half = halves[j];
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
    // The sizes of the causes carry the same errors.
    std::size_t members = best != nullptr ? best->candidates.size() : 0;
    for (Cause& cause : into.causes) {
        if (cause.kind == CauseKind::effect && members > 0) {
            cause.widen(halves);
            --members;
        }
    }
}

}  // namespace tiretherm::diagnosis
