// SPDX-License-Identifier: BSD-3-Clause
// The wrong hypothesis that comes nearest to the hidden one, as a measure of how well data can tell them apart.
#pragma once

#include <optional>

#include "exam/exam_data_set_truth.hpp"

namespace hidden_effects {

/// The hypothesis that comes nearest to what a data set hides without being it: one cause of the catalogue, or two,
/// with physical signs and at the sizes that suit it best. What it misses is what data can hold against it: on average
/// half its square in log likelihood, with a standard deviation of itself.
/// @returns nothing where no cause shows
[[nodiscard]] std::optional<ConfoundedHypothesis> nearest_confounded(const ExamDataSet& data_set);

}  // namespace hidden_effects
