// SPDX-License-Identifier: BSD-3-Clause
// A fitted cause as the result of a diagnosis has it.
#pragma once

#include "diagnosis/assess/diagnosis.hpp"
#include "diagnosis/assess/fitted_hypothesis.hpp"

namespace tiretherm::diagnosis {

/// One cause of a hypothesis, with its numbers in the intervals that the noise gives them.
/// @param i index into FittedHypothesis::candidates
[[nodiscard]] Cause describe_cause(const ScoreTestData& score_data, const FittedHypothesis& one, std::size_t i);

/// How many causes there are among the candidates, whatever sizes they were tried at.
[[nodiscard]] std::size_t n_causes(const ScoreTestData& score_data);

}  // namespace tiretherm::diagnosis
