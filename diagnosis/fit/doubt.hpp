// SPDX-License-Identifier: BSD-3-Clause
// What becomes of fitted parameters and their intervals where the model is in doubt: by noise that may be an error of it, by
// a parameter that is not as expected, by a model of the inputs.
#pragma once

#include <vector>

#include "diagnosis/fit/identification.hpp"
#include "solver/sensitivity/free_parameter.hpp"

namespace tiretherm::diagnosis {

/// Where the noise of a channel is in doubt (is_in_doubt), what was determined becomes doubtful, and the intervals are
/// widened by the largest ratio of a doubtful channel's noise to its data sheet's; where no data sheet says it, by
/// sqrt(10), as noise at the upper limit of its correlation time, a tenth of the longest run, may as well be as slow as
/// the run. What is farther off than three times the data sheet (is_missed, numbers_off) is in doubt at any number of samples,
/// and widens by its rms over the data sheet's. What is known before stays as sharp as it was: the part of the data alone is widened.
///
/// The ratio was compared with the scatter of the fit over blocks of the runs on 28 made-up sets of two nodes in which an
/// effect is missing: 95 % intervals held the two true scales in 9 % without either, in a quarter with the blocks and in
/// 55 % with the ratio. A missing effect moves all blocks together, so that they agree on a wrong value.
/// @param parameters [n_parameters]  @param into with its channels and intervals; out: `widened`, intervals and words
void widen_doubtful(const std::vector<solver::FreeParameter>& parameters, Identification& into);

/// A parameter of the model that is not as expected (parameter_findings) takes the place of something that the model lacks, which
/// moves the others as well: what was determined becomes doubtful. A start that is not as expected says nothing of the model.
/// @param unexpected one of the parameters of the fit
void doubt_beside(const solver::FreeParameter& unexpected, Identification& into);

/// A number of the model that computes inputs is never determined, but doubtful, and where the data move it a finding says why: the heat of sliding follows
/// slips that this model makes from forces, and their error moves the number. On cases/car, whose mass is known, it is found three
/// standard deviations off.
void doubt_input_numbers(const std::vector<solver::FreeParameter>& parameters, Identification& into);

}  // namespace tiretherm::diagnosis
