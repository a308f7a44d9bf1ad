// SPDX-License-Identifier: BSD-3-Clause
// Hypotheses that grow and shrink by one cause, fitted with a noise of the caller's choice.
#pragma once

#include "diagnosis/assess/fitted_hypothesis.hpp"

namespace tiretherm::diagnosis {

/// A hypothesis with one cause more, fitted from where it stands. Sizes stay within what is plausible; one that ends at the
/// end of that is not admissible. @param candidate index into ScoreTestData::candidates
[[nodiscard]] FittedHypothesis extended(ScoreTestData& score_data, const FittedHypothesis& from, std::size_t candidate,
                                        const Covariance& noise);
/// The same with one cause less. @param cause index into `from.candidates`
[[nodiscard]] FittedHypothesis reduced(ScoreTestData& score_data, const FittedHypothesis& from, std::size_t cause,
                                       const Covariance& noise);
/// The same causes fitted anew, with another noise.
[[nodiscard]] FittedHypothesis refitted(ScoreTestData& score_data, const FittedHypothesis& from,
                                        const Covariance& noise);
/// The case with the numbers that it has, linearised there; not fitted.
[[nodiscard]] FittedHypothesis as_it_stands(ScoreTestData& score_data, const Covariance& noise);

/// The correlated noise beside a hypothesis, by restricted maximum likelihood, whatever the candidates could still explain.
[[nodiscard]] Covariance noise_beside(ScoreTestData& score_data, const FittedHypothesis& hypothesis);
/// Scores of all candidates beside a hypothesis, with signatures taken at the base model.
[[nodiscard]] Scores scores_beside(const ScoreTestData& score_data, const FittedHypothesis& hypothesis,
                                   const Covariance& noise);

/// Share of the mean square on data that were left out that an extension removes, to first order and the mean over
/// channels: both models' numbers move along their slopes.
[[nodiscard]] double linear_gain(const ScoreTestData& score_data, const FittedHypothesis& before,
                                 const FittedHypothesis& after);

}  // namespace tiretherm::diagnosis
