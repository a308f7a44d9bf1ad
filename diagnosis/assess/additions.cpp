// SPDX-License-Identifier: BSD-3-Clause
// Groups candidates by what they may be wrong with together, and ranks them by linear predictions.

#include "diagnosis/assess/additions.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
#include <set>

namespace tiretherm::diagnosis {

namespace {

/// A clock that is wrong by a little in each second is rare beside one that is late: it is tried alone.
bool is_clock_rate(const Candidate& candidate) {
    const physics::SensorModel* sensor = candidate.effect->sensor_model();
    return sensor != nullptr && sensor->clock_rate != nullptr;
}

bool is_timing(const Candidate& candidate) {
    const physics::SensorModel* sensor = candidate.effect->sensor_model();
    const physics::InputCorrection* input = candidate.effect->input_correction();
    return (sensor != nullptr && (sensor->lag != nullptr || sensor->delay != nullptr)) || is_clock_rate(candidate) ||
           (input != nullptr && input->delay != nullptr);
}

/// One by one and in groups, in the order of the catalogue.
std::vector<CauseGroup> groups_of(const ScoreTestData& score_data, const FittedHypothesis& now) {
    std::vector<CauseGroup> all;
    std::vector<CauseGroup> groups;
    for (std::size_t k = 0; k < score_data.candidates.size(); ++k) {
        const Candidate& candidate = score_data.candidates[k];
        const bool fits_in = std::ranges::all_of(now.candidates, [&](std::size_t other) {
            return can_stand_beside(candidate, score_data.candidates[other]);
        });
        if (!fits_in) {
            continue;
        }
        const bool timing = is_timing(candidate);
        if (!timing) {
            all.push_back({.candidates = {k}});
        }
        if (!timing && candidate.effect->sensor_model() == nullptr) {
            continue;
        }
        const auto joins = [&](const CauseGroup& one) {
            const Candidate& first = score_data.candidates[one.candidates.front()];
            return one.is_timing == timing && first.channels == candidate.channels &&
                   is_clock_rate(first) == is_clock_rate(candidate) &&
                   std::ranges::all_of(one.candidates, [&](std::size_t other) {
                       return can_stand_beside(candidate, score_data.candidates[other]);
                   });
        };
        if (const auto group = std::ranges::find_if(groups, joins); group != groups.end()) {
            group->candidates.push_back(k);
        } else {
            groups.push_back({.candidates = {k}, .is_timing = timing});
        }
    }
    std::ranges::copy_if(groups, std::back_inserter(all),
                         [](const CauseGroup& one) { return one.is_timing || one.candidates.size() > 1; });
    return all;
}

}  // namespace

LinearPrediction linear_beside(const ScoreTestData& score_data, const FittedHypothesis& now, const Covariance& noise,
                               bool with_candidates) {
    const Observations& observations = *score_data.observations;
    const auto white = [&](Eigen::MatrixXd columns) {
        whiten(observations.blocks, noise, columns);
        return columns;
    };
    LinearisedModel model = linearise(now.fit, observations);
    model.slopes = white(model.raw);
    model.residual = white(model.left).col(0);
    for (Eigen::Index j = 0; j < model.precision.size(); ++j) {
        if (now.fit.at_bound[static_cast<std::size_t>(j)]) {
            model.precision[j] = 1e30;
            model.known[j] = 0.0;
        }
    }
    Signatures beside{
        .raw = Eigen::MatrixXd(model.left.size(), 0), .white = Eigen::MatrixXd(model.left.size(), 0), .bounds = {}};
    for (std::size_t j = 0; j < now.model.parameters.size(); ++j) {
        const auto i = static_cast<Eigen::Index>(j);
        beside.bounds_of_numbers.emplace_back((now.model.parameters[j].low - now.fit.values[i]) / now.fit.scale[i],
                                              (now.model.parameters[j].high - now.fit.values[i]) / now.fit.scale[i]);
    }
    if (with_candidates) {
        beside.raw = score_data.signatures;
        beside.white = white(beside.raw);
        for (const Candidate& candidate : score_data.candidates) {
            const auto [low, high] = plausible_bounds(candidate);
            beside.bounds.emplace_back(low - candidate.absent, high - candidate.absent);
        }
    }
    const std::vector<Fold> folds = folds_of(observations);
    std::vector<std::vector<bool>> own;
    for (const Fold& fold : folds) {
        std::vector<bool>& of_fold = own.emplace_back();
        for (const solver::FreeParameter& parameter : now.model.parameters) {
            of_fold.push_back(fold.alone_has(parameter));
        }
    }
    return {model, beside, folds, own, noise_of_rows(observations), observations.channels.size()};
}

std::vector<CauseGroup> additions_to(const ScoreTestData& score_data, const FittedHypothesis& now,
                                     const LinearPrediction& linear) {
    const LinearPrediction::MeanSquares before = linear.with({});
    std::vector<CauseGroup> all = groups_of(score_data, now);
    for (CauseGroup& one : all) {
        const std::vector<Eigen::Index> columns{one.candidates.begin(), one.candidates.end()};
        one.promised = share_removed(before, linear.with(columns));
        const std::vector<double> amplitudes = linear.amplitudes(columns);
        for (std::size_t i = 0; i < amplitudes.size(); ++i) {
            const Candidate& candidate = score_data.candidates[one.candidates[i]];
            const auto [low, high] = plausible_bounds(candidate);
            const double value = candidate.absent + amplitudes[i];
            one.at_end = one.at_end || (amplitudes[i] != 0.0 && (value <= low || value >= high));
        }
    }
    std::ranges::stable_sort(all, std::greater{}, &CauseGroup::promised);
    std::stable_partition(all.begin(), all.end(), [](const CauseGroup& one) { return !one.at_end; });
    std::set<std::vector<std::size_t>> taken;
    std::erase_if(all, [&](const CauseGroup& one) {
        std::vector<std::size_t> causes;
        for (const std::size_t k : one.candidates) {
            causes.push_back(score_data.candidates[k].cause);
        }
        return !taken.insert(causes).second;
    });
    return all;
}

double worth_of(double removed, const FittedHypothesis& one) {
    return removed - superfluous * static_cast<double>(one.candidates.size());
}

bool is_other(const ScoreTestData& score_data, const FittedHypothesis& one, const FittedHypothesis& best) {
    return std::ranges::any_of(one.candidates, [&](std::size_t k) {
        return std::ranges::all_of(best.candidates, [&](std::size_t other) {
            return can_stand_beside(score_data.candidates[k], score_data.candidates[other]);
        });
    });
}

}  // namespace tiretherm::diagnosis
