// SPDX-License-Identifier: BSD-3-Clause
// What a search by prediction keeps of the additions that it fitted, whatever came of them.
#pragma once

#include <optional>
#include <vector>

#include "diagnosis/assess/prediction_search.hpp"

namespace tiretherm::diagnosis {

/// An addition that was fitted and is not tested yet.
/// @param before the model that it was added to  @param promised share of the mean square, to first order about the fit
[[nodiscard]] TriedModel trial_of(const ScoreTestData& score_data, const FittedHypothesis& with,
                                  const FittedHypothesis& before, double promised);

/// Adds to the trial of a model what it did on data that were left out.
void take_prediction(const PredictionGain& gain, AdditionDoubt doubt, const FittedHypothesis& model,
                     const ScoreTestData& score_data, std::vector<TriedModel>& tried);

/// The channel that gains the largest share; nothing where none was predicted.
[[nodiscard]] std::optional<ChannelChange> largest_change(const PredictionGain& gain, const Observations& observations);

/// Each addition once, as it was tried last: those first that remove most.
[[nodiscard]] std::vector<TriedModel> ranked(std::vector<TriedModel> tried);

}  // namespace tiretherm::diagnosis
