// SPDX-License-Identifier: BSD-3-Clause
// Describes additions by their causes and sizes, and ranks them by what they remove of the error on data that were left out.

#include "diagnosis/assess/tried_additions.hpp"

#include <algorithm>
#include <limits>

#include "diagnosis/assess/cause_description.hpp"
#include "diagnosis/fit/block_deviations.hpp"

namespace tiretherm::diagnosis {

namespace {

bool are_same(const TriedModel& one, const TriedModel& other) {
    return std::ranges::equal(one.addition.causes, other.addition.causes, [](const Cause& a, const Cause& b) {
        return a.id == b.id && a.channel == b.channel && a.place == b.place;
    });
}

}  // namespace

TriedModel trial_of(const ScoreTestData& score_data, const FittedHypothesis& with, const FittedHypothesis& before,
                    double promised) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    const Observations& observations = *score_data.observations;
    TriedModel trial{.addition = {.causes = {},
                                  .beside = before.candidates.size(),
                                  .doubt = with.admissible ? AdditionDoubt::not_tested : AdditionDoubt::end_of_range,
                                  .removed = promised,
                                  .low = none,
                                  .high = none},
                     .model = {.candidates = with.candidates, .values = {}}};
    const BlockDeviations deviations =
        block_deviations(with.fit, observations, length_of_blocks(observations, score_data.noise.channels));
    std::vector<double> halves;
    for (const double deviation : deviations.deviation) {
        halves.push_back(deviations.wide * deviation);
    }
    for (std::size_t i = 0; i < with.candidates.size(); ++i) {
        trial.model.values.push_back(with.fit.values[with.number_of(i)]);
        if (i >= before.candidates.size()) {
            trial.addition.causes.push_back(describe_cause(score_data, with, i));
            Cause& cause = trial.addition.causes.back();
            cause.widen(halves);
            const Candidate& candidate = score_data.candidates[with.candidates[i]];
            cause.numbers.front().low = std::max(cause.numbers.front().low, candidate.low);
            cause.numbers.front().high = std::min(cause.numbers.front().high, candidate.high);
        }
    }
    return trial;
}

void take_prediction(const PredictionGain& gain, AdditionDoubt doubt, const FittedHypothesis& model,
                     const ScoreTestData& score_data, std::vector<TriedModel>& tried) {
    const auto is_of_it = [&](const TriedModel& one) { return one.model.candidates == model.candidates; };
    if (const auto trial = std::find_if(tried.rbegin(), tried.rend(), is_of_it); trial != tried.rend()) {
        trial->addition.doubt = doubt;
        trial->addition.removed = gain.removed;
        trial->addition.low = gain.low;
        trial->addition.high = gain.high;
        trial->addition.change = largest_change(gain, *score_data.observations);
    }
}

std::optional<ChannelChange> largest_change(const PredictionGain& gain, const Observations& observations) {
    std::optional<ChannelChange> largest;
    for (std::size_t c = 0; c < gain.channels.size(); ++c) {
        const PredictionGain::Fall& fall = gain.channels[c];
        const bool is_larger = !largest || fall.after / fall.before < largest->after / largest->before;
        if (fall.before > 0.0 && is_larger) {
            largest = ChannelChange{.channel = observations.channels[c],
                                    .before = fall.before,
                                    .after = fall.after,
                                    .low = fall.low,
                                    .high = fall.high};
        }
    }
    return largest;
}

std::vector<TriedModel> ranked(std::vector<TriedModel> tried) {
    std::vector<TriedModel> once;
    std::ranges::reverse(tried);  // the latest of several alike counts
    for (TriedModel& one : tried) {
        if (std::ranges::none_of(once, [&](const TriedModel& other) { return are_same(one, other); })) {
            once.push_back(std::move(one));
        }
    }
    std::ranges::stable_sort(once, std::greater{}, [](const TriedModel& one) { return one.addition.removed; });
    return once;
}

}  // namespace tiretherm::diagnosis
