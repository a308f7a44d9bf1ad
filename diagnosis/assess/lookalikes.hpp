// SPDX-License-Identifier: BSD-3-Clause
// Faults that these data cannot tell from a free number: a wrong scale of the load is another loss.
#pragma once

#include "diagnosis/assess/diagnosis.hpp"
#include "diagnosis/detect/score_test_data.hpp"

namespace tiretherm::diagnosis {

/// Causes whose signatures the free numbers make up, whatever was known of these before: correlated with them by 0.99 and more, or, at the
/// size that would bring a number back to what was known of it, less than two standard deviations from them. Wrong inputs first, then
/// the likest.
[[nodiscard]] std::vector<Lookalike> lookalikes_of(const ScoreTestData& score_data);

/// Where nothing is missing: a remark on at most two wrong inputs that would be a free number far from what was known of it.
void remark_on_lookalikes(Diagnosis& into);

}  // namespace tiretherm::diagnosis
