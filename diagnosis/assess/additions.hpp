// SPDX-License-Identifier: BSD-3-Clause
// What may be added to a model in a search by prediction, and what the linearised model promises of it.
#pragma once

#include <vector>

#include "diagnosis/assess/fitted_hypothesis.hpp"
#include "diagnosis/assess/linear_prediction.hpp"
#include "diagnosis/detect/work_ahead.hpp"

namespace tiretherm::diagnosis {

/// Causes that are added together.
struct CauseGroup {
    std::vector<std::size_t> candidates;  ///< indices into ScoreTestData::candidates
    double promised = 0.0;                ///< share of the mean square that the linearised model predicts to be removed
    bool is_timing = false;               ///< of sensors or inputs
    bool at_end = false;                  ///< a size ends at the end of what is plausible in the linearised model
};

/// A model linearised, with the candidates beside it, to be judged on data that were left out.
/// @param with_candidates false: the model alone
[[nodiscard]] LinearPrediction linear_beside(const ScoreTestData& score_data, const FittedHypothesis& now,
                                             const Covariance& noise, bool with_candidates);

/// All that may be added to a model, those first that the linearised model promises most of on data that were left out, but after all
/// others those that end at the end of what is plausible; of one cause at several trial sizes the best. A sensor's lag and its delay
/// are one addition, and so are the delays of all inputs: each alone stands for the other, and only both leave nothing. So are
/// the other errors of a sensor's readings, which are tried one by one as well.
/// @param linear as linear_beside gives it, with candidates
[[nodiscard]] std::vector<CauseGroup> additions_to(const ScoreTestData& score_data, const FittedHypothesis& now,
                                                   const LinearPrediction& linear);

/// A cause is dropped again when the model without it predicts no worse than by this share of the mean square.
inline constexpr double superfluous = 0.01;

/// What an addition removes, less what each of its numbers has to be worth.
[[nodiscard]] double worth_of(double removed, const FittedHypothesis& one);

/// Whether a model has a cause that is not in another in some form: two delays of inputs are not another cause than one of both.
[[nodiscard]] bool is_other(const ScoreTestData& score_data, const FittedHypothesis& one, const FittedHypothesis& best);

}  // namespace tiretherm::diagnosis
