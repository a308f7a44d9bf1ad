// SPDX-License-Identifier: BSD-3-Clause
// What faults of instruments and logs that nobody named leave in doubt of fitted numbers: they are alike in all data, so that
// no scatter within these data shows them.
#pragma once

#include <vector>

#include "diagnosis/assess/diagnosis_state.hpp"

namespace tiretherm::diagnosis {

/// Standard deviations of a model's numbers by the candidates of sensors and inputs that are not in it, each anywhere in its plausible
/// range but likeliest right (Joint Committee for Guides in Metrology, JCGM 100:2008, 4.3.9: a triangular distribution), as far as the
/// data leave that open:
///     diag(G (Z'Z + diag(1 / s^2) - Z'S G)^-1 G'),  G = (S'S + Pi)^-1 S'Z,
/// with S the slopes of the numbers and Z those of the candidates, whitened, and s^2 the mean square of a candidate's distance to where
/// it changes nothing.
/// @param on candidates that are in the model: indices into ScoreTestData::candidates
/// @returns [n] in the unit of each number; 0 at a bound
[[nodiscard]] Eigen::VectorXd deviations_by_instruments(const ScoreTestData& score_data, const Refit& fit,
                                                        const std::vector<std::size_t>& on);

/// Widens the intervals of the free numbers and of the sizes of what the model is extended with by these, in quadrature, where an
/// instrument is found to be wrong, for others may be, too, or something is missing and the model is in doubt.
void widen_by_instruments(const DiagnosisState& state, Diagnosis& into);

}  // namespace tiretherm::diagnosis
