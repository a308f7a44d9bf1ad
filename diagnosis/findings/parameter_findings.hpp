// SPDX-License-Identifier: BSD-3-Clause
// What fitted parameters say about the model: far off what was known before, at a bound, or at a size that no
// tire engineer expects.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "diagnosis/remarks/remark.hpp"
#include "input/measurements/experiment.hpp"
#include "physics/plausible_ranges.hpp"

namespace tiretherm::diagnosis {

/// A fitted parameter of an experiment, in its own unit.
struct FittedParameter {
    double value = 0.0;
    /// By the information of data and prior together; infinite or NaN when the data do not determine it.
    double standard_deviation = 0.0;
    bool at_bound = false;  ///< the fit ended at the bound of what is allowed
};

/// How far a fit has moved a parameter from what was known before, in standard deviations of what was known: (fitted - prior) /
/// s_prior. The one measure of such a move that sentences state. If model and prior are right the move has the variance
/// s_prior^2 - s_fitted^2, so that a move beyond z of them is at most as likely as a normal number beyond z. 0 where nothing was
/// known before, or the data do not determine the parameter.
[[nodiscard]] double conflict_with_prior(const solver::FreeParameter& parameter, const FittedParameter& fitted);

/// A conflict is reported beyond so many standard deviations: 2.5, and more where so many parameters have a prior that one
/// of them would pass 2.5 by chance in more than one fit of twenty.
[[nodiscard]] double least_conflict(std::size_t n_with_prior);

/// The range in which a tire engineer expects a free parameter. @returns null where none is known, and where the value
/// before the fit lies outside already: then the case is about something else than the tires the range was made for
[[nodiscard]] const physics::PlausibleRange* plausible_range_of(const solver::Problem& problem,
                                                                const solver::FreeParameter& parameter, double before);

/// A parameter that is not as expected.
struct ParameterFinding {
    std::size_t parameter = 0;  ///< index into Experiment::parameters
    Remark remark;              ///< what is the matter, what it means and what to do
};

/// One for each parameter that is not as expected. A value beyond its plausible range counts when it is so by more than its
/// standard deviation.
/// @param fitted [n_parameters]  @param before [n_parameters] values of the case
[[nodiscard]] std::vector<ParameterFinding> parameter_findings(const input::Experiment& experiment,
                                                               const std::vector<FittedParameter>& fitted,
                                                               const std::vector<double>& before);

}  // namespace tiretherm::diagnosis
