// SPDX-License-Identifier: BSD-3-Clause
// Hypotheses that grow and shrink by one cause, fitted with a noise of the caller's choice.
#pragma once

#include "diagnosis/assess/fitted_hypothesis.hpp"

namespace tiretherm::diagnosis {

/// A hypothesis with some causes more, fitted from where it stands. Sizes stay within what is plausible; one that ends at the
/// end of that is not admissible. Of several causes those that end where they change nothing are left out again.
/// @param added indices into ScoreTestData::candidates  @param amplitudes where they start, as differences to `absent`
[[nodiscard]] FittedHypothesis extended(const ScoreTestData& score_data, const FittedHypothesis& from,
                                        const std::vector<std::size_t>& added, const std::vector<double>& amplitudes,
                                        const Covariance& noise);
/// The same with one cause less. @param cause index into `from.candidates`
[[nodiscard]] FittedHypothesis reduced(const ScoreTestData& score_data, const FittedHypothesis& from, std::size_t cause,
                                       const Covariance& noise);
/// The same causes fitted anew, with another noise.
[[nodiscard]] FittedHypothesis refitted(const ScoreTestData& score_data, const FittedHypothesis& from,
                                        const Covariance& noise);
/// The case with the numbers that it has, linearised there; not fitted.
[[nodiscard]] FittedHypothesis as_it_stands(const ScoreTestData& score_data, const Covariance& noise);

}  // namespace tiretherm::diagnosis
