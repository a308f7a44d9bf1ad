// SPDX-License-Identifier: BSD-3-Clause
// Assessment of a finished fit: which parameters and combinations the data determine, their intervals, and how well
// each channel fits.
#pragma once

#include "diagnosis/fit/fit.hpp"
#include "diagnosis/fit/identification.hpp"

namespace tiretherm::diagnosis {

/// Which combinations the data see, which numbers, with which intervals.
/// @param searched whether a search has ended at these values: only then a bound says something
void assess_parameters(const Fit& fit, Identification& into, bool searched);

/// How each channel and each single number fits, and what is to be said about its noise. Before and after are known.
void assess_channels(const Fit& fit, Identification& into);

}  // namespace tiretherm::diagnosis
